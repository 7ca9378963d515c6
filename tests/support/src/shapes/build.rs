//! Random levels of all shapes, and bodies that are close to something in them.

use super::judge::Body;
use super::level::Level;
use crate::Random;
use crate::blocks::build::{CELLS, OUTSIDES, coordinate};

pub const LIMIT: i64 = (1 << 29) - 1;

pub fn mosaic(random: &mut Random) -> Level {
    let (width, height) = (random.within(1, 4), random.within(1, 4));
    let cell = CELLS[random.below(CELLS.len() as i64) as usize];
    let origin = |random: &mut Random, count: i64| {
        let (lowest, highest) = (-LIMIT, LIMIT - count * cell);
        match random.below(4) {
            0 => 0,
            1 => lowest,
            2 => highest,
            _ => random.within(lowest, highest),
        }
    };
    let (x, y) = (origin(random, width), origin(random, height));
    // From one shape in the void to many, with whole cells between.
    let density = random.within(1, 10);
    let tiles = (0..width * height)
        .map(|_| if random.below(10) < density { random.below(38) as u8 } else { random.below(2) as u8 });
    let tiles = tiles.collect();
    Level { width, height, cell, x, y, outside: OUTSIDES[random.below(3) as usize], tiles }
}

const TRIPLES: [(i64, i64, i64); 6] = [(3, 4, 5), (8, 15, 17), (20, 21, 29), (7, 24, 25), (0, 1, 1), (1, 0, 1)];

/// A circle that touches something exactly, or misses by a raw unit or two: a lattice point, an arc
/// from outside or inside, a slope to the next raw unit.
fn close_circle(random: &mut Random, level: &Level) -> Body {
    let half = level.cell / 2;
    let corner = |random: &mut Random, step: i64| {
        let n = 2 * half / step;
        (level.x + step * random.within(0, n * level.width), level.y + step * random.within(0, n * level.height))
    };
    let (a, b, c) = TRIPLES[random.below(6) as usize];
    let (a, b) = (a * random.sign(), b * random.sign());
    let slack = random.around(2);
    let (centre, r) = match random.below(4) {
        0 => {
            let k = random.magnitude(level.cell / 8) + 1;
            let p = corner(random, half);
            ((p.0 + a * k, p.1 + b * k), c * k)
        }
        // Outside a disc, k c from its centre. Inside, the radius is the rest.
        1 => {
            let k = level.cell / c + random.magnitude(level.cell / 8) + 1;
            let p = corner(random, 2 * half);
            ((p.0 + a * k, p.1 + b * k), c * k - level.cell)
        }
        2 => {
            let k = random.within(0, level.cell / c);
            let p = corner(random, 2 * half);
            ((p.0 + a * k, p.1 + b * k), level.cell - c * k)
        }
        // The distance from a slope through a lattice point, rounded.
        _ => {
            let (p, q) = [(1, 1), (1, 2), (2, 1)][random.below(3) as usize];
            let at = corner(random, half);
            let m = (random.around(level.cell), random.around(level.cell));
            let distance = i128::from(p * m.0 + q * random.sign() * m.1).pow(2) / i128::from(p * p + q * q);
            ((at.0 + m.0, at.1 + m.1), distance.isqrt() as i64)
        }
    };
    Body::Circle { c: centre, r: r + slack }
}

pub fn body(random: &mut Random, level: &Level) -> Body {
    let point = |random: &mut Random| {
        // On the lattice of half cells and beside it as well.
        let half = if random.one_in(3) { level.cell / 2 } else { 0 };
        let x = coordinate(random, level.x, level.width, level.cell) + half;
        let y = coordinate(random, level.y, level.height, level.cell) + half;
        (x.clamp(-LIMIT, LIMIT), y.clamp(-LIMIT, LIMIT))
    };
    let (p, q) = (point(random), point(random));
    let near = |random: &mut Random, v: i64| v + random.magnitude(level.cell);
    match random.below(8) {
        0 => Body::Box { lo: p, hi: p },
        1 => Body::Box { lo: (p.0.min(q.0), p.1), hi: (p.0.max(q.0), p.1) },
        2 => Body::Box { lo: (p.0, p.1.min(q.1)), hi: (p.0, p.1.max(q.1)) },
        3 => Body::Box { lo: (p.0.min(q.0), p.1.min(q.1)), hi: (p.0.max(q.0), p.1.max(q.1)) },
        4 => {
            // A corner on a slope through a lattice point, or a raw unit or two beside it.
            let k = random.magnitude(level.cell);
            let (a, b) = [(1, 1), (2, 1), (1, 2)][random.below(3) as usize];
            let c = (p.0 + a * k * random.sign() + random.around(2), p.1 + b * k * random.sign());
            Body::Box { lo: c, hi: (near(random, c.0), near(random, c.1)) }
        }
        5 => Body::Circle { c: p, r: random.magnitude(level.cell * 3) },
        _ => close_circle(random, level),
    }
}

pub fn in_domain(body: Body) -> bool {
    match body {
        Body::Box { lo, hi } => [lo.0, lo.1, hi.0, hi.1].iter().all(|v| v.abs() <= LIMIT),
        Body::Circle { c, r } => r >= 0 && c.0.abs().max(c.1.abs()) + r <= LIMIT,
    }
}
