//! Many ticks of levels with convex solids and bodies, each one judged. No body is in the level,
//! and none is in a solid unless the call reports it as squashed. No solid passes a body, and
//! carried bodies move exactly. Shuffled and mirrored scenes give the same bits.

use std::collections::BTreeSet;
use tilesat::motion::{Ridden, Ride};
use tilesat::prelude::*;
use tilesat::shape::AnyShape;
use tilesat::world::ConvexSolid;
use tilesat::{
    Aabb, AllShapes, Axis, Capsule, Circle, ConvexPolygon, Fx, Mover, OrientedBox, Quantity, RangeError, Solid,
    TileMap, Vec2,
};
use tilesat_judge::solids::convex::polygons;
use tilesat_judge::solids::shapes::{Figure, Rider, Scene, Seen, plank};
use tilesat_judge::solids::ticks::{
    ALL, CELL, FOLLOW, MOVER, SIDE, balls, boxes, capsules, grid, solids, steer, tiles,
};
use tilesat_judge::solids::twins::{BLOCKS, KINDS, mirrored_level};
use tilesat_judge::solids::{disc, raw, rect, vec2};
use tilesat_judge::{Random, cases};

fn play(kinds: i64, seed: u64, count: u64, seen: &mut Seen) {
    let mut random = Random::new(seed);
    for _ in 0..cases(count) {
        let tiles = if kinds == 0 { vec![0; (SIDE * SIDE) as usize] } else { tiles(&mut random, kinds) };
        let mirror = mirrored_level(&tiles, SIDE as usize);
        let level = TileMap::<AllShapes>::of(&tiles, grid((0, 0)), &KINDS).unwrap();
        let mirror = TileMap::<AllShapes>::of(&mirror, grid((-ALL, 0)), &KINDS).unwrap();
        let scene = Scene { level: &level, mirror: &mirror, open: kinds == 0 };
        scene.play(boxes, 40, &mut random, seen);
        scene.play(balls, 40, &mut random, seen);
        scene.play(capsules, 40, &mut random, seen);
        scene.play(polygons, 40, &mut random, seen);
    }
    println!("{seen:?}");
}

#[test]
fn bodies_in_the_open() {
    let mut seen = Seen::default();
    play(0, 281, 300, &mut seen);
    let least = [seen.free, seen.carried, seen.pushed, seen.squashed, seen.exact, seen.alone, seen.turned, seen.moves];
    assert!(least.iter().all(|&n| n > 9), "{seen:?}");
    // In the open each body can yield to a single solid.
    assert!(seen.dead == 0, "{seen:?}");
}

#[test]
fn bodies_among_blocks() {
    let mut seen = Seen::default();
    play(1, 282, tilesat_judge::thorough(100, 300), &mut seen);
    assert!(seen.free.min(seen.carried).min(seen.pushed).min(seen.squashed) > 9, "{seen:?}");
}

#[test]
fn bodies_among_all_shapes() {
    let mut seen = Seen::default();
    play(37, 283, tilesat_judge::thorough(100, 300), &mut seen);
    assert!(seen.free.min(seen.carried).min(seen.pushed).min(seen.squashed) > 9, "{seen:?}");
}

