//! Walkers over hills: they keep to the ground, and their speed follows the policy, on slopes,
//! flats and around every joint.

#![allow(clippy::cast_precision_loss, clippy::float_cmp, reason = "tests stop at the first surprise")]

use tilesat::world::World;
use tilesat::{Aabb, Axis, Fx, Mover, SlopeSpeed, Slopes, TileKind, TileKinds, TileMap, TileShape, Vec2, Walker};
use tilesat_judge::Random;
use tilesat_judge::ground::way::{along, height, is_straight, length, projected};
use tilesat_judge::ground::{Ground, P, PX, Shape, fx, tiles};

fn walker(speed: SlopeSpeed, snap: i64) -> Walker {
    let mover = Mover::platformer(Axis::NEG_Y).with_slope_limit(2, 1);
    Walker::new(mover).with_slope_speed(speed).with_snap(fx(snap)).unwrap()
}

/// The tolerance of frames, in raw units of way.
#[derive(Clone, Copy, Debug, Default)]
struct Off {
    over: f64,
    under: f64,
}

/// The extremes of a walk: the gap to the ground, the way of a frame on one straight part and
/// around joints.
#[derive(Clone, Copy, Debug)]
struct Tally {
    gap: (f64, f64),
    straight: Off,
    joints: Off,
    /// The least share of its due way that a frame made.
    least: f64,
    /// The most that a frame moved the body farther than its due way plus its drop.
    chord: f64,
    work: u32,
}

impl Tally {
    const NEW: Self = Self {
        gap: (0.0, 0.0),
        straight: Off { over: 0.0, under: 0.0 },
        joints: Off { over: 0.0, under: 0.0 },
        least: 1.0,
        chord: 0.0,
        work: 0,
    };
}

/// From one end to the other. Each frame is judged. Returns the positions.
fn cross<W: World>(
    ground: &Ground,
    world: &W,
    shape: Shape,
    kind: SlopeSpeed,
    speed: i64,
    tally: &mut Tally,
) -> Vec<P> {
    let walker = walker(kind, 4 * speed.abs());
    let margin = 20 * PX + speed.abs();
    let (from, to) = if speed > 0 { (margin, ground.end() - margin) } else { (ground.end() - margin, margin) };
    let start = (height(ground, shape, from as f64).floor() as i64) - PX;
    let mut last = shape.step(&walker, world, (from, start), (0, 2 * PX), None).unwrap();
    assert!(last.floor.is_some() && last.at.0 == from, "{last:?}");
    let mut places = vec![last.at];
    while (to - last.at.0) * speed.signum() > 0 {
        let at = last.at;
        let out = shape.step(&walker, world, at, (speed, PX / 4), last.floor).unwrap();
        let tell = || format!("{shape:?} by {speed} {kind:?} at {at:?}: {out:?}");
        assert!(out.floor.is_some(), "left the ground: {}", tell());
        assert!(out.v == (speed, 0) && !out.hit_wall && !out.hit_ceiling && out.stepped == 0, "{}", tell());
        let gap = height(ground, shape, out.at.0 as f64) - out.at.1 as f64;
        tally.gap = (tally.gap.0.min(gap), tally.gap.1.max(gap));
        let part = if kind == SlopeSpeed::Constant { length } else { projected };
        let (a, b) = (at.0 as f64, out.at.0 as f64);
        let (made, due) = (along(ground, shape, a, b, part), speed.abs() as f64);
        tally.least = tally.least.min(made / due);
        assert!(made > 0.0, "does not move: {}", tell());
        let off = if is_straight(ground, shape, a, b) { &mut tally.straight } else { &mut tally.joints };
        *off = Off { over: off.over.max(made - due), under: off.under.max(due - made) };
        let way = (b - a).hypot((out.at.1 - at.1) as f64);
        // A body passes over a dip shorter than a frame's way, and such a frame draws it down. Here
        // no box does.
        let may_hop = matches!(shape, Shape::Disc(_)) || kind == SlopeSpeed::Projected;
        assert!(way - due <= 4.0 || may_hop, "too far: {}", tell());
        tally.chord = tally.chord.max(way - due - out.snapped as f64);
        tally.work = tally.work.max(out.work);
        places.push(out.at);
        last = out;
    }
    places
}

const HILLS: [&str; 5] =
    ["____/__\\____", "___m_w__mmww___", "___s__z__s_z___", "__/\\__/m_w\\__msz_w___", "___/s__z\\_____"];
const SHAPES: [Shape; 4] =
    [Shape::Rect(5 * PX, 8 * PX), Shape::Disc(8 * PX), Shape::Rect(3 * PX + 77, 5 * PX), Shape::Disc(3 * PX + 123)];
const SPEEDS: [i64; 4] = [PX / 3, PX + 7, 3 * PX, 5 * PX + 12345];

/// Every hill of tiles and the same as a polygon, in both directions, seen in a mirror too.
fn over_all(kind: SlopeSpeed, shape: Shape) -> Tally {
    let mut t = Tally::NEW;
    for picture in HILLS {
        let ground = Ground::of(picture, 5, 6);
        let mirrored = Ground::mirrored(picture, 5, 6);
        for speed in SPEEDS.into_iter().flat_map(|s| [s, -s]) {
            let places = cross(&ground, &tiles(&ground.level()), shape, kind, speed, &mut t);
            let other = cross(&mirrored, &tiles(&mirrored.level()), shape, kind, -speed, &mut t);
            let end = ground.end();
            assert!(places.iter().zip(&other).all(|(a, b)| (end - a.0, a.1) == *b), "mirrored: {shape:?} by {speed}");
            ground.with_polygon(|map| {
                assert_eq!(places, cross(&ground, map, shape, kind, speed, &mut t), "tiles and polygon {picture}");
            });
        }
    }
    t
}

