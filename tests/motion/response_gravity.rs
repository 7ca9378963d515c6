//! Accelerations below a raw unit per frame: exact in flight, silent at rest.

use tilesat::{
    Aabb, Axis, Body, Circle, Fx, Mover, Slopes, TileKind, TileKinds, TileMap, TileShape, Vec2,
    motion::{Acceleration, Carry},
};
use tilesat_judge::frames;

const PX: i32 = 1 << 16;
const UP: Mover = Mover::platformer(Axis::NEG_Y);

static KINDS: TileKinds = TileKinds::EMPTY
    .with(b'#', TileKind::FULL)
    .with(b'/', TileKind::of(TileShape::SlopeBottomRight))
    .with(b'\\', TileKind::of(TileShape::SlopeBottomLeft));

/// After k frames the velocity is `k by / frames`, rounded toward zero, on both axes and with both
/// signs.
#[test]
fn exact_in_every_frame() {
    for n in [1, 2, 3, 7, 60, 1000, 65_521, 1 << 30] {
        for (x, y) in [(0, 1), (1, -1), (-2, 100), (16_384, -16_385), (59, -61), (1 << 20, 3)] {
            let gravity = Acceleration::new(Vec2::from_raw(x, y), n).unwrap();
            let (mut v, mut carry) = (Vec2::ZERO, Carry::ZERO);
            for k in 1..=1_000 {
                (v, carry) = gravity.act(v, carry);
                let part = |by: i32| (i64::from(by) * k / i64::from(n)) as i32;
                assert_eq!(v, Vec2::from_raw(part(x), part(y)), "frame {k} of {x}, {y} in {n}");
            }
        }
    }
    assert_eq!(Acceleration::new(Vec2::ZERO, 0), None);
    assert_eq!(Acceleration::new(Vec2::ZERO, (1 << 30) + 1), None);
    assert_eq!(Acceleration::new(Vec2::from_raw(1 << 29, 0), 1), None);
}

fn stays<B: Body + PartialEq + core::fmt::Debug>(map: &TileMap<'_, Slopes>, start: B, gravity: Acceleration) {
    let (mut body, mut v, mut carry, mut still) = (start, Vec2::ZERO, Carry::ZERO, None);
    for frame in 0..frames(100_000) {
        (v, carry) = gravity.act(v, carry);
        let moved = UP.move_and_slide(map, &body, v).unwrap();
        if moved.floor {
            carry = gravity.supported(moved.velocity, carry);
        }
        (body, v) = (moved.body, moved.velocity);
        if frame == 2_000 {
            still = Some((body, carry));
        }
        if let Some(still) = still {
            assert_eq!((body, v, carry), (still.0, Vec2::ZERO, still.1), "frame {frame}");
            assert!(moved.floor && !moved.wall, "frame {frame}: {moved:?}");
        }
    }
}

/// From less than a raw unit per frame up: lying bodies are constant in position, velocity and
/// flags.
#[test]
fn nothing_hums_at_rest() {
    let map: TileMap<'_, Slopes> = TileMap::of_ascii("      \n\\    /\n#\\  /#\n######\n", &KINDS).unwrap();
    for (by, n) in [(1, 300), (100, 300), (4, 3), (200, 60), (16_384, 1)] {
        let gravity = Acceleration::new(Vec2::from_raw(0, by), n).unwrap();
        stays(&map, Aabb::new(Vec2::from_raw(40 * PX, 40 * PX), Vec2::from_raw(50 * PX, 48 * PX)).unwrap(), gravity);
        stays(&map, Circle::new(Vec2::from_raw(48 * PX, 40 * PX), Fx::from_num(8)).unwrap(), gravity);
    }
}

/// A wind along the floor keeps its average, filled or not: only the blocked axis is filled.
#[test]
fn what_is_not_held_stays_exact() {
    let map: TileMap<'_, Slopes> = TileMap::of_ascii("      \n\\    /\n#\\  /#\n######\n", &KINDS).unwrap();
    let pull = Acceleration::new(Vec2::from_raw(100, 50), 300).unwrap();
    let mut body = Aabb::new(Vec2::from_raw(40 * PX, 40 * PX), Vec2::from_raw(41 * PX, 48 * PX)).unwrap();
    let (mut v, mut carry) = (Vec2::from_raw(1, 0), Carry::ZERO);
    for k in 1..=300 {
        (v, carry) = pull.act(v, carry);
        let moved = UP.move_and_slide(&map, &body, v).unwrap();
        (body, v) = (moved.body, moved.velocity);
        if moved.floor {
            carry = pull.supported(v, carry);
        }
        assert_eq!(v.raw().0, 1 + k * 100 / 300, "frame {k}");
    }
}
