//! Prints the costs of rays through grids.

#![no_std]
#![no_main]

use tilesat_chip::entry;
use tilesat_precision_counts::{Query, Short, Table};
use tilesat_precision_queries::*;

static INPUTS: &[u8] = include_bytes!(concat!(env!("PRECISION_INPUTS"), "/rays.bin"));

/// The cells of the three maps.
static CELLS: &[u8; 3 << 16] = include_bytes!(concat!(env!("PRECISION_INPUTS"), "/cells.bin"));

fn cells(workload: &str) -> &'static [u8] {
    let map = match workload {
        "rays: room 5 %" => 0,
        "rays: platformer 20 %" => 1,
        _ => 2,
    };
    &CELLS[map << 16..][..1 << 16]
}

#[entry]
fn main() -> ! {
    let mut table = Table::<Short>::start(INPUTS);
    macro_rules! count {
        ($workload:literal, $backend:literal, $map:ty, $start:ty, $out:ty, |$r:ident| $ask:expr, |$o:ident| $hit:expr) => {{
            let map = <$map as Map>::of(cells($workload));
            let query: Query<Ray<'_, $map, $start>, $out> = |$r, out| {
                out.write($ask);
            };
            table.row(($workload, $backend, "ray"), |words| Ray::of(&map, words), query, |$o| $hit);
        }};
    }
    each_ray!(count);
    table.end()
}