/// Boxes as convex solids carry and push boxes as plain ones do, to the bit.
#[test]
fn boxes_are_boxes() {
    let (mut random, mut seen, mut alive) = (Random::new(284), 0, 0);
    for _ in 0..cases(2_000) {
        let tiles = tiles(&mut random, 1);
        let level = TileMap::on_grid(&tiles, grid((0, 0)), &BLOCKS).unwrap();
        for _ in 0..20 {
            let mut list = solids(&mut random);
            steer(&mut list, &mut random);
            let plain = |s: &Solid| s.one_way().is_none();
            let list: Vec<_> =
                list.iter().filter(|s| plain(s)).map(|s| s.with_conveyor(tilesat::Vec2::ZERO).unwrap()).collect();
            let convex: Vec<_> = list
                .iter()
                .map(|s| ConvexSolid::new(s.shape(), s.key()).unwrap().with_motion(s.motion()).unwrap())
                .collect();
            let mut body = boxes(&mut random);
            if let (Some(s), true) = (list.first(), random.one_in(2)) {
                let over = tilesat::Vec2::new(s.shape().min().x - body.min().x, s.shape().min().y - body.max().y);
                body = body.translated(over).unwrap();
            }
            if level.overlaps(&body) {
                continue;
            }
            let follow = Fx::from_bits(FOLLOW as i32);
            let one = MOVER.ride(&level, &list, &body, follow).unwrap();
            let two = MOVER.ride_convex(&level, &convex, &body, follow).unwrap();
            let case = format!("{body:?}\n{list:?}\n{one:?}\n{two:?}");
            let inside = list.iter().any(|s| s.shape().overlaps(&body));
            // If several solids squash a body, either may be named.
            let ride = |r: &Ridden<Aabb>| match r.ride {
                Ride::Squashed { .. } => None,
                ride => Some(ride),
            };
            let told = |r: &Ridden<Aabb>| (r.body, r.floor, r.carry, ride(r));
            if inside {
                continue;
            }
            // Where plain boxes find no way, convex ones may find that the body can stay.
            if ride(&one).is_none() && ride(&two).is_some() {
                let clear = !list.iter().any(|s| s.moved().shape().overlaps(&two.body));
                assert!(clear && !level.overlaps(&two.body), "{case}");
                alive += 1;
            } else {
                assert_eq!(told(&one), told(&two), "{case}");
            }
            seen += u32::from(one.ride != Ride::Free);
        }
    }
    println!("{seen} rides, {alive} more alive");
    assert!(seen > 1000 && alive * 1000 < seen);
}

