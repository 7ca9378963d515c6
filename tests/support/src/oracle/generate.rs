//! Streams of shape pairs: the hard classes, and the plain one.

use super::figure::{Figure, Kind, LIMIT, Point};
use crate::Random;

/// One length unit in 16.16.
pub const UNIT: i64 = 1 << 16;
/// Extent of an ordinary scene: 64 units.
const SCENE: i64 = 64 * UNIT;
const FAR: i64 = 8000 * UNIT;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Class {
    /// Anywhere in an ordinary scene.
    Uniform,
    /// Constructed to touch, then every number moved by up to 2 raw.
    Near,
    /// Touching exactly.
    Exact,
    /// The three above, 8000 units from the origin.
    Far,
    /// Up to the ends of the domain, extremes and long touching shapes included.
    Domain,
    /// One inside the other, tiny and flat shapes included.
    Deep,
}

pub const CLASSES: [Class; 6] = [Class::Uniform, Class::Near, Class::Exact, Class::Far, Class::Domain, Class::Deep];

#[derive(Clone, Copy, Debug)]
pub struct Pairs {
    pub random: Random,
    pair: (Kind, Kind),
    class: Class,
}

impl Pairs {
    pub fn new(pair: (Kind, Kind), class: Class, seed: u64) -> Self {
        Self {
            random: Random::new(seed ^ (pair.0 as u64) << 40 ^ (pair.1 as u64) << 44 ^ (class as u64) << 48),
            pair,
            class,
        }
    }

    /// The next pair, inside the domain, in the order of kinds asked for.
    #[allow(clippy::should_implement_trait, reason = "it never ends, and is no iterator")]
    pub fn next(&mut self) -> (Figure, Figure) {
        loop {
            let (a, b) = self.propose();
            if a.in_domain() && b.in_domain() {
                return (a, b);
            }
        }
    }

    fn propose(&mut self) -> (Figure, Figure) {
        let r = &mut self.random;
        match self.class {
            Class::Uniform => (anywhere(r, self.pair.0, SCENE), anywhere(r, self.pair.1, SCENE)),
            Class::Near => shift(near(r, self.pair, SCENE / 4), (r.around(SCENE), r.around(SCENE))),
            Class::Exact => shift(exact(r, self.pair, SCENE / 4), (r.around(SCENE), r.around(SCENE))),
            Class::Far => {
                let by = (r.sign() * (FAR + r.around(SCENE)), r.sign() * (FAR + r.around(SCENE)));
                match r.below(3) {
                    0 => shift((anywhere(r, self.pair.0, SCENE), anywhere(r, self.pair.1, SCENE)), by),
                    1 => shift(near(r, self.pair, SCENE / 4), by),
                    _ => shift(exact(r, self.pair, SCENE / 4), by),
                }
            }
            Class::Domain => {
                let by = (r.around(LIMIT - 1), r.around(LIMIT - 1));
                match r.below(5) {
                    0 => (extreme(r, self.pair.0), extreme(r, self.pair.1)),
                    1 => shift(near(r, self.pair, LIMIT), by),
                    2 => shift(exact(r, self.pair, LIMIT), by),
                    _ => (anywhere(r, self.pair.0, LIMIT - 1), anywhere(r, self.pair.1, LIMIT - 1)),
                }
            }
            Class::Deep => deep(r, self.pair),
        }
    }
}

fn shift(pair: (Figure, Figure), by: Point) -> (Figure, Figure) {
    (pair.0.moved(by), pair.1.moved(by))
}

/// A box given by any two opposite corners.
pub fn aabb(p: Point, q: Point) -> Figure {
    Figure::Aabb { min: (p.0.min(q.0), p.1.min(q.1)), max: (p.0.max(q.0), p.1.max(q.1)) }
}

/// A shape in the square of half side `extent`, up to half of it in size.
fn anywhere(r: &mut Random, kind: Kind, extent: i64) -> Figure {
    let centre = (r.around(extent), r.around(extent));
    // Large shapes in the whole domain would leave it. Every other time, tries the remaining room
    // at this position.
    let room = if r.one_in(2) { extent - centre.0.abs().max(centre.1.abs()) } else { extent / 2 };
    sized(r, kind, centre, room)
}

