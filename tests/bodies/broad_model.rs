//! Compares every broad phase with a list of boxes: random operations, and small scenes
//! exhaustively.
//!
//! `TILESAT_CASES` sets the number of random sequences (default 3000).

use heapless::Vec as Room;
use proptest::prelude::*;
use proptest::test_runner::TestRunner;
use tilesat::broad::{BroadHit, Handle, Nearest, Pair, PairCursor, QueryError};
use tilesat::{Fx, Toi};
use tilesat_judge::broad::near::Near;
use tilesat_judge::broad::reference::{DOMAIN, Rect, root};
use tilesat_judge::broad::script::{At, Op, Play, Shape};
use tilesat_judge::broad::{Cells, Check, Large, Mark, aabb, everywhere, vec2};

fn cases() -> u32 {
    tilesat_judge::cases(3_000)
}

/// Quarters of a cell, mostly near each other, and at most 2 raw off: on the lines of cells and
/// close to them.
fn at() -> impl Strategy<Value = At> {
    (prop_oneof![4 => 0i64..16, 2 => -8i64..72, 1 => -400i64..400], -2i64..=2)
}

fn shape() -> impl Strategy<Value = Shape> {
    let size = || prop_oneof![12 => 0usize..7, 1 => 7usize..9];
    (at(), at(), size(), size())
}

fn op() -> impl Strategy<Value = Op> {
    let (which, room, team) = (|| 0usize..64, || 0usize..6, || 0u8..4);
    let step = (0u32..30, 1usize..5, prop::option::weighted(0.4, which()), prop::option::weighted(0.05, which()));
    prop_oneof![
        10 => (shape(), 0u32..6, team()).prop_map(|(shape, key, team)| Op::Insert(shape, key, team)),
        4 => (which(), shape()).prop_map(|(which, shape)| Op::Move(which, shape)),
        2 => (-6i64..=6, -2i64..=2).prop_flat_map(|x| (Just(x), (-6i64..=6, -2i64..=2))).prop_map(|(x, y)| Op::MoveEach(x, y)),
        2 => which().prop_map(Op::Remove),
        1 => (which(), 0u32..6, team()).prop_map(|(which, key, team)| Op::SetTag(which, key, team)),
        1 => Just(Op::Save),
        1 => Just(Op::Restore),
        4 => Just(Op::Pairs),
        2 => room().prop_map(Op::Sorted),
        3 => prop::collection::vec(step, 0..20).prop_map(Op::From),
        2 => prop::collection::vec(which(), 0..12).prop_map(Op::Of),
        2 => (shape(), room()).prop_map(|(shape, room)| Op::Region(shape, room)),
        1 => (at(), at()).prop_map(|(x, y)| Op::Point(x, y)),
        2 => (at(), at(), at(), team(), room()).prop_map(|(x, y, within, team, room)| Op::Near(x, y, within, team, room)),
        2 => (at(), at(), at(), at(), team(), room())
            .prop_map(|(x, y, dx, dy, team, room)| Op::Ray(x, y, dx, dy, team, room)),
        2 => (shape(), at(), at(), team(), room())
            .prop_map(|(shape, dx, dy, team, room)| Op::Cast(shape, dx, dy, team, room)),
    ]
}

/// Cells of 2 raw to 4096 units, at the middle, at the ends of the domain and far outside the grid.
fn cells() -> impl Strategy<Value = Cells> {
    let origin =
        || prop_oneof![Just(0), Just(-1), Just(-(1 << 29) + 1), Just((1 << 29) - 1), Just(1000 << 16), -99_999..99_999];
    (prop_oneof![Just(2u32), Just(3), Just(8), Just(21), Just(26), 1u32..=28], origin(), origin())
        .prop_map(|(log, x, y)| Cells { side: 1 << log, origin: (x, y) })
}

struct Script<'a> {
    cells: Cells,
    ops: &'a [Op],
    pairs: u64,
    hits: u64,
}

impl Check for Script<'_> {
    fn on(&mut self, name: &str, limit: Option<i32>, empty: &Near<Mark>) {
        let mut play = Play::new(name, limit, self.cells, empty);
        for op in self.ops {
            play.play(op);
        }
        play.look();
        self.pairs += play.pairs;
        self.hits += play.hits;
    }
}