/// A thin arm turns by up to forty degrees per tick among small bodies. None gets to its other
/// side, and none that it can push out is squashed. Of the bodies that are clear of the hull of
/// both positions, less than 1 % are pushed: no line that is tried is between that hull and the
/// body.
#[test]
fn no_arm_passes_a_body() {
    fn turn<B: Rider>(make: impl Fn(&mut Random) -> B, seed: u64, least: u32) {
        let (mut random, mut beside, mut pushed, mut squashed) = (Random::new(seed), 0, 0, 0);
        let (mut clear, mut moved) = (0, 0);
        let tiles = vec![0; (SIDE * SIDE) as usize];
        let level = TileMap::<AllShapes>::of(&tiles, grid((0, 0)), &KINDS).unwrap();
        for _ in 0..cases(20_000) {
            let (long, wide) = (2 * CELL + random.within(0, CELL), random.within(2, CELL / 8));
            let angle = |random: &mut Random| {
                let (x, y) = (random.around(200), random.around(200));
                if (x, y) == (0, 0) { (1, 0) } else { (x, y) }
            };
            let from = angle(&mut random);
            // To the side by up to 40 degrees.
            let k = random.around(83);
            let to = (from.0 * 100 - from.1 * k, from.1 * 100 + from.0 * k);
            let arm = |direction| plank((0, 0), (long, wide), direction);
            let Ok(solid) = ConvexSolid::new(arm(from), 3) else { continue };
            let Ok(solid) = solid.with_turn(arm(to)) else { continue };
            let body = make(&mut random);
            if Figure::of(&arm(from)).meets(&body.figure()) {
                continue;
            }
            let ridden = MOVER.ride_convex(&level, &[solid], &body, Fx::ONE).unwrap();
            let centre = |b: &B| {
                let all = b.figure().points;
                let sum = |of: fn(&(i64, i64)) -> i64| all.iter().map(of).sum::<i64>() / all.len() as i64;
                (sum(|p| p.0), sum(|p| p.1))
            };
            // The side of the arm on which the body is; `None` if a part of it may be beyond the
            // arm's tip in the middle of the turn, where the arm is shorter.
            let place = |dir: (i64, i64), c: (i64, i64), size: i64| {
                let (along, across) = (dir.0 * c.0 + dir.1 * c.1, dir.0 * c.1 - dir.1 * c.0);
                let length = (dir.0 * dir.0 + dir.1 * dir.1).isqrt() + 1;
                (along.abs() / length + size < long * 93 / 100).then_some(across.signum())
            };
            let size = ridden.body.any().aabb().size();
            let size = i64::from(size.x.to_bits().max(size.y.to_bits()));
            let sides = (place(from, centre(&body), size), place(to, centre(&ridden.body), size));
            if let (Some(before), Some(after)) = sides {
                assert_eq!(before, after, "{solid:?} {body:?} {ridden:?}");
                beside += 1;
            }
            pushed += u32::from(matches!(ridden.ride, Ride::Pushed { .. }));
            let mut both = Figure::of(&arm(from));
            both.points.extend(Figure::of(&arm(to)).points);
            if ridden.floor.is_none() && !both.meets(&body.figure()) {
                clear += 1;
                moved += u32::from(ridden.ride != Ride::Free);
            }
            if matches!(ridden.ride, Ride::Squashed { .. }) {
                squashed += 1;
            } else {
                assert!(!Figure::of(&arm(to)).meets(&ridden.body.figure()), "{solid:?} {body:?} {ridden:?}");
            }
        }
        println!("{beside} beside, {pushed} pushed, {squashed} squashed; {clear} clear, of these {moved} pushed");
        assert!(beside > 1000 && pushed > least && squashed == 0);
        assert!(moved * 100 < clear);
    }
    let at = |random: &mut Random| (random.around(3 * CELL), random.around(3 * CELL));
    turn(
        |random| {
            let c = at(random);
            rect(c, (c.0 + random.within(1, CELL / 2), c.1 + random.within(1, CELL / 2)))
        },
        285,
        1000,
    );
    turn(|random| disc(at(random), random.within(1, CELL / 4)), 286, 1000);
    turn(
        |random| {
            let (c, long) = (at(random), random.within(1, CELL / 2));
            let (x, y) = if random.one_in(2) { (long, 0) } else { (0, long) };
            let radius = Fx::from_bits(random.within(1, CELL / 8) as i32);
            Capsule::new(vec2(c), vec2((c.0 + x, c.1 + y)), radius).unwrap()
        },
        287,
        1000,
    );
    turn(polygons, 288, 400);
}

/// What a shape with these corners and this radius is as a solid: the fault, or none.
fn fault(corners: &[(i32, i32)], radius: i32, may_be_round: bool) -> Option<RangeError> {
    let extent = |of: fn(&(i32, i32)) -> i32| {
        let all = || corners.iter().map(of);
        all().max().unwrap() - all().min().unwrap() + 2 * radius
    };
    let (w, h) = (extent(|p| p.0), extent(|p| p.1));
    let sides = || (0..corners.len()).map(|i| (corners[i], corners[(i + 1) % corners.len()]));
    // Twice the area between the corners.
    let area: i64 = sides().map(|(p, q)| i64::from(p.0) * i64::from(q.1) - i64::from(p.1) * i64::from(q.0)).sum();
    let slanted = sides().any(|(p, q)| p.0 != q.0 && p.1 != q.1);
    let error = |what, value| Some(RangeError { what, value });
    if radius == 0 && area == 0 {
        error(Quantity::Area, w.min(h))
    } else if w.max(h) >= 1 << 29 {
        error(Quantity::BodySize, w.max(h))
    } else if radius != 0 && (slanted || !may_be_round) {
        error(Quantity::Rounding, radius)
    } else {
        None
    }
}

