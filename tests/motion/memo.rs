//! A memo gives the same answer as the call that it replaces, bit for bit, and answers no other
//! call.

use tilesat::{
    Aabb, AllShapes, Axis, Body, Circle, Fx, MoveError, Moved, Mover, Ratio, Surface, TileKind, TileKinds, TileMap,
    Vec2,
    motion::{Memo, Work},
};
use tilesat_judge::rooms::mosaic;
use tilesat_judge::{Random, cases};

const UP: Mover = Mover::platformer(Axis::NEG_Y);

fn without_work<B>(moved: Moved<B>) -> Moved<B> {
    Moved { work: Work::default(), ..moved }
}

type Map<'a> = TileMap<'a, AllShapes>;

/// Drops bodies into random levels and calls with and without a memo. Returns how many frames the
/// memo answered, of how many.
fn compare<B, M: Default>(
    body: impl Fn(Vec2, Fx) -> B,
    plain: impl Fn(&Map<'_>, &B, Vec2) -> Result<Moved<B>, MoveError>,
    again: impl Fn(&mut M, &Map<'_>, &B, Vec2) -> Result<Moved<B>, MoveError>,
) where
    B: Body + Copy + PartialEq + core::fmt::Debug,
{
    let (mut repeated, mut all) = (0, 0);
    for seed in 0..cases(60_u64) {
        let mut r = Random::new(seed);
        let level = mosaic(&mut r, (8, 8), 1 << 16, 30, 10);
        let map = level.all();
        let at = Vec2::from_raw(r.below(8 << 16) as i32, r.below(2 << 16) as i32);
        let mut now = body(at, Fx::from_bits(1 + r.below(1 << 16) as i32));
        let (mut velocity, mut memo) = (Vec2::ZERO, M::default());
        let gravity = Vec2::from_raw(0, 1 << r.within(8, 12));
        for _ in 0..400 {
            let asked = velocity + gravity;
            let Ok(expected) = plain(&map, &now, asked) else { break };
            let moved = again(&mut memo, &map, &now, asked).unwrap();
            assert_eq!(without_work(moved), without_work(expected), "seed {seed}: {now:?} by {asked:?}");
            repeated += u32::from(moved.work == Work::default());
            all += 1;
            (now, velocity) = (moved.body, moved.velocity);
        }
    }
    assert!(repeated * 4 > all && repeated < all, "{repeated} of {all} frames were repeated calls");
}

#[test]
fn a_memo_answers_as_the_call_does() {
    let disc = |at, size| Circle::new(at, size / 2).unwrap();
    let rect = |at, size| Aabb::new(at, at + Vec2::new(size, size)).unwrap();
    let rough = UP.with_surface(Surface::new(Ratio::ZERO, Ratio::percent(50).unwrap()));
    compare(
        disc,
        |m, b, v| UP.move_and_slide(m, b, v),
        |memo: &mut Memo<_>, m, b, v| memo.move_and_slide(&UP, m, 0, b, v),
    );
    compare(
        rect,
        |m, b, v| UP.move_and_slide(m, b, v),
        |memo: &mut Memo<_>, m, b, v| memo.move_and_slide(&UP, m, 0, b, v),
    );
    let ask = |memo: &mut Memo<_, _>, m: &Map<'_>, b: &Circle, v| memo.move_and_slide(&rough, m, 0, b, v);
    compare(disc, |m, b, v| rough.move_and_slide(m, b, v), ask);
}

static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL).with(b'=', TileKind::ONE_WAY_UP);

/// A body that stands on a one-way floor at y = 16, its velocity, and its memo of that.
fn standing(map: &TileMap<'_>) -> (Aabb, Vec2, Memo<Aabb>) {
    let body = Aabb::new(Vec2::from_ints(4, 6), Vec2::from_ints(12, 16)).unwrap();
    let (gravity, mut memo) = (Vec2::from_ints(0, 1), Memo::new());
    assert_eq!(memo.move_and_slide(&UP, map, 0, &body, gravity).unwrap().body, body);
    (body, gravity, memo)
}

#[test]
fn another_mover_version_place_or_velocity_is_another_call() {
    let map = TileMap::from_ascii("  \n==\n  \n  ", &KINDS).unwrap();
    let open = TileMap::from_ascii("  \n  \n  \n  ", &KINDS).unwrap();
    let (body, gravity, memo) = standing(&map);
    let after = |mover: &Mover, map: &TileMap<'_>, version, body: Aabb, velocity| {
        let mut copy = memo;
        let moved = copy.move_and_slide(mover, map, version, &body, velocity).unwrap();
        (moved.body.min() - body.min(), moved.work.iterations)
    };
    assert_eq!(after(&UP, &map, 0, body, gravity), (Vec2::ZERO, 0));
    assert_eq!(after(&UP.with_drop_through(true), &map, 0, body, gravity).0, gravity);
    assert_eq!(after(&UP, &open, 1, body, gravity).0, gravity);
    assert_eq!(after(&UP, &map, 0, body, -gravity).0, -gravity);
    let beside = Aabb::new(Vec2::from_ints(4, 5), Vec2::from_ints(12, 15)).unwrap();
    assert_eq!(after(&UP, &map, 0, beside, gravity).0, gravity);
}

#[test]
fn an_error_is_not_remembered_and_forgets() {
    let map = TileMap::from_ascii("  \n==\n  \n  ", &KINDS).unwrap();
    let (body, gravity, mut memo) = standing(&map);
    assert!(memo.move_and_slide(&UP, &map, 0, &body, Vec2::from_ints(0, 5000)).is_err());
    assert_eq!(memo, Memo::new());
    let moved = memo.move_and_slide(&UP, &map, 0, &body, gravity).unwrap();
    assert_eq!((moved.body, moved.work.iterations), (body, 1));
}

#[test]
#[cfg(debug_assertions)]
#[should_panic(expected = "the level changed, but not its version")]
fn a_door_without_a_version_is_found_out() {
    let map = TileMap::from_ascii("  \n==\n  \n  ", &KINDS).unwrap();
    let open = TileMap::from_ascii("  \n  \n  \n  ", &KINDS).unwrap();
    let (body, gravity, mut memo) = standing(&map);
    let _ = memo.move_and_slide(&UP, &open, 0, &body, gravity);
}
