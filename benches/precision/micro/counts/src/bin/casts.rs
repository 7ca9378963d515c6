//! Prints the costs of casts of shapes.

#![no_std]
#![no_main]

use tilesat_chip::entry;
use tilesat_precision_counts::{Query, Short, Table};
use tilesat_precision_queries::*;

static INPUTS: &[u8] = include_bytes!(concat!(env!("PRECISION_INPUTS"), "/casts.bin"));

#[entry]
fn main() -> ! {
    let mut table = Table::<Short>::start(INPUTS);
    macro_rules! count {
        ($workload:literal, $backend:literal, $asked:literal, $in:ty, $out:ty, |$p:ident| $ask:expr, |$o:ident| $hit:expr) => {{
            let query: Query<$in, $out> = |$p, out| {
                out.write($ask);
            };
            table.row(($workload, $backend, $asked), <$in as Input>::of, query, |$o| $hit);
        }};
    }
    each_cast!(count);
    table.end()
}
