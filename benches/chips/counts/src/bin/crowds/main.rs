//! Rows of broad phases. A frame moves all bodies and enumerates all pairs.
//!
//! The boxes of the frame are ready. The counts include the calls that pass them, but not the
//! game's work to find them. Runs on mps2-an385, which also runs code for the Cortex-M0.

#![no_std]
#![no_main]

mod crowd;
mod regular;

use core::hint::black_box;
use crowd::{Crowd, World};
use regular::Regular;
use tilesat::broad::{BroadPhase, BruteForce, GridError, Handle, LooseGrid, SortSweep, SpatialHash, Tag};
use tilesat::{Aabb, Filter, Fx, Vec2};
use tilesat_chip::{entry, eprintln, process};
use tilesat_counts::CORE;
use tilesat_counts::clock::Long;
use tilesat_counts::counter::Counter;
use tilesat_counts::measure::{Budget, tell};
use tilesat_counts::span::Span;

type Timer = Counter<Long>;

#[entry]
fn main() -> ! {
    let timer = &Timer::start();
    let mut wrong = 0;
    all::<8, 1, 64>(timer, &mut wrong);
    all::<16, 2, 64>(timer, &mut wrong);
    all::<32, 4, 64>(timer, &mut wrong);
    all::<64, 8, 128>(timer, &mut wrong);
    all::<128, 16, 256>(timer, &mut wrong);
    all::<256, 32, 512>(timer, &mut wrong);
    all::<512, 64, 1024>(timer, &mut wrong);
    all::<1024, 128, 2048>(timer, &mut wrong);
    all::<2048, 256, 4096>(timer, &mut wrong);
    process::exit(i32::from(wrong != 0))
}

/// Every structure in every world, with N bodies. A block is 32 cells of 32 x 32 units. Each body
/// has 4 of them, if there is room for all.
#[inline(never)]
fn all<const N: usize, const BLOCKS: usize, const BUCKETS: usize>(timer: &Timer, wrong: &mut u32) {
    for world in World::ALL {
        let brute = row::<N, _, _>(timer, "brute", world, BruteForce::<N>::new, BruteForce::<N, Filter>::new);
        let others = [
            row::<N, _, _>(timer, "sweep", world, SortSweep::<N>::new, SortSweep::<N, Filter>::new),
            match world {
                World::Fixed => row::<N, _, _>(timer, "grid", world, grid::<24, N, _, 5>, grid::<24, N, _, 5>),
                World::Cluster => row::<N, _, _>(timer, "grid", world, grid::<2, N, _, 3>, grid::<2, N, _, 3>),
                World::Density => {
                    // Cells are half as wide as a body's square. The world is square, or twice as
                    // wide as high.
                    row::<N, _, _>(timer, "grid", world, square_grid::<BLOCKS, N, _>, square_grid::<BLOCKS, N, _>)
                }
            },
            row::<N, _, _>(timer, "hash", world, hash::<BUCKETS, N, _>, hash::<BUCKETS, N, _>),
        ];
        let same = world != World::Fixed || regular_row::<N>(timer) == brute[0];
        if others != [brute; 3] || !same {
            *wrong += 1;
            eprintln!("{N} bodies, {}: the pairs differ", world.name());
        }
    }
}

const CELL: Fx = Fx::lit("32");

fn grid<const BLOCKS: usize, const N: usize, T: Tag, const LOG: u16>() -> LooseGrid<BLOCKS, N, T> {
    must(LooseGrid::new(Vec2::ZERO, CELL, 1 << LOG))
}

fn square_grid<const BLOCKS: usize, const N: usize, T: Tag>() -> LooseGrid<BLOCKS, N, T> {
    must(LooseGrid::new(Vec2::ZERO, CELL, 2 << N.ilog2().div_ceil(2)))
}

fn hash<const BUCKETS: usize, const N: usize, T: Tag>() -> SpatialHash<BUCKETS, N, T> {
    must(SpatialHash::new(CELL))
}

fn must<T>(made: Result<T, GridError>) -> T {
    made.unwrap_or_else(|error| {
        eprintln!("{error}");
        process::exit(70)
    })
}

/// Budget of instructions per frame on a Cortex-M0, without filters.
fn budget(name: &str, bodies: usize, world: World) -> Budget {
    let most = match (name, bodies) {
        _ if world != World::Fixed => return None,
        ("brute", 8) => 600,
        ("sweep", 16) => 1_550,
        ("sweep", 64) => 7_700,
        ("sweep", 256) => 51_400,
        ("grid", 512) => 125_600,
        ("grid", 2048) => 970_000,
        _ => return None,
    };
    Some((most, 0))
}