#[test]
fn random_operations() {
    let mut runner =
        TestRunner::new(ProptestConfig { cases: cases(), failure_persistence: None, ..ProptestConfig::default() });
    let (mut pairs, mut hits) = (0, 0);
    let tallies = std::cell::RefCell::new((&mut pairs, &mut hits));
    runner
        .run(&(cells(), prop::collection::vec(op(), 0..120)), |(cells, ops)| {
            let mut script = Script { cells, ops: &ops, pairs: 0, hits: 0 };
            everywhere(24, cells, &mut script);
            let mut tallies = tallies.borrow_mut();
            *tallies.0 += script.pairs;
            *tallies.1 += script.hits;
            Ok(())
        })
        .unwrap();
    println!("{pairs} pairs, {hits} hits");
    assert!(pairs > 20 * u64::from(cases()) && hits > 20 * u64::from(cases()), "{pairs} pairs, {hits} hits");
}

/// Two boxes in all positions to each other and to the cells, of 4 raw, near all borders of the
/// grid.
struct TwoBoxes(u64);

impl Check for TwoBoxes {
    fn on(&mut self, name: &str, _: Option<i32>, empty: &Near<Mark>) {
        let mut phase = empty.clone();
        let unit = aabb((0, 0), (0, 0));
        let [a, b] = [1, 2].map(|key| phase.insert(&unit, Mark::new(key, 0)).unwrap());
        let around = || [-2, 0, 2, 13].into_iter().flat_map(|cell| (0..4).map(move |i| 4 * cell + i));
        for (x, w) in around().flat_map(|x| [0, 1, 3, 4].map(|w| (x, w))) {
            for (y, h) in [(0, 0), (3, 4), (30, 1)] {
                let one = aabb((x, y), (x + w, y + h));
                phase.move_to(a, &one).unwrap();
                for (dx, dw) in (-6..=6).flat_map(|dx| [0, 1, 4].map(|dw| (dx, dw))) {
                    for (dy, dh) in (-6..=6).flat_map(|dy| [0, 3, 4].map(|dh| (dy, dh))) {
                        let (u, v) = (x + dx, y + dy);
                        let other = aabb((u, v), (u + dw, v + dh));
                        phase.move_to(b, &other).unwrap();
                        let mut pairs = 0;
                        phase.pairs(|pair| {
                            assert_eq!((pair.a, pair.b), (a, b));
                            pairs += 1;
                        });
                        let touch = Rect::of(&one).touches(&Rect::of(&other));
                        assert_eq!(pairs, i32::from(touch), "{name}: {one:?} {other:?}");
                        self.0 += u64::from(touch);
                    }
                }
            }
        }
    }
}

#[test]
fn two_boxes_everywhere() {
    for origin in [(0, 0), (-3, -2)] {
        let mut check = TwoBoxes(0);
        everywhere(2, Cells { side: 4, origin }, &mut check);
        assert!(check.0 > 100_000, "{} pairs", check.0);
    }
}

/// Five boxes in cells of 4 raw, and all rays and motions on the lattice around them.
struct Ways {
    size: i64,
    hits: u64,
}

impl Check for Ways {
    fn on(&mut self, name: &str, limit: Option<i32>, empty: &Near<Mark>) {
        let mut phase = empty.clone();
        let mut boxes =
            vec![((0, 0), (3, 1)), ((4, 4), (4, 4)), ((7, -2), (9, 2)), ((-5, 3), (-2, 7)), ((5, 8), (9, 8))];
        if limit.is_none() {
            boxes.push(((2, 6), (13, 7)));
        }
        let boxes: Vec<_> = boxes
            .iter()
            .zip(0..)
            .map(|((lo, hi), key)| {
                let bounds = aabb(*lo, *hi);
                (key, phase.insert(&bounds, Mark::new(key, 0)).unwrap(), Rect::of(&bounds))
            })
            .collect();
        for (x, y) in (-7..=11).flat_map(|x| (-4..=10).map(move |y| (x, y))) {
            let start = aabb((x, y), (x + self.size, y + self.size / 2));
            for d in (-14..=14).flat_map(|dx| (-9..=9).map(move |dy| (dx, dy))) {
                let mut hits = Room::<BroadHit, 8>::new();
                if self.size == 0 {
                    phase.cast_ray(start.min(), vec2(d), |_, _| true, &mut hits).unwrap();
                } else {
                    phase.cast_shape(&start, vec2(d), |_, _| true, &mut hits).unwrap();
                }
                let touch = |(key, handle, rect): &(u32, _, Rect)| {
                    Some((Rect::of(&start).first_touch(d, rect)?, *key, *handle))
                };
                let mut expected: Vec<_> = boxes.iter().filter_map(touch).collect();
                expected.sort_unstable();
                let told = hits.iter().map(|hit| (hit.toi.raw(), hit.handle));
                assert!(told.eq(expected.iter().map(|hit| (hit.0, hit.2))), "{name}: {start:?} by {d:?}: {hits:?}");
                self.hits += hits.len() as u64;
            }
        }
    }
}

