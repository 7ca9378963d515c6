//! The nearest surface point, and the contacts of boxes and circles with a level's features,
//! against the definitions.

#![allow(clippy::cast_precision_loss, reason = "tests stop at the first surprise")]

use tilesat::world::Pushable;
use tilesat::{
    Aabb, AllShapes, Axis, Circle, Fx, Outside, Quantity, TileMap, Vec2,
    error::Truncated,
    world::{Feature, Near, OneWay, WorldContact},
};
use tilesat_judge::shapes::build::{LIMIT, body, in_domain, mosaic};
use tilesat_judge::shapes::contact::Expected;
use tilesat_judge::shapes::judge::{Body, Judge};
use tilesat_judge::shapes::level::Level;
use tilesat_judge::{Random, cases};

fn vec2((x, y): (i64, i64)) -> Vec2 {
    Vec2::from_raw(x as i32, y as i32)
}

fn point(v: Vec2) -> (i64, i64) {
    (i64::from(v.raw().0), i64::from(v.raw().1))
}

fn wide(v: (i64, i64)) -> (i128, i128) {
    (v.0.into(), v.1.into())
}

/// The normal leads from the nearer point of the line between both to the other. Rounding the point
/// may turn it.
fn check_axis(near: &Near, p: (i64, i64)) {
    let (q, axis) = (point(near.point), wide((near.axis.x.into(), near.axis.y.into())));
    let m = wide((p.0 - q.0, p.1 - q.1));
    let (dot, cross) = (axis.0 * m.0 + axis.1 * m.1, axis.0 * m.1 - axis.1 * m.0);
    assert!(axis != (0, 0));
    assert!(cross * cross <= 2 * (axis.0 * axis.0 + axis.1 * axis.1), "{near:?} from {p:?}");
    if near.distance.to_bits() > 2 {
        assert_eq!(dot > 0, !near.inside, "{near:?} from {p:?}");
    }
}

fn check_near(level: &Level, judge: &Judge, p: (i64, i64), within: i64) -> bool {
    let near = level.all().closest_point(vec2(p), Fx::from_bits(within as i32), OneWay::Ignore).unwrap();
    let case = format!("{near:?} from {p:?} within {within}\n{level:?}");
    assert_eq!(near.is_some(), judge.surface_within(p, within, true), "{case}");
    let Some(near) = near else { return false };
    let distance = i64::from(near.distance.to_bits());
    assert!(!judge.surface_within(p, distance, false), "too far: {case}");
    assert!(judge.surface_within(p, distance + 1, false), "too near: {case}");
    assert_eq!(near.inside, judge.is_inside(p), "{case}");
    let q = point(near.point);
    assert!(judge.near_surface(q, 1), "{case}");
    let d2 = i128::from(p.0 - q.0).pow(2) + i128::from(p.1 - q.1).pow(2);
    let d = i128::from(distance);
    assert!((d - 1).max(0).pow(2) <= d2 && d2 <= (d + 2).pow(2), "{case}");
    check_axis(&near, p);
    true
}

#[test]
fn closest_points_equal_the_definitions() {
    let mut random = Random::new(41);
    let (mut done, mut found, mut inside) = (0u64, 0u64, 0u64);
    while done < cases(40_000) {
        let level = mosaic(&mut random);
        let judge = Judge::new(&level);
        for _ in 0..25 {
            let p = match body(&mut random, &level) {
                Body::Box { lo, .. } => lo,
                Body::Circle { c, .. } => c,
            };
            if p.0.abs().max(p.1.abs()) > LIMIT {
                continue;
            }
            let within = match random.below(4) {
                0 => random.magnitude(LIMIT),
                1 => level.cell / 2,
                _ => random.magnitude(4 * level.cell),
            };
            found += u64::from(check_near(&level, &judge, p, within));
            inside += u64::from(judge.is_inside(p));
            done += 1;
        }
    }
    assert!(found > done / 4 && inside > done / 8, "{found} found, {inside} inside of {done}");
}

type Found = heapless::Vec<WorldContact, 64>;