/// Prints a row. Returns a number that identifies the pairs, to compare with another structure.
#[inline(never)]
fn row<const N: usize, A, B>(timer: &Timer, name: &str, world: World, plain: fn() -> A, masked: fn() -> B) -> [u32; 2]
where
    A: BroadPhase<Tag = ()>,
    B: BroadPhase<Tag = Filter>,
{
    let (first, pairs) = frames::<N, A>(timer, world, plain(), (), each);
    let (second, masked_pairs) = frames::<N, B>(timer, world, masked(), Filter::default(), by_handle);
    if world == World::Fixed && CORE == "M0" {
        tell("size", format_args!("{name}, {N} bodies"), size_of::<A>(), None);
        tell("size, filters", format_args!("{name}, {N} bodies"), size_of::<B>(), None);
    }
    let row = format_args!("{name}, {N} bodies, {}", world.name());
    tell("pairs", row, first, budget(name, N, world));
    tell("pairs, filters", row, second, None);
    [pairs, masked_pairs]
}

/// The row of the grid that the library does not have.
#[inline(never)]
fn regular_row<const N: usize>(timer: &Timer) -> u32 {
    let (mut pairs, mut span) = (0, Span::EMPTY);
    let Ok(blank) = Aabb::new(Vec2::ZERO, Vec2::ZERO) else { return 0 };
    let (mut crowd, mut grid) = (Crowd::<N>::new(World::Fixed, blank), Regular::<N>::new(blank));
    for round in 0..rounds(N) + WARM {
        crowd.step();
        let counted = timer.count(|| grid.frame(&crowd.boxes, |a, b| pairs += ((a.min(b) << 12) ^ a.max(b)) as u32));
        if round >= WARM {
            span.add(counted);
        }
    }
    tell("pairs", format_args!("regular, {N} bodies, fixed"), span, None);
    pairs
}

/// Frames that settle the order before the counted ones.
const WARM: u32 = 4;

fn rounds(bodies: usize) -> u32 {
    if bodies <= 256 { 32 } else { 8 }
}

type Frame<B, const N: usize> = fn(&mut B, &[Handle; N], &[Aabb; N]) -> u32;

/// Settles the order in some frames, then counts some. Returns the instructions of one, and a
/// number that identifies the pairs.
#[inline(never)]
fn frames<const N: usize, B: BroadPhase>(
    timer: &Timer,
    world: World,
    mut near: B,
    tag: B::Tag,
    frame: Frame<B, N>,
) -> (Span, u32) {
    let mut pairs = 0;
    let mut span = Span::EMPTY;
    let Ok(blank) = Aabb::new(Vec2::ZERO, Vec2::ZERO) else { return (span, 0) };
    let mut crowd = Crowd::<N>::new(world, blank);
    let Some(mut handles) = near.insert(&blank, tag).ok().map(|first| [first; N]) else { return (span, 0) };
    for handle in handles.iter_mut().skip(1) {
        *handle = near.insert(&blank, tag).unwrap_or(*handle);
    }
    for round in 0..rounds(N) + WARM {
        crowd.step();
        let (frame, nothing) = black_box((frame, nothing::<B, N> as Frame<B, N>));
        let counted = timer.count(|| pairs += frame(&mut near, &handles, &crowd.boxes));
        let empty = timer.count(|| pairs += nothing(&mut near, &handles, &crowd.boxes));
        if round >= WARM {
            span.add(counted - empty);
        }
    }
    (span, pairs)
}

#[inline(never)]
fn nothing<B, const N: usize>(_: &mut B, _: &[Handle; N], _: &[Aabb; N]) -> u32 {
    // SAFETY: no instruction at all. It only keeps the call.
    unsafe { core::arch::asm!("", options(nomem, nostack, preserves_flags)) };
    0
}

/// All bodies in one call.
#[inline(never)]
fn each<B: BroadPhase, const N: usize>(near: &mut B, _: &[Handle; N], boxes: &[Aabb; N]) -> u32 {
    let moved = near.move_each(|body, bounds| *boxes.get(body.slot()).unwrap_or(bounds));
    sum(near) + u32::from(moved.is_err())
}

/// Each body by its handle.
#[inline(never)]
fn by_handle<B: BroadPhase, const N: usize>(near: &mut B, handles: &[Handle; N], boxes: &[Aabb; N]) -> u32 {
    let mut refused = 0;
    for (&handle, bounds) in handles.iter().zip(boxes) {
        refused += u32::from(near.move_to(handle, bounds).is_err());
    }
    sum(near) + refused
}

/// Uses both handles of every pair.
#[inline(always)]
fn sum<B: BroadPhase>(near: &mut B) -> u32 {
    let mut sum = 0;
    near.pairs(|pair| sum += ((pair.a.slot() << 12) ^ pair.b.slot()) as u32);
    sum
}