#[test]
fn refusals_name_a_remedy() {
    let text = |what, value| RangeError { what, value }.to_string();
    assert_eq!(
        text(Quantity::Corners, 4),
        "a solid keeps its number of corners when it turns: the new shape must have 4"
    );
    assert!(text(Quantity::Rounding, 1 << 18).contains("cannot have a radius of 4 (262144 raw): make it a sharp"));
    assert!(text(Quantity::Area, 0).starts_with("the shape has no area: a solid needs one"));
    assert!(text(Quantity::Capsule, 1 << 16).starts_with("the capsule is slanted by 1 (65536 raw): make it upright"));
    assert!(text(Quantity::Capsule, 0).starts_with("the capsule has no radius"));
    assert!(text(Quantity::Width, 0).ends_with("that of a solid must be above 0"));
    assert!(text(Quantity::Width, -1).ends_with("the maximum of a box must not be less than its minimum"));
}

/// A shape is a solid at rest, or has that fault: in constants, in calls, and as any shape.
macro_rules! judged {
    ($shape:expr, $any:expr, $corners:expr, $radius:expr, $round:expr, $seen:ident) => {{
        let (shape, corners): (_, Vec<(i32, i32)>) = ($shape, $corners);
        let (own, as_any) = (fault(&corners, $radius, $round), fault(&corners, $radius, true));
        let made = shape.convex_solid(7);
        assert_eq!((made.err(), $any(shape).convex_solid(7).err()), (own, as_any), "{shape:?}");
        assert_eq!(made, ConvexSolid::new(shape, 7));
        if let Ok(solid) = made {
            assert_eq!((solid.shape(), solid.next(), solid.motion()), (shape, shape, Some(Vec2::ZERO)));
            assert_eq!((solid.key(), solid.flags()), (7, 0));
        }
        $seen.insert(own.map(|error| format!("{:?}", error.what)));
    }};
}

#[test]
fn solids_of_constants_are_those_of_calls() {
    type Any = AnyShape<4>;
    let mut seen = BTreeSet::new();
    let sizes = [0, 1, 5, 1 << 20, 1 << 28];
    for (w, h, r) in sizes.iter().flat_map(|w| sizes.iter().flat_map(move |h| [0, 3].map(|r| (*w, *h, r)))) {
        let (at, size, radius) = (Vec2::from_raw(-7, 9), Vec2::from_raw(w, h), Fx::from_bits(r));
        let raw = |p: &[Vec2]| p.iter().map(|p| p.raw()).collect::<Vec<_>>();
        if let Ok(shape) = Aabb::from_size(at, size) {
            judged!(shape, Any::Aabb, vec![(-7, 9), (-7 + w, 9), (-7 + w, 9 + h), (-7, 9 + h)], 0, false, seen);
        }
        if let Ok(shape) = Circle::new(at, radius) {
            judged!(shape, Any::Circle, raw(&[at]), r, true, seen);
        }
        if let Ok(shape) = Capsule::new(at, at + size, radius) {
            judged!(shape, Any::Capsule, raw(&[at, at + size]), r, true, seen);
        }
        for direction in [Axis::X, Axis::NEG_Y, Axis::new(3, 4)] {
            let shape = OrientedBox::new(at, size, direction).and_then(|it| it.with_radius(radius));
            if let Ok(shape) = shape {
                judged!(shape, Any::OrientedBox, raw(&shape.corners()), r, false, seen);
            }
        }
        for corners in [vec![(0, 0), (w, 0), (w, h)], vec![(0, 0), (w, 0), (w, h), (0, h)]] {
            let corners = corners.iter().map(|&(x, y)| at + Vec2::from_raw(x, y)).collect::<Vec<_>>();
            let Ok(shape) = ConvexPolygon::<4>::new(&corners) else { continue };
            let Ok(shape) = shape.with_radius(radius) else { continue };
            judged!(shape, Any::Polygon, raw(shape.vertices()), r, false, seen);
        }
    }
    assert_eq!(seen.len(), 4, "{seen:?}");
}