fn contacts<B: Pushable>(map: &TileMap<'_, AllShapes>, b: &B) -> Found {
    let mut out = Found::new();
    map.contacts(b, OneWay::Ignore, &mut out).unwrap();
    out
}

/// A view with less room holds the first of the list.
fn check_truncated<B: Pushable>(map: &TileMap<'_, AllShapes>, b: &B, all: &Found) {
    let mut two = heapless::Vec::<WorldContact, 2>::new();
    let result = map.contacts(b, OneWay::Ignore, &mut two).map(|_| ());
    assert_eq!(two, all[..all.len().min(2)]);
    let truncated = Err(Truncated { seen: all.len() as u32, kept: 2 });
    assert_eq!(result, if all.len() > 2 { truncated } else { Ok(()) });
}

fn check_list(level: &Level, judge: &Judge, body: Body) -> usize {
    let map = level.all();
    let (found, bounds) = match body {
        Body::Circle { c, r } => {
            let b = Circle::new(vec2(c), Fx::from_bits(r as i32)).unwrap();
            (contacts(&map, &b), b.aabb())
        }
        Body::Box { lo, hi } => {
            let b = Aabb::new(vec2(lo), vec2(hi)).unwrap();
            (contacts(&map, &b), b)
        }
    };
    match body {
        Body::Circle { c, r } => check_truncated(&map, &Circle::new(vec2(c), Fx::from_bits(r as i32)).unwrap(), &found),
        Body::Box { .. } => check_truncated(&map, &bounds, &found),
    }
    let case = || format!("{found:?}\n{body:?} {level:?}");
    let (middle, end) = (point(bounds.centre()), wide(point(bounds.min())));
    let odd = wide(point(bounds.max()));
    let up = (middle.0 + ((end.0 + odd.0) % 2 != 0) as i64, middle.1 + ((end.1 + odd.1) % 2 != 0) as i64);
    let behind = judge.overlaps(Body::Box { lo: middle, hi: up });
    // The list contains exactly the contacts of the definitions, once each.
    let mut expected: Vec<(Feature, Expected)> = map
        .features(&bounds)
        .filter(|f| !f.one_way)
        .filter_map(|f| Some((f, Expected::of(&f, body, middle, behind)?)))
        .collect();
    // If a box is in no region, the least of the other contacts represents all. For a circle all
    // count.
    if expected.iter().any(|(_, e)| e.in_region) {
        expected.retain(|(_, e)| e.in_region);
    } else if matches!(body, Body::Box { .. }) {
        let least = expected.iter().map(|(_, e)| e.depth).fold(f64::INFINITY, f64::min);
        expected.retain(|(f, e)| e.depth < least + 1e-4 && found.iter().any(|c| c.feature() == *f));
    }
    let mut last = 0.0;
    for contact in &found {
        let at = expected.iter().position(|(f, _)| *f == contact.feature());
        let (feature, expected) = expected.swap_remove(at.unwrap_or_else(|| panic!("{contact:?} of {}", case())));
        let (depth, axis) = (f64::from(contact.depth().to_bits()), contact.axis());
        assert!(expected.depth - 1e-4 < depth && depth < expected.depth + 1.0 + 1e-4, "{expected:?} {}", case());
        // The nearest first: by the distance from a circle's centre, or the way out of a box.
        let rank = if let Body::Circle { r, .. } = body { (r as f64 - expected.depth).abs() } else { expected.depth };
        assert!(rank >= last - 1e-4, "{}", case());
        last = rank;
        let length = f64::from(axis.x).hypot(f64::from(axis.y));
        let cosine = (f64::from(axis.x) * expected.normal.0 + f64::from(axis.y) * expected.normal.1) / length;
        assert!(contact.is_degenerate() || cosine > 1.0 - 1e-9, "{contact:?} {expected:?} {}", case());
        let push = point(contact.push_out());
        let size = (push.0 as f64).hypot(push.1 as f64);
        assert!(size < expected.depth + 8.0, "{push:?} {expected:?} {}", case());
        let pushed = match body {
            Body::Circle { c, r } => Body::Circle { c: (c.0 + push.0, c.1 + push.1), r },
            Body::Box { lo, hi } => {
                Body::Box { lo: (lo.0 + push.0, lo.1 + push.1), hi: (hi.0 + push.0, hi.1 + push.1) }
            }
        };
        assert!(Expected::is_clear(&feature, pushed), "{contact:?} leaves {pushed:?}, {}", case());
        let q = point(contact.point());
        assert!(judge.near_surface(q, 3), "{q:?} {contact:?} {}", case());
    }
    assert!(expected.is_empty(), "missing {expected:?}\n{}", case());
    let area = match body {
        Body::Circle { r, .. } => r > 0,
        Body::Box { lo, hi } => lo.0 < hi.0 && lo.1 < hi.1,
    };
    if area {
        assert_eq!(judge.overlaps(body), behind || !found.is_empty(), "{}", case());
    }
    found.len()
}

