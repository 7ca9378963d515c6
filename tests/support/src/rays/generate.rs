//! Rays of every kind that ever failed.

use super::cast::{Line, Scene};
use super::level::Level;
use super::solid::Point;
use crate::Random;

const LIMIT: i64 = (1 << 29) - 1;

fn near(p: Point, random: &mut Random) -> Point {
    (p.0 + random.around(1), p.1 + random.around(1))
}

fn clamped(p: Point) -> Point {
    (p.0.clamp(-LIMIT, LIMIT), p.1.clamp(-LIMIT, LIMIT))
}

/// On the lattice of half cells in and around the level.
fn lattice(random: &mut Random, level: &Level) -> Point {
    let on = |random: &mut Random, origin: i64, count: i64| origin + level.cell / 2 * random.within(-2, 2 * count + 2);
    (on(random, level.origin.0, level.width), on(random, level.origin.1, level.height))
}

fn anywhere(random: &mut Random, level: &Level) -> Point {
    let end = level.end();
    let x = random.within(level.origin.0 - level.cell, end.0 + level.cell);
    (x, random.within(level.origin.1 - level.cell, end.1 + level.cell))
}

/// A lattice point on a piece: of a line a multiple of its direction, of an arc an end or a
/// Pythagorean point.
fn on_surface(random: &mut Random, scene: &Scene) -> Option<Point> {
    let pieces = &scene.pieces;
    if pieces.is_empty() {
        return None;
    }
    match pieces[random.below(pieces.len() as i64) as usize].line {
        Line::Straight { a, b } => {
            let (w, h) = (b.0 - a.0, b.1 - a.1);
            let steps = if w == 0 || h == 0 { w.abs().max(h.abs()) } else { w.abs().min(h.abs()) };
            let k = match random.below(4) {
                0 => 0,
                1 => steps,
                2 => random.within(0, 2).min(steps),
                _ => random.within(0, steps),
            };
            Some((a.0 + w / steps * k, a.1 + h / steps * k))
        }
        Line::Round { centre, radius, quadrant, .. } => {
            let (p, q, r) = [(3, 4, 5), (4, 3, 5), (1, 0, 1), (0, 1, 1), (5, 12, 13)][random.below(5) as usize];
            Some((centre.0 + quadrant.0 * radius * p / r, centre.1 + quadrant.1 * radius * q / r))
        }
    }
}

fn point(random: &mut Random, level: &Level, scene: &Scene) -> Point {
    let p = match random.below(8) {
        0 | 1 => lattice(random, level),
        2 => {
            let p = lattice(random, level);
            near(p, random)
        }
        3 | 4 => on_surface(random, scene).unwrap_or((0, 0)),
        5 => {
            let p = on_surface(random, scene).unwrap_or((0, 0));
            near(p, random)
        }
        6 if random.one_in(3) => (random.around(LIMIT), random.around(LIMIT)),
        _ => anywhere(random, level),
    };
    clamped(p)
}

/// A ray: start and motion.
pub fn ray(random: &mut Random, level: &Level, scene: &Scene) -> (Point, Point) {
    let o = point(random, level, scene);
    let end = point(random, level, scene);
    let along = |d: Point, k: i64| (d.0 * k, d.1 * k);
    let (o, end) = match random.below(10) {
        // Along a line of the lattice or beside it.
        0 => (o, (o.0, end.1)),
        1 => (o, (end.0, o.1)),
        2 => (o, (o.0 + random.around(1), end.1)),
        // Through a point of the surface or of the lattice, in a small direction.
        3 | 4 => {
            let p = if random.one_in(2) { lattice(random, level) } else { on_surface(random, scene).unwrap_or(o) };
            let d = (random.around(4), random.around(4));
            let k = level.cell / random.within(1, 8);
            let (back, on) = (along(d, -k * random.within(0, 3)), along(d, k * random.within(0, 3)));
            let p = if random.one_in(4) { near(p, random) } else { p };
            ((p.0 + back.0, p.1 + back.1), (p.0 + on.0, p.1 + on.1))
        }
        // A tangent of a circle, or almost.
        5 | 6 => {
            let arcs: Vec<_> = scene.pieces.iter().filter(|p| matches!(p.line, Line::Round { .. })).collect();
            if arcs.is_empty() {
                (o, end)
            } else {
                let Line::Round { centre, radius, quadrant, .. } = arcs[random.below(arcs.len() as i64) as usize].line
                else {
                    unreachable!()
                };
                let (p, q, r) =
                    [(3, 4, 5), (4, 3, 5), (1, 0, 1), (0, 1, 1), (5, 12, 13), (-3, 4, 5)][random.below(6) as usize];
                let touch = (centre.0 + quadrant.0 * radius * p / r, centre.1 + quadrant.1 * radius * q / r);
                let d = (-quadrant.0 * q * random.sign(), quadrant.1 * p);
                let d = if random.one_in(2) { d } else { (-quadrant.0 * q, quadrant.1 * p) };
                let k = radius / r * random.within(1, 3);
                let touch = if random.one_in(3) { near(touch, random) } else { touch };
                let (from, to) = (random.within(0, 1), random.within(0, 1));
                ((touch.0 - d.0 * k * from, touch.1 - d.1 * k * from), (touch.0 + d.0 * k * to, touch.1 + d.1 * k * to))
            }
        }
        // Exactly to a point, or one raw short.
        7 => (o, (end.0 - (end.0 - o.0).signum(), end.1 - (end.1 - o.1).signum())),
        8 => (o, near(o, random)),
        _ => (o, end),
    };
    let (o, end) = (clamped(o), clamped(end));
    (o, (end.0 - o.0, end.1 - o.1))
}