/// A change in place is the change of a value, and a refused one is none.
#[test]
fn solids_change_in_place() {
    let plank = |x, rise| OrientedBox::new(vec2((x, 0)), vec2((2000, 200)), Axis::new(90, rise)).unwrap();
    let flat = ConvexSolid::new(plank(0, 0), 3).unwrap();
    let mut random = Random::new(77);
    let mut refused = 0;
    for _ in 0..cases(400) {
        let mut solid = flat.with_motion(vec2((5, 7))).unwrap();
        let before = solid;
        let (result, value) = if random.one_in(2) {
            let motion = Vec2::from_raw(random.around(1 << 29) as i32, random.around(1 << 10) as i32);
            (solid.set_motion(motion), before.with_motion(motion))
        } else {
            let next = plank(random.around(99), random.around(20) as i32);
            let next = next.with_radius(Fx::from_bits(i32::from(random.one_in(3)))).unwrap();
            (solid.set_turn(next), before.with_turn(next))
        };
        refused += i32::from(result.is_err());
        assert_eq!((result.err(), solid), (value.err(), value.unwrap_or(before)));
    }
    assert!(refused > 9);
}

/// A plank that turns by less than 90 degrees takes a ball along on its side, however thick it is.
/// A square does at less than 45.
#[test]
fn nobody_gets_to_the_other_side_of_a_turning_plank() {
    let tiles = vec![0; (SIDE * SIDE) as usize];
    let level = TileMap::<AllShapes>::of(&tiles, grid((0, 0)), &KINDS).unwrap();
    for (half, thick, most) in [(60, 4, 90), (20, 4, 90), (8, 4, 90), (6, 4, 90), (20, 1, 90), (6, 6, 45)] {
        for degrees in 1..most {
            // Around its end at the origin; its tip goes up.
            let turned = |degrees: i32| {
                let (sin, cos) = f64::from(-degrees).to_radians().sin_cos();
                let middle = [cos, sin].map(|part| (part * f64::from(half) * 65_536.0).round() as i64);
                let axis = Axis::new((cos * 1e6) as i32, (sin * 1e6) as i32);
                OrientedBox::new(vec2((middle[0], middle[1])), Vec2::from_ints(half, thick), axis).unwrap()
            };
            let ball = Circle::new(Vec2::from_ints(half, -thick - 5), Fx::from_bits(4 << 16)).unwrap();
            let solid = [ConvexSolid::new(turned(0), 1).unwrap().with_turn(turned(degrees)).unwrap()];
            let ridden = MOVER.ride_convex(&level, &solid, &ball, Fx::ONE).unwrap();
            let next = solid[0].next();
            let side = next.along().perp_dot(ridden.body.centre() - next.centre());
            assert!(side < 0, "{half} x {thick} by {degrees} degrees: {:?}", ridden.body.centre());
        }
    }
}

/// A box stands on a plank that turns and on a block that rises. The one whose part under the box
/// rises more pushes it, whichever end of the plank that is.
#[test]
fn the_part_that_pushes_decides_which_solid_is_named() {
    let mover = Mover::new();
    let level = TileMap::<AllShapes>::of(&[0; 36], grid((0, 0)), &KINDS).unwrap();
    let plank = |rise| -> AnyShape<4> {
        OrientedBox::new(Vec2::from_ints(0, 4), Vec2::from_ints(30, 4), Axis::new(60, rise)).unwrap().into()
    };
    for (side, rise) in [(1, -12), (-1, 12)] {
        let at = |x: i16| Vec2::from_ints(side * x, 0);
        let block: AnyShape<4> = rect(raw(at(20)), raw(at(26) + Vec2::from_ints(0, 8))).into();
        let body = rect(raw(at(20)), raw(at(26) - Vec2::from_ints(0, 6)));
        let seesaw = ConvexSolid::new(plank(0), 1).unwrap().with_turn(plank(rise)).unwrap();
        for (up, named) in [(1, 1), (2, 1), (8, 0)] {
            let block = ConvexSolid::new(block, 0).unwrap().with_motion(Vec2::from_ints(0, -up)).unwrap();
            let ridden = mover.ride_convex(&level, &[seesaw, block], &body, Fx::ONE).unwrap();
            assert!(matches!(ridden.ride, Ride::Pushed { by, .. } if by == named), "{side}, {up}: {ridden:?}");
        }
    }
}