#[test]
fn contacts_equal_the_definitions() {
    let mut random = Random::new(42);
    let (mut done, mut some, mut many) = (0u64, 0u64, 0u64);
    while done < cases(40_000) {
        let level = mosaic(&mut random);
        let judge = Judge::new(&level);
        for _ in 0..25 {
            let body = body(&mut random, &level);
            if in_domain(body) {
                let n = check_list(&level, &judge, body);
                some += u64::from(n > 0);
                many += u64::from(n > 2);
                done += 1;
            }
        }
    }
    assert!(some > done / 5 && many > done / 50, "{some} with contacts, {many} with many, of {done}");
    println!("{some} with contacts, {many} with many, of {done}");
}

/// The same level in a mirror, x negated.
fn mirrored(level: &Level) -> Level {
    let side = |id: u8| match id {
        // Halves and one-way tiles: right and left. All others: each corner and the one beside it.
        3 | 35 => id + 2,
        5 | 37 => id - 2,
        6..=33 => ((id - 2) ^ 1) + 2,
        _ => id,
    };
    let (w, h) = (level.width, level.height);
    let at = |i: i64| side(level.tiles[(i / w * w + w - 1 - i % w) as usize]);
    Level { x: -level.x - w * level.cell, tiles: (0..w * h).map(at).collect(), ..level.clone() }
}

#[test]
fn mirrored_scenes_give_mirrored_bits() {
    let mut random = Random::new(43);
    let mut done = 0u64;
    let flip = |v: Vec2| Vec2::from_raw(-v.raw().0, v.raw().1);
    while done < cases(15_000) {
        let level = mosaic(&mut random);
        let other = mirrored(&level);
        for _ in 0..25 {
            let Body::Circle { c, r } = body(&mut random, &level) else { continue };
            if !in_domain(Body::Circle { c, r }) {
                continue;
            }
            let ball = Circle::new(vec2(c), Fx::from_bits(r as i32)).unwrap();
            let image = Circle::new(flip(vec2(c)), ball.radius()).unwrap();
            let tell = |c: &WorldContact, f: &dyn Fn(Vec2) -> Vec2| {
                let axis = f(Vec2::from_raw(c.axis().x, c.axis().y)).raw();
                (c.depth().to_bits(), axis, f(c.push_out()).raw(), f(c.point()).raw())
            };
            let list = |level: &Level, b: &Circle, f: &dyn Fn(Vec2) -> Vec2| {
                let all = contacts(&level.all(), b);
                let mut all: Vec<_> = all.iter().map(|c| tell(c, f)).collect();
                all.sort_unstable();
                all
            };
            assert_eq!(list(&level, &ball, &|v| v), list(&other, &image, &flip), "{ball:?} {level:?}");
            let near = |level: &Level, p: Vec2| {
                let near = level.all().closest_point(p, Fx::from_bits(LIMIT as i32), OneWay::Include).unwrap();
                near.map(|n| (n.distance, n.inside))
            };
            assert_eq!(near(&level, ball.centre()), near(&other, image.centre()), "{ball:?} {level:?}");
            done += 1;
        }
    }
}

