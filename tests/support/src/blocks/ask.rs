//! Rays and bodies near the interesting points of a level of blocks, and the check of everything
//! that a ray reports.

use crate::Random;
use crate::blocks::bodies::Body;
use crate::blocks::build;
use crate::blocks::level::Level;
use crate::blocks::rays::{Scene, cells_entered};
use tilesat::{Aabb, Cell, Circle, Fx, Inside, TileMap, Vec2};

pub fn vec2((x, y): (i64, i64)) -> Vec2 {
    Vec2::from_raw(x as i32, y as i32)
}

/// Compares everything that a ray reports.
pub fn check_ray(level: &Level, scene: &Scene, map: &TileMap, o: (i64, i64), d: (i64, i64)) -> bool {
    let mut hit_any = false;
    for inside in [Inside::Ignore, Inside::Hit] {
        let got = map.cast_ray(vec2(o), vec2(d), inside).unwrap();
        let expected = scene.cast(o, d, inside == Inside::Hit);
        let case = || format!("{level:?}\nfrom {o:?} by {d:?}, {inside:?}\ngot {got:?}\nexpected {expected:?}");
        match (&got, &expected) {
            (None, None) => {}
            (Some(hit), Some(expected)) => {
                hit_any = true;
                assert_eq!(hit.toi.raw(), expected.toi(), "toi: {}", case());
                assert_eq!(hit.point, vec2(expected.point(o, d)), "point: {}", case());
                assert_eq!((hit.axis.x, hit.axis.y), expected.axis(d), "axis: {}", case());
                assert_eq!(hit.inside, expected.inside, "inside: {}", case());
                let at = |&(c, r): &(i64, i64)| {
                    let repeated = level.outside == tilesat::Outside::Edge;
                    let clamp = |v: i64, n: i64| if repeated { v.clamp(0, n - 1) } else { v };
                    Cell::new(clamp(c, level.width) as i16, clamp(r, level.height) as i16)
                };
                assert!(expected.owners.iter().any(|owner| at(owner) == hit.cell), "cell: {}", case());
                assert_eq!(hit.flags, map.kind(hit.cell).flags, "flags: {}", case());
                // At a corner, a ray may report a hit in a cell beside it before it counts the
                // other line.
                let entered = cells_entered(level, o, d, expected.num, expected.den);
                assert!(entered.contains(&hit.cells), "cells: {entered:?} {}", case());
                assert!(i64::from(hit.cells) <= level.width + level.height + 4);
            }
            _ => panic!("{}", case()),
        }
    }
    hit_any
}

/// A ray of one of the classes: mixed coordinates, along lines, through corners, one raw wide, of
/// no length, across the domain.
pub fn ray(random: &mut Random, level: &Level) -> ((i64, i64), (i64, i64)) {
    let limit = (1i64 << 29) - 1;
    let o = build::point(random, level);
    let end = match random.below(10) {
        0 => (o.0, build::point(random, level).1),
        1 => (build::point(random, level).0, o.1),
        2 => o,
        3 => (o.0 + random.around(1), build::point(random, level).1),
        4 => (build::point(random, level).0, o.1 + random.around(1)),
        5 => {
            // Through a corner or one raw beside it, with a small direction, so that it meets more
            // corners.
            let corner = (
                level.x + level.cell * random.within(0, level.width),
                level.y + level.cell * random.within(0, level.height),
            );
            let (p, q, k) = (random.around(3), random.around(3), level.cell * random.within(1, 8) / 2);
            let from = (corner.0 - p * k + random.around(1), corner.1 - q * k);
            let to = (from.0 + 2 * p * k, from.1 + 2 * q * k);
            if [from.0, from.1, to.0, to.1].iter().all(|v| v.abs() <= limit) {
                return (from, (to.0 - from.0, to.1 - from.1));
            }
            build::point(random, level)
        }
        6 => (random.sign() * limit, random.around(limit)),
        7 => (o.0 + random.around(8), o.1 + random.around(8)),
        _ => build::point(random, level),
    };
    let end = (end.0.clamp(-limit, limit), end.1.clamp(-limit, limit));
    (o, (end.0 - o.0, end.1 - o.1))
}

pub fn body(random: &mut Random, level: &Level) -> Body {
    let limit = (1i64 << 29) - 1;
    let (x, y) = build::point(random, level);
    if random.one_in(2) {
        let (u, v) = match random.below(4) {
            0 => (x, build::point(random, level).1),
            1 => (build::point(random, level).0, y),
            2 => (x + random.magnitude(level.cell), y + random.magnitude(level.cell)),
            _ => build::point(random, level),
        };
        let (u, v) = (u.min(limit), v.min(limit));
        Body::Box { x0: x.min(u), y0: y.min(v), x1: x.max(u), y1: y.max(v) }
    } else {
        // Often exactly as far as a corner, by a Pythagorean triple, or one raw more or less.
        let (x, y, r) = match random.below(4) {
            0 => (x, y, random.magnitude(level.cell * 3)),
            1 => (x, y, 0),
            _ => {
                let corner = (
                    level.x + level.cell * random.within(0, level.width),
                    level.y + level.cell * random.within(0, level.height),
                );
                let (a, b, c) = [(3, 4, 5), (8, 15, 17), (20, 21, 29), (0, 1, 1), (1, 0, 1)][random.below(5) as usize];
                let k = random.magnitude(level.cell / 10) + 1;
                let x = corner.0 + random.sign() * a * k;
                let y = corner.1 + random.sign() * b * k;
                (x, y, (c * k + random.around(1)).max(0))
            }
        };
        if x.abs().max(y.abs()) + r > limit {
            return Body::Circle { x: x.clamp(-limit, limit), y: y.clamp(-limit, limit), r: 0 };
        }
        Body::Circle { x, y, r }
    }
}

#[derive(Clone, Copy)]
pub enum Shape {
    Box(Aabb),
    Circle(Circle),
}

pub fn shape(body: Body) -> Shape {
    match body {
        Body::Box { x0, y0, x1, y1 } => Shape::Box(Aabb::new(vec2((x0, y0)), vec2((x1, y1))).unwrap()),
        Body::Circle { x, y, r } => Shape::Circle(Circle::new(vec2((x, y)), Fx::from_bits(r as i32)).unwrap()),
    }
}
