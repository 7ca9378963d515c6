//! All broad phases with each kind of tag, their queries, and events of pairs.
#![cfg_attr(target_os = "none", no_std, no_main)]
use tilesat::broad::{
    Border, BroadHit, BroadPhase, BruteForce, Exceptions, Handle, Ignore, Keyed, LooseGrid, Nearest, Pair, PairCursor,
    PairEvent, PairEvents, SortSweep, SpatialHash,
};
use tilesat::heapless::VecView;
use tilesat::{Aabb, Filter, Fx, Toi, Vec2};
use tilesat_flash::keep;

macro_rules! broad {
    ($($tag:ty: $($phase:ty),+;)+) => {
        $($(keep! {
            |b: &mut $phase, bounds: &Aabb, tag: $tag| b.insert(bounds, tag);
            |b: &mut $phase, h: Handle, bounds: &Aabb| b.move_to(h, bounds);
            |b: &mut $phase, to: fn(Handle, &Aabb) -> Aabb| b.move_each(to);
            |b: &mut $phase, h: Handle| b.remove(h);
            |b: &$phase, h: Handle| b.contains(h);
            |b: &$phase, h: Handle| b.bounds(h);
            |b: &$phase, h: Handle| b.tag(h);
            |b: &mut $phase, h: Handle, tag: $tag| b.set_tag(h, tag);
            |b: &$phase| (b.len(), b.is_empty());
            |b: &mut $phase, each: fn(Pair)| b.pairs(each);
            |b: &mut $phase, at: &mut PairCursor, budget: u32, out: &mut VecView<Pair>| b.pairs_from(at, budget, out);
            |b: &mut $phase, out: &mut VecView<Pair>| b.pairs_sorted(out);
            |b: &mut $phase, movers: &[Handle], each: fn(Pair)| b.pairs_of(movers, each);
            |b: &$phase, region: &Aabb, each: fn(Handle)| b.in_region(region, each);
            |b: &$phase, p: Vec2, each: fn(Handle)| b.at_point(p, each);
            |b: &$phase, region: &Aabb, out: &mut VecView<Handle>| b.collect_region(region, out);
            |b: &$phase, p: Vec2, within: Fx, wanted: fn(Handle, &$tag) -> bool| b.nearest(p, within, wanted);
            |b: &$phase, p: Vec2, within: Fx, wanted: fn(Handle, &$tag) -> bool, out: &mut VecView<Nearest>| {
                b.neighbours(p, within, wanted, out)
            };
            |b: &$phase, start: &Aabb, d: Vec2, each: fn(Handle, &$tag, Toi) -> Toi| b.along(start, d, each);
            |b: &$phase, o: Vec2, d: Vec2, wanted: fn(Handle, &$tag) -> bool, out: &mut VecView<BroadHit>| {
                b.cast_ray(o, d, wanted, out)
            };
            |b: &$phase, start: &Aabb, d: Vec2, wanted: fn(Handle, &$tag) -> bool, out: &mut VecView<BroadHit>| {
                b.cast_shape(start, d, wanted, out)
            };
        })+)+
    };
}

fn makers() {
    keep! {
        |_any: u8| BruteForce::<64>::new();
        |_any: u8| BruteForce::<64, Filter>::default();
        |_any: u8| SortSweep::<64>::new();
        |_any: u8| SortSweep::<300, Filter>::default();
        |origin: Vec2, cell: Fx, columns: u16| LooseGrid::<24, 64>::new(origin, cell, columns);
        |origin: Vec2, cell: Fx, columns: u16| LooseGrid::<24, 300, Keyed<Filter>, true>::new(origin, cell, columns);
        |grid: LooseGrid<24, 64>, border: Border| grid.with_border(border);
        |cell: Fx| SpatialHash::<64, 64>::new(cell);
        |cell: Fx| SpatialHash::<64, 300, Keyed<Filter>, true>::new(cell);
        |h: Handle| (h.slot(), h.generation());
        |a: Handle, b: Handle| (a.cmp(&b), a < b);
        |a: Pair, b: Pair| (a.cmp(&b), a < b);
        |_any: u8| PairCursor::new();
    }
}

fn brute() {
    broad! {
        (): BruteForce<64>, BruteForce<1>, BruteForce<0>;
        Filter: BruteForce<64, Filter>;
        Keyed<Filter>: BruteForce<300, Keyed<Filter>>;
    }
}

fn sweep() {
    broad! {
        (): SortSweep<64>, SortSweep<1>, SortSweep<0>;
        Filter: SortSweep<64, Filter>;
        Keyed<Filter>: SortSweep<300, Keyed<Filter>>;
    }
}

fn grid() {
    broad! {
        (): LooseGrid<24, 64>, LooseGrid<1, 1>;
        Filter: LooseGrid<24, 64, Filter>;
        Keyed<Filter>: LooseGrid<24, 300, Keyed<Filter>, true>;
    }
}

fn hash() {
    broad! {
        (): SpatialHash<64, 64>, SpatialHash<64, 1>;
        Filter: SpatialHash<64, 64, Filter>;
        Keyed<Filter>: SpatialHash<64, 300, Keyed<Filter>, true>;
    }
}

macro_rules! events {
    ($($n:literal: $pair:ty),+) => {
        $(keep! {
            |_any: u8| PairEvents::<$n, $pair>::new();
            |e: &mut PairEvents<$n, $pair>, pair: $pair| e.feed(pair);
            |e: &mut PairEvents<$n, $pair>, held: fn(&$pair) -> bool| e.finish(held);
            |e: &PairEvents<$n, $pair>| e.iter().map(|event| core::hint::black_box(event)).count();
            |e: &mut PairEvents<$n, $pair>| e.cancel();
            |e: &PairEvents<$n, $pair>| e.pairs().map(|pair| core::hint::black_box(pair)).count();
            |e: &PairEvents<$n, $pair>, pair: $pair| e.contains(pair);
        })+
    };
}

macro_rules! exceptions {
    ($($n:literal),+) => {
        $(keep! {
            |_any: u8| Exceptions::<$n>::new();
            |e: &mut Exceptions<$n>, a: Handle, b: Handle, ignore: Ignore| e.ignore(a, b, ignore);
            |e: &mut Exceptions<$n>, a: Handle, b: Handle| e.allow(a, b);
            |e: &mut Exceptions<$n>, pair: Pair| e.passes(pair);
            |e: &mut Exceptions<$n>, present: fn(Handle) -> bool, held: fn(&Pair) -> bool| e.finish(present, held);
            |e: &Exceptions<$n>| e.iter().map(|exception| core::hint::black_box(exception)).count();
        })+
    };
}

fn told() {
    events!(64: Pair, 1: Pair, 0: Pair, 16: u32);
    keep! {
        |e: &PairEvent<Pair>| e.pair();
        |e: &PairEvent<u32>| e.pair();
    }
    exceptions!(8, 1, 0);
}

tilesat_flash::everything!(makers, brute, sweep, grid, hash, told);
