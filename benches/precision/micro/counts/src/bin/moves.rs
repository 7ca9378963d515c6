//! Prints the costs of frames of moving bodies. Runs on mps2-an385 and mps2-an386, which have the
//! longer clock.

#![no_std]
#![no_main]

use tilesat_chip::entry;
use tilesat_precision_counts::{Long, Query, Table, room};
use tilesat_precision_queries::*;

static INPUTS: &[u8] = include_bytes!(concat!(env!("PRECISION_INPUTS"), "/moves.bin"));
static LEVELS: &[u8] = include_bytes!(concat!(env!("PRECISION_INPUTS"), "/levels.bin"));

#[entry]
fn main() -> ! {
    let mut table = Table::<Long>::start(INPUTS);
    macro_rules! count {
        ($workload:literal, $kind:literal, $backend:literal, $asked:literal, $level:ty, $body:ty, $motion:ty, |$s:ident| $ask:expr) => {
            for class in table.classes($workload).filter(|c| c.name.starts_with($kind)) {
                let room = room(LEVELS, &class);
                let tiles = <$level as Level>::tiles(&room);
                let level = <$level as Level>::of(&room, &tiles);
                let query: Query<Step<'_, $level, $body, $motion>, $body> = |$s, out| {
                    out.write($ask);
                };
                table.moves(($workload, $backend, $asked), &class, &level, query);
            }
        };
    }
    each_move!(count);
    table.end()
}