/// Cells of 16 units.
fn level(width: i64, tiles: &[u8]) -> Level {
    let height = tiles.len() as i64 / width;
    Level { width, height, cell: 16 << 16, x: 0, y: 0, outside: Outside::Empty, tiles: tiles.into() }
}

fn units(x: i64, y: i64) -> (i64, i64) {
    (x << 16, y << 16)
}

fn told(found: &Found) -> Vec<(u16, (i32, i32), f64)> {
    found.iter().map(|c| (c.feature().index, (c.axis().x, c.axis().y), c.depth().to_num())).collect()
}

fn ball(x: i64, y: i64, r: i64) -> Circle {
    Circle::new(vec2(units(x, y)), Fx::from_num(r)).unwrap()
}

#[test]
fn a_ball_in_a_quarter_pipe() {
    // Solid at the bottom left; the pipe's centre is (16, 0).
    let level = level(1, &[17]);
    // 3-4-5: the ball is 10 from the centre, its far side 14.
    let found = contacts(&level.all(), &ball(10, 8, 4));
    assert!(found.is_empty());
    let found = contacts(&level.all(), &ball(10, 8, 7));
    assert_eq!(told(&found), [(8, (6, -8), 1.0)].map(|(i, a, d)| (i, (a.0 << 16, a.1 << 16), d)));
    assert_eq!(found[0].push_out(), Vec2::from_raw(39322, -52429));
    assert_eq!(found[0].point(), Vec2::from_raw(419_430, 838_861)); // (6.4, 12.8)
    // From the centre everything is equally near.
    let found = contacts(&level.all(), &ball(16, 0, 17));
    let arc = found.iter().find(|c| c.feature().index == 8).unwrap();
    assert!(arc.is_degenerate() && arc.axis() == Axis::X && arc.depth() == 1);
    let near = level.all().closest_point(vec2(units(16, 0)), Fx::from_num(17), OneWay::Ignore).unwrap().unwrap();
    assert_eq!((near.point, near.distance.to_num()), (vec2(units(0, 0)), 16));
}

/// Into the gap of a pipe beside a ball that almost fills it: a raw unit around the centre, or two,
/// or nothing.
#[test]
fn a_ball_that_fills_a_pipe_is_pushed_to_its_centre() {
    let level = level(1, &[17]);
    let side = 16i64 << 16;
    let mut met = 0;
    for room in 0..5 {
        for (x, y) in [(0, 0), (1, 1), (0, 1), (3, 4), (300, 1), (70_000, 50_000), (12_345, 67_890), (1, 100_003)] {
            let c = Circle::new(vec2((side - x, y)), Fx::from_bits((side - room) as i32)).unwrap();
            let found = contacts(&level.all(), &c);
            let arc = found.iter().find(|c| c.feature().index == 8);
            // Touching all of it from the centre is no overlap.
            assert_eq!(arc.is_some(), x * x + y * y > room * room, "{room} {x} {y}");
            if let Some(arc) = arc {
                let push = point(arc.push_out());
                let (x, y) = (x - push.0, y + push.1);
                assert!(x >= 0 && y >= 0 && x * x + y * y <= room * room, "{room} {x} {y}");
                met += 1;
            }
        }
    }
    assert!(met > 25, "{met}");
}

/// From inside, where two arcs meet in a concave corner, its point is nearest: no foot, no vertex.
#[test]
fn the_end_of_arcs_is_near_from_inside() {
    for (width, tiles, p) in [(2, [1, 10, 1, 13], (12, 16)), (2, [13, 12, 1, 1], (16, 20))] {
        let level = level(width, &tiles);
        let near = level.all().closest_point(vec2(units(p.0, p.1)), Fx::from_num(9), OneWay::Ignore).unwrap().unwrap();
        assert_eq!((near.point, near.distance.to_num::<i32>(), near.inside), (vec2(units(16, 16)), 4, true));
        let out = (16 - p.0, 16 - p.1);
        assert_eq!((i64::from(near.axis.x.signum()), i64::from(near.axis.y.signum())), (out.0 / 4, out.1 / 4));
    }
}