/// Never faster than a raw unit above, and slower only by the raw units that slopes and their
/// joints cost.
#[test]
fn boxes_have_one_speed() {
    for shape in SHAPES.into_iter().filter(|s| matches!(s, Shape::Rect(..))) {
        let t = over_all(SlopeSpeed::Constant, shape);
        println!("{t:?}");
        assert!(t.gap.0 >= -0.001 && t.gap.1 <= 1.01, "{t:?}");
        assert!(t.straight.over <= 0.001 && t.straight.under <= 2.3, "{t:?}");
        assert!(t.joints.over <= 4.0 && t.joints.under <= 6.0 && t.chord <= 0.1, "{t:?}");
    }
}

/// The same for circles, except for frames in which they go around a corner. They follow its
/// tangents, which is farther than around it.
#[test]
fn circles_have_one_speed() {
    for shape in SHAPES.into_iter().filter(|s| matches!(s, Shape::Disc(..))) {
        let t = over_all(SlopeSpeed::Constant, shape);
        println!("{t:?}");
        assert!(t.gap.0 >= -0.001 && t.gap.1 <= 1.01, "{t:?}");
        assert!(t.straight.over <= 0.001 && t.straight.under <= 3.3, "{t:?}");
        assert!(t.joints.over <= 4.0 && t.chord <= 4.0 && t.joints.under <= 0.25 * (5 * PX + 12345) as f64, "{t:?}");
    }
}

/// As slow up as down.
#[test]
fn projected_speed() {
    for shape in SHAPES {
        let t = over_all(SlopeSpeed::Projected, shape);
        println!("{t:?}");
        assert!(t.gap.0 >= -0.001 && t.gap.1 <= 1.01, "{t:?}");
        assert!(t.straight.over <= 0.001 && t.straight.under <= 5.1, "{t:?}");
    }
}

/// Ground of any angles up to the limit, in any order.
#[test]
fn random_ground() {
    let mut r = Random::new(0x40);
    for kind in [SlopeSpeed::Constant, SlopeSpeed::Projected] {
        let mut t = [Tally::NEW; 2];
        for k in 0..60 {
            let mut p = (0, 0);
            let mut points = vec![p];
            for _ in 0..14 {
                let dx = r.within(3 * PX, 40 * PX);
                let most = dx * if k % 2 == 0 { 2 } else { 1 } / 2 - 1;
                p = (p.0 + dx, p.1 + r.within(-most, most));
                points.push(p);
            }
            let ground = Ground::corners(&points);
            let (speed, turn) = (r.within(PX / 4, 5 * PX), if r.one_in(2) { 1 } else { -1 });
            for (shape, t) in [Shape::Rect(4 * PX + 9, 6 * PX), Shape::Disc(5 * PX + 3)].into_iter().zip(&mut t) {
                ground.with_polygon(|map| cross(&ground, map, shape, kind, turn * speed, t));
            }
        }
        println!("{kind:?} {t:?}");
        for t in t {
            assert!(t.gap.0 >= -0.001 && t.gap.1 <= 4.0, "{t:?}");
            assert!(t.straight.over <= 0.01 && t.straight.under <= 10.0, "{t:?}");
        }
        assert!(t.iter().all(|t| t.chord <= 4.0) && t[0].joints.under <= 16.0, "{t:?}");
    }
}

static HALVES: TileKinds = TileKinds::EMPTY
    .with(b'#', TileKind::FULL)
    .with(b'_', TileKind::of(TileShape::HalfBottom))
    .with(b'a', TileKind::of(TileShape::MildLowBottomRight))
    .with(b'b', TileKind::of(TileShape::MildHighBottomRight));

/// A box as wide as a cell comes down a slope on its back corner, and its front corner comes to the
/// top of a half tile at that moment. It goes on, so no wall blocks it.
#[test]
fn a_corner_that_it_passes_is_no_wall() {
    let level = TileMap::<Slopes>::of_ascii("......\n......\n__ab##\n######", &HALVES).unwrap();
    let walker = Walker::new(Mover::platformer(Axis::NEG_Y)).with_slope_speed(SlopeSpeed::Constant);
    for start in 0..100 {
        for run in [PX / 2, PX, 3 * PX / 2, 3 * PX] {
            let from = Vec2::new(Fx::from_num(40) + Fx::from_bits(911 * start), Fx::ZERO);
            let mut body = Aabb::from_size(from, Vec2::from_ints(16, 14)).unwrap();
            let (mut velocity, mut floor) = (Vec2::ZERO, None);
            for frame in 0..70 {
                velocity = Vec2::new(if frame < 30 { Fx::ZERO } else { -fx(run) }, velocity.y + fx(PX / 4));
                let walked = walker.walk(&level, &body, velocity, floor).unwrap();
                (body, velocity, floor) = (walked.moved.body, walked.moved.velocity, walked.floor);
                assert!(frame < 30 || !walked.moved.wall || velocity.x == 0, "{start} {run} {body:?}");
                if body.min().x < 8 {
                    break;
                }
            }
        }
    }
}