#[test]
fn all_small_ways() {
    for (size, origin) in [(0, (0, 0)), (0, (-9, 2)), (3, (1, 1)), (9, (-2, -2))] {
        let mut check = Ways { size, hits: 0 };
        everywhere(6, Cells { side: 4, origin }, &mut check);
        assert!(check.hits > 100_000, "{} hits", check.hits);
    }
}

/// Checks the reference itself. It reports a touch exactly if some moment of a fine division
/// touches, and at its time.
#[test]
fn the_reference() {
    let b = Rect { lo: (2, -1), hi: (5, 1) };
    for (w, (x, y)) in [0, 2].into_iter().flat_map(|w| (-6..=8).flat_map(move |x| (-5..=5).map(move |y| (w, (x, y))))) {
        for d in (-7..=7).flat_map(|dx| (-7..=7).map(move |dy| (dx, dy))) {
            // In units of 1/840, in which all quotients by 1 to 8 are whole.
            let scale = |r: Rect, by: i64| Rect { lo: (r.lo.0 * by, r.lo.1 * by), hi: (r.hi.0 * by, r.hi.1 * by) };
            let a = Rect { lo: (x, y), hi: (x + w, y + w) };
            let (big, other) = (scale(a, 840), scale(b, 840));
            let moment = (0..=840).find(|t| big.moved((d.0 * t, d.1 * t)).touches(&other));
            let told = a.first_touch(d, &b);
            assert_eq!(told, moment.map(|t| ((t << 30) / 840) as u32), "{a:?} by {d:?}");
        }
    }
    for n in 0..3000i64 {
        let square = i128::from(n * n);
        assert_eq!((root(square), root(square + i128::from(2 * n))), (n, n));
    }
}

/// Lists hold only the answer. Their old content is gone, even after an error. Only `pairs_from`
/// appends.
struct Buffers;

impl Check for Buffers {
    fn on(&mut self, name: &str, _: Option<i32>, empty: &Near<Mark>) {
        let mut phase = empty.clone();
        let [a, b] = [2, 1].map(|key| phase.insert(&aabb((0, 0), (4, 4)), Mark::new(key, 0)).unwrap());
        let (pair, old) = (Pair { a: b, b: a }, Pair { a, b: a });
        let mut pairs = Room::<Pair, 3>::from([old]);
        phase.pairs_sorted(&mut pairs).unwrap();
        assert_eq!(pairs, [pair], "{name}");
        phase.pairs_from(&mut PairCursor::new(), 100, &mut pairs).unwrap();
        assert_eq!(pairs, [pair, pair], "{name}");

        let mut bodies = Room::<Handle, 3>::from([a, a, a]);
        phase.collect_region(&aabb((4, 4), (4, 4)), &mut bodies).unwrap();
        assert_eq!(bodies, [b, a], "{name}");

        let (inside, outside, way) = (vec2((0, 0)), vec2((DOMAIN, 0)), vec2((DOMAIN - 4, 0)));
        let near = Room::<Nearest, 3>::from([Nearest { handle: a, distance: Fx::ONE }; 3]);
        for (from, within) in [(inside, Fx::DELTA), (inside, -Fx::DELTA), (inside, Fx::MIN), (outside, Fx::ONE)] {
            let mut out = near.clone();
            let told = phase.neighbours(from, within, |_, _| true, &mut out);
            let found: Vec<_> = out.iter().map(|near| near.handle).collect();
            if within == Fx::DELTA {
                assert_eq!((found, told), (vec![b, a], Ok(())), "{name}");
            } else {
                assert!(found.is_empty() && matches!(told, Err(QueryError::Range(_))), "{name}: {told:?}, {found:?}");
            }
        }
        let hits = Room::<BroadHit, 3>::from([BroadHit { handle: a, toi: Toi::ONE }; 3]);
        let mut out = hits.clone();
        assert!(matches!(phase.cast_ray(outside, inside, |_, _| true, &mut out), Err(QueryError::Range(_))), "{name}");
        assert!(out.is_empty(), "{name}");
        out.clone_from(&hits);
        let far = vec2((DOMAIN - 1, 0));
        assert!(matches!(phase.cast_ray(far, far, |_, _| true, &mut out), Err(QueryError::Range(_))), "{name}");
        assert!(out.is_empty(), "{name}");
        out.clone_from(&hits);
        let start = aabb((0, 0), (4, 4));
        assert!(matches!(phase.cast_shape(&start, way, |_, _| true, &mut out), Err(QueryError::Range(_))), "{name}");
        assert!(out.is_empty(), "{name}");
        out.clone_from(&hits);
        phase.cast_shape(&start, inside, |_, _| true, &mut out).unwrap();
        assert!(out.iter().map(|hit| hit.handle).eq([b, a]), "{name}");
    }
}