/// A raw unit or more behind a concave corner of blocks and of slopes, no normal passes the centre.
/// The faces that end there push it out.
#[test]
fn behind_a_concave_corner() {
    let corner = level(2, &[0, 1, 1, 1]);
    let v = level(4, &[9, 0, 0, 8, 1, 9, 8, 1, 1, 1, 1, 1]);
    for r in [3, 100, 200_000] {
        for (x, y) in (1..r.min(40)).flat_map(|x| (1..r.min(40)).map(move |y| (x, y))) {
            // It covers the corner of both.
            if 2 * (x * x + y * y) >= r * r {
                continue;
            }
            for (level, c) in [(&corner, (16 << 16, 16 << 16)), (&v, (32 << 16, 32 << 16))] {
                let at = if level.width == 2 { (c.0 + x, c.1 + y) } else { (c.0 + x - y, c.1 + x + y) };
                let ball = Circle::new(vec2(at), Fx::from_bits(r as i32)).unwrap();
                let map = level.all();
                assert!(map.overlaps(&ball));
                let found = contacts(&map, &ball);
                assert!(!found.is_empty(), "{r} {x} {y}");
                // The nearest, then the rest.
                let mut out = ball;
                for _ in 0..3 {
                    let found = contacts(&map, &out);
                    let Some(first) = found.first() else { break };
                    out = out.translated(first.push_out()).unwrap();
                }
                assert!(!map.overlaps(&out), "{r} {x} {y}: {found:?} {out:?}");
            }
        }
    }
}

#[test]
fn the_far_side_of_a_thin_wall_is_no_way_out() {
    let level = level(3, &[0, 5, 0]); // solid from x = 16 to 24
    assert_eq!(told(&contacts(&level.all(), &ball(14, 8, 12))), [(3, (-1, 0), 10.0)]);
    // From inside it is: the nearer side first.
    assert_eq!(told(&contacts(&level.all(), &ball(19, 8, 6))), [(3, (-1, 0), 9.0), (8, (1, 0), 11.0)]);
    let thin = Aabb::new(vec2(units(4, 2)), vec2(units(26, 6))).unwrap();
    assert_eq!(told(&contacts(&level.all(), &thin)), [(3, (-1, 0), 10.0)]);
}

#[test]
fn a_box_on_a_peak_is_pushed_up() {
    let level = level(2, &[8, 9]); // a peak at (16, 0)
    let b = Aabb::new(vec2(units(10, -7)), vec2(units(23, 1))).unwrap();
    assert_eq!(told(&contacts(&level.all(), &b)), [(9, (0, -1), 1.0)]);
}

#[test]
fn one_way_faces_come_on_request_and_from_their_front() {
    let level = level(1, &[34]);
    let map = level.all();
    let mut out = Found::new();
    for (y, include, expected) in [(-3, OneWay::Ignore, 0), (-3, OneWay::Include, 1), (1, OneWay::Include, 0)] {
        assert_eq!(map.contacts(&ball(8, y, 4), include, &mut out), Ok(1));
        assert_eq!(out.len(), expected, "{y} {include:?}");
        let near = map.closest_point(vec2(units(8, y)), Fx::from_num(4), include).unwrap();
        assert_eq!(near.map(|n| (n.feature.one_way, n.inside)), (expected == 1).then_some((true, false)));
    }
}

#[test]
fn inputs_outside_of_the_domain_are_refused() {
    let level = level(1, &[1]);
    let ask = |x: i32, within: i32| {
        let near = level.all().closest_point(Vec2::from_raw(x, 0), Fx::from_bits(within), OneWay::Ignore);
        near.map(|near| near.map(|near| near.distance.to_bits())).map_err(|e| (e.what, e.value))
    };
    assert_eq!(ask(1 << 29, 0), Err((Quantity::X, 1 << 29)));
    assert_eq!(ask(0, -1), Err((Quantity::Radius, -1)));
    assert_eq!(ask(-1, 0), Ok(None));
    assert_eq!(ask(-1, 1), Ok(Some(1)));
    assert_eq!(ask(1 - (1 << 29), (1 << 29) - 1), Ok(Some((1 << 29) - 1)));
}
