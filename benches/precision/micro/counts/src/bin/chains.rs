//! Prints the cost of building maps of segments at run time: the host's chains of slopes. Runs on
//! mps2-an385, which has the memory and the longer clock.

#![no_std]
#![no_main]

use core::hint::black_box;
use core::ptr::addr_of_mut;
use tilesat::{Fx, Path, PathKind, SegmentMap, Vec2};
use tilesat_chip::{entry, eprintln, println, process};
use tilesat_counts::clock::{Clock, Long};
use tilesat_counts::counter::Counter;

const LARGEST: usize = 10_000;
/// Bytes for the largest map.
const ROOM: usize = 1 << 20;

static mut POINTS: [Vec2; LARGEST + 1] = [Vec2::ZERO; LARGEST + 1];
static mut MAP: [u8; ROOM] = [0; ROOM];

/// The generator of the judges, which is seeded alike (`tests/support/src/random`).
struct Random(u64);

impl Random {
    fn within(&mut self, low: i64, high: i64) -> i64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        low + ((u128::from(z ^ (z >> 31)) * (high - low + 1) as u128) >> 64) as i64
    }
}

/// The chain of `levels/build.rs`.
fn chain(points: &mut [Vec2]) {
    let (mut r, mut at, mut ahead) = (Random(0xb11d), (-4000i64 << 16, -4000i64 << 16), 1);
    for (k, point) in points.iter_mut().enumerate() {
        if k > 0 {
            let x = at.0 + ahead * r.within(1 << 16, 3 << 15);
            at = if x.abs() < 4000 << 16 {
                (x, (at.1 >> 19 << 19) + r.within(0, 1 << 17))
            } else {
                ahead = -ahead;
                (at.0, at.1 + (8 << 16))
            };
        }
        *point = Vec2::from_raw(at.0 as i32, at.1 as i32);
    }
}

#[entry]
fn main() -> ! {
    let counter = Counter::<Long>::start();
    // SAFETY: one thread, and no other reference.
    let (points, map) = unsafe { (&mut *addr_of_mut!(POINTS), &mut *addr_of_mut!(MAP)) };
    chain(points);
    for n in [10, 100, 1_000, LARGEST] {
        let paths = [Path::new(PathKind::Wall, &points[..=n])];
        let from = Long::now();
        let built = SegmentMap::build_into(black_box(&paths), Fx::lit("32"), map);
        let ticks = Long::elapsed(from, Long::now());
        if !built.is_ok_and(|bytes| SegmentMap::from_bytes(&map[..bytes]).is_ok()) {
            eprintln!("{n} segments: not built");
            process::exit(1);
        }
        println!("building of a segment map|{n} segments|tilesat|build|{}||", counter.instructions(ticks));
    }
    process::exit(0)
}