#[test]
fn buffers_hold_the_answer_alone() {
    everywhere(2, Cells { side: 8, origin: (-5, 1) }, &mut Buffers);
}

/// The two bodies that are farthest from each other, and no limit.
struct Farthest;

impl Check for Farthest {
    fn on(&mut self, name: &str, _: Option<i32>, empty: &Near<Mark>) {
        let end = DOMAIN - 1;
        for (x, y) in [(end, end), (end, -end), (-end, end), (-end, -end)] {
            let mut phase = empty.clone();
            let body = phase.insert(&aabb((x, y), (x, y)), Mark::new(0, 0)).unwrap();
            let from = vec2((-x, -y));
            let length = root(2 * i128::from(2 * end) * i128::from(2 * end));
            let expected = Nearest { handle: body, distance: Fx::from_bits(i32::try_from(length).unwrap()) };
            let ask = |within| phase.nearest(from, within, |_, _| true).unwrap();
            assert_eq!(ask(Fx::MAX), Some(expected), "{name}");
            // The root is rounded down. The number is not a square.
            assert_eq!((ask(expected.distance + Fx::DELTA), ask(expected.distance)), (Some(expected), None), "{name}");
            let mut out = Room::<Nearest, 2>::new();
            phase.neighbours(from, Fx::MAX, |_, _| true, &mut out).unwrap();
            assert_eq!(out, [expected], "{name}");
        }
    }
}

#[test]
fn nearest_without_a_limit() {
    for cells in [Cells { side: 1 << 20, origin: (-5, 1) }, Cells { side: 1 << 28, origin: (1 - (1 << 29), 0) }] {
        everywhere(2, cells, &mut Farthest);
    }
}

/// The pairs of movers on both sides of zero and at both ends of the domain, each listed twice.
/// Which body comes first depends on keys, not on slots or on who moved. All bodies return to their
/// positions.
struct Movers;

impl Check for Movers {
    fn on(&mut self, name: &str, _: Option<i32>, empty: &Near<Mark>) {
        for y in [1 - DOMAIN, 3 - DOMAIN, -5, -4, -2, 0, 1, DOMAIN - 6, DOMAIN - 5] {
            let mut phase = empty.clone();
            let bodies = [3, 1, 2].map(|key| phase.insert(&aabb((0, y), (4, y + 4)), Mark::new(key, 0)).unwrap());
            let [c, a, b] = bodies;
            let before: Vec<_> = phase.bodies().map(|(body, bounds, _)| (body, Rect::of(&bounds))).collect();
            let all = [(a, b), (a, c), (b, c)];
            for movers in [[c, a, b, c, a, b].as_slice(), &[b, b, a], &[c, c], &[a], &[]] {
                let mut told = Vec::new();
                phase.pairs_of(movers, |pair| told.push((pair.a, pair.b))).unwrap();
                told.sort_by_key(|(one, other)| (phase.tag(*one).unwrap().key, phase.tag(*other).unwrap().key));
                let expected = all.into_iter().filter(|(one, other)| movers.contains(one) || movers.contains(other));
                assert!(told.iter().copied().eq(expected), "{name}, {y}: {told:?} of {movers:?}");
                let after: Vec<_> = phase.bodies().map(|(body, bounds, _)| (body, Rect::of(&bounds))).collect();
                assert_eq!(after, before, "{name}");
            }
            let mut sorted = Room::<Pair, 3>::new();
            phase.pairs_sorted(&mut sorted).unwrap();
            assert!(sorted.iter().map(|pair| (pair.a, pair.b)).eq(all), "{name}, {y}: {sorted:?}");
        }
    }
}

#[test]
fn movers_come_back_and_keys_lead() {
    everywhere(3, Cells { side: 8, origin: (-5, 1) }, &mut Movers);
}

/// Only some structures accept boxes wider than a cell, among many small ones.
struct Walls;

impl Check for Walls {
    fn on(&mut self, name: &str, limit: Option<i32>, empty: &Near<Mark>) {
        let mut phase = empty.clone();
        let wall = phase.insert(&aabb((-1000, 10), (1000, 12)), Mark::new(0, 0)).unwrap();
        for i in 0..20 {
            phase.insert(&aabb((i * 90 - 900, 13 - i % 3), (i * 90 - 897, 14)), Mark::new(1, 1)).unwrap();
        }
        let mut near = 0;
        phase.pairs(|pair| near += u64::from(pair.a == wall));
        assert_eq!((near, limit), (13, None), "{name}");
    }
}

#[test]
fn walls_among_crumbs() {
    everywhere(21, Cells { side: 8, origin: (-60, -8) }, &mut Large(&mut Walls));
}