fn sized(r: &mut Random, kind: Kind, c: Point, size: i64) -> Figure {
    // Sometimes flat in one direction or both.
    let (w, h) = (if r.one_in(16) { 0 } else { size }, if r.one_in(16) { 0 } else { size });
    match kind {
        Kind::Aabb => {
            let half = (r.within(0, w), r.within(0, h));
            Figure::Aabb { min: (c.0 - half.0, c.1 - half.1), max: (c.0 + half.0, c.1 + half.1) }
        }
        Kind::Circle => Figure::Circle { centre: c, radius: r.within(0, w) },
        Kind::Segment => Figure::Segment { a: c, b: (c.0 + r.around(w), c.1 + r.around(h)) },
    }
}

/// Coordinates at, next to, and a power of two away from the ends of the domain.
fn extreme(r: &mut Random, kind: Kind) -> Figure {
    fn coordinate(r: &mut Random) -> i64 {
        let n = match r.below(5) {
            0 => LIMIT - 1,
            1 => LIMIT - 1 - r.below(3),
            2 => 1 << r.below(29),
            3 => r.below(3),
            _ => r.below(LIMIT),
        };
        r.sign() * n
    }
    let (p, q) = ((coordinate(r), coordinate(r)), (coordinate(r), coordinate(r)));
    match kind {
        Kind::Aabb => aabb(p, q),
        // A circle stays in the domain with its whole extent: the largest that fits, or a smaller
        // one.
        Kind::Circle => {
            let room = LIMIT - 1 - p.0.abs().max(p.1.abs());
            Figure::Circle { centre: p, radius: if r.one_in(2) { room } else { room.min(q.0.abs()) } }
        }
        Kind::Segment => Figure::Segment { a: p, b: q },
    }
}

/// The second shape starts from a vertex, the centre or some point of the first.
fn deep(r: &mut Random, pair: (Kind, Kind)) -> (Figure, Figure) {
    let size = 1 + r.magnitude(SCENE);
    let a = sized(r, pair.0, (0, 0), size);
    let (corners, count) = a.corners();
    let from = corners[r.below(count as i64) as usize];
    let to = corners[r.below(count as i64) as usize];
    let (i, n) = (r.within(0, 4), 4);
    let start = (from.0 + (to.0 - from.0) * i / n, from.1 + (to.1 - from.1) * i / n);
    let off = r.magnitude(size);
    let start = if r.one_in(2) { start } else { (start.0 + r.around(off), start.1 + r.around(off)) };
    let other = 1 + r.magnitude(SCENE);
    let b = match sized(r, pair.1, start, other) {
        // Beyond the starting point on both sides, so that it crosses the first shape.
        Figure::Segment { a, b } => {
            let back = r.within(0, 2);
            Figure::Segment { a: (a.0 - (b.0 - a.0) * back / 2, a.1 - (b.1 - a.1) * back / 2), b }
        }
        b => b,
    };
    shift((a, b), (r.around(SCENE), r.around(SCENE)))
}

/// Near touching: an exact or rounded touch whose numbers are then moved by up to 2 raw each.
fn near(r: &mut Random, pair: (Kind, Kind), scale: i64) -> (Figure, Figure) {
    let (a, b) = if r.one_in(2) { exact(r, pair, scale) } else { super::touch::rounded(r, pair, scale) };
    (a, jitter(r, b))
}

fn exact(r: &mut Random, pair: (Kind, Kind), scale: i64) -> (Figure, Figure) {
    super::touch::exact(r, pair, scale)
}

fn jitter(r: &mut Random, figure: Figure) -> Figure {
    let mut moved = |p: Point| (p.0 + r.around(2), p.1 + r.around(2));
    match figure {
        Figure::Aabb { min, max } => aabb(moved(min), moved(max)),
        Figure::Segment { a, b } => Figure::Segment { a: moved(a), b: moved(b) },
        Figure::Circle { centre, radius } => {
            let centre = moved(centre);
            Figure::Circle { centre, radius: (radius + r.around(2)).max(0) }
        }
    }
}
