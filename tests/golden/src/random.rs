//! The inputs: a seeded generator of integers, and the classes of vectors.

use tilesat::num::{DOMAIN, MOTION};
use tilesat::{Aabb, Circle, Fx, Segment, Vec2};

/// One unit in raw.
pub(crate) const UNIT: i32 = 1 << 16;

/// Marsaglia's xorshift; the same numbers everywhere.
#[derive(Clone, Copy, Debug)]
pub struct Random(u32);

impl Random {
    pub const fn new(seed: u32) -> Self {
        // Odd times odd is not 0.
        Self((seed | 1).wrapping_mul(0x9e37_79b9))
    }

    pub const fn word(&mut self) -> u32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 17;
        self.0 ^= self.0 << 5;
        self.0
    }

    /// `0..n`, by the high bits, for n below 2^16: no long multiplication.
    pub const fn below(&mut self, n: u32) -> u32 {
        ((self.word() >> 16) * n) >> 16
    }

    pub const fn once_in(&mut self, n: u32) -> bool {
        self.below(n) == 0
    }

    /// `-n..=n` for n below 2^15.
    pub const fn small(&mut self, n: i32) -> i32 {
        self.below(2 * n as u32 + 1) as i32 - n
    }

    /// `-2^bits..2^bits`.
    pub const fn signed(&mut self, bits: u32) -> i32 {
        self.word() as i32 >> (31 - bits)
    }

    /// A 64-bit number with up to so many bits.
    pub const fn wide(&mut self) -> u64 {
        let word = (self.word() as u64) << 32 | self.word() as u64;
        word >> (self.word() >> 26)
    }
}

/// The class of a vector.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Class {
    /// Anywhere in 64 units, sizes to 16 units: ordinary scenes.
    Uniform,
    /// On a lattice of a few steps of a unit or of a raw unit, sizes from 0: exact touches, ties,
    /// degenerate shapes.
    Lattice,
    /// Touching at a point with an exact normal, then moved by up to 2 raw units.
    Near,
    /// Touching exactly.
    Touch,
    /// As one of the others, at the ends of the domain.
    Far,
    /// Anywhere, of any size.
    Domain,
}

impl Class {
    /// The class of the vector with this number. All classes are equally frequent.
    pub(crate) const fn of(number: u32) -> Self {
        match number % 6 {
            0 => Self::Uniform,
            1 => Self::Lattice,
            2 => Self::Near,
            3 => Self::Touch,
            4 => Self::Far,
            _ => Self::Domain,
        }
    }
}

/// Whole numbers with `x^2 + y^2 = length^2`: a direction whose unit vector needs no rounding.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Direction {
    pub x: i32,
    pub y: i32,
    pub length: i32,
}

impl Direction {
    pub(crate) fn any(r: &mut Random) -> Self {
        let (x, y, length) = match r.below(8) {
            0..3 => (1, 0, 1),
            3..5 => (3, 4, 5),
            5 => (5, 12, 13),
            6 => (8, 15, 17),
            _ => (20, 21, 29),
        };
        let (x, y) = if r.once_in(2) { (x, y) } else { (y, x) };
        let sign = |r: &mut Random, v: i32| if r.once_in(2) { -v } else { v };
        Self { x: sign(r, x), y: sign(r, y), length }
    }

    pub(crate) const fn reversed(self) -> Self {
        Self { x: -self.x, y: -self.y, length: self.length }
    }
}

/// A coordinate inside of the domain.
fn clamped(v: i32) -> i32 {
    v.clamp(1 - DOMAIN, DOMAIN - 1)
}

/// A point inside of the domain.
pub(crate) fn point(x: i32, y: i32) -> Vec2 {
    Vec2::from_raw(clamped(x), clamped(y))
}

/// A point of a class that has no partner.
pub(crate) fn any_point(r: &mut Random, class: Class, at: Vec2) -> Vec2 {
    let (x, y) = match class {
        Class::Uniform | Class::Far => (r.signed(21), r.signed(21)),
        Class::Lattice | Class::Near | Class::Touch => (r.small(4) * UNIT, r.small(4) * UNIT),
        Class::Domain => (r.signed(29), r.signed(29)),
    };
    let (cx, cy) = at.raw();
    let few = if class == Class::Near { 2 } else { 0 };
    point(cx + x + r.small(few), cy + y + r.small(few))
}

/// A motion of a class. In classes with small scenes, half of them lead nearly from `a` to `b`.
pub(crate) fn any_motion(r: &mut Random, class: Class, a: Vec2, b: Vec2) -> Vec2 {
    let ((ax, ay), (bx, by)) = (a.raw(), b.raw());
    let toward = |v: i32| v.clamp(1 - MOTION, MOTION - 1);
    match (class, r.below(8)) {
        (_, 0) => Vec2::from_raw(r.small(2), r.small(2)),
        (Class::Domain, 1..4) => Vec2::from_raw(toward(r.signed(28)), toward(r.signed(28))),
        (Class::Lattice | Class::Touch, 1..4) => Vec2::from_raw(r.small(4) * UNIT, r.small(4) * UNIT),
        (_, 1..4) => Vec2::from_raw(r.signed(22), r.signed(22)),
        (_, 4) => Vec2::from_raw(toward(bx - ax), toward(by - ay)),
        (_, 5) => Vec2::from_raw(toward(2 * (bx - ax) + r.small(9)), toward(2 * (by - ay) + r.small(9))),
        _ => Vec2::from_raw(toward(bx - ax + r.signed(19)), toward(by - ay + r.signed(19))),
    }
}

/// A shape that the classes can generate.
pub(crate) trait Draw: Sized {
    /// With its position near `at`. `step` and `small`, or else `bits`, bound its size.
    fn spread(p: Vec2, q: (i32, i32)) -> Self;

    /// Its border contains `at`, and all of it is on the side of the line through it to which `n`
    /// points. `size` gives its size.
    fn touching(at: (i32, i32), n: Direction, size: i32, r: &mut Random) -> Self;

    /// A point at which to aim.
    fn place(&self) -> Vec2;

    fn any(r: &mut Random, class: Class, at: Vec2) -> Self {
        let p = any_point(r, class, at);
        let q = match class {
            Class::Domain => (r.signed(29), r.signed(29)),
            Class::Lattice | Class::Near | Class::Touch => (r.small(3) * UNIT, r.small(3) * UNIT),
            Class::Uniform | Class::Far => (r.signed(20), r.signed(20)),
        };
        Self::spread(p, q)
    }
}

impl Draw for Aabb {
    fn spread(p: Vec2, (w, h): (i32, i32)) -> Self {
        let (x, y) = p.raw();
        let q = point(x.saturating_add(w), y.saturating_add(h));
        Self::new(p.min(q), p.max(q)).unwrap_or(BOX)
    }

    fn touching((x, y): (i32, i32), n: Direction, size: i32, r: &mut Random) -> Self {
        // Along an axis a side touches, else a corner.
        let side =
            |v: i32, r: &mut Random| if v == 0 { (-size, r.small(99) * (size / 99)) } else { (0, v.signum() * size) };
        let ((x0, x1), (y0, y1)) = (side(n.x, r), side(n.y, r));
        let (p, q) = (point(x + x0, y + y0), point(x + x1, y + y1));
        Self::new(p.min(q), p.max(q)).unwrap_or(BOX)
    }

    fn place(&self) -> Vec2 {
        self.centre()
    }
}

impl Draw for Circle {
    fn spread(p: Vec2, (w, h): (i32, i32)) -> Self {
        let (x, y) = p.raw();
        let room = DOMAIN - 1 - x.abs().max(y.abs());
        Self::new(p, Fx::from_bits(w.abs().max(h.abs()).min(room))).unwrap_or(CIRCLE)
    }

    fn touching((x, y): (i32, i32), n: Direction, size: i32, _: &mut Random) -> Self {
        let s = size / n.length;
        Self::spread(point(x + s * n.x, y + s * n.y), (s * n.length, 0))
    }

    fn place(&self) -> Vec2 {
        self.centre()
    }
}

impl Draw for Segment {
    fn spread(p: Vec2, (w, h): (i32, i32)) -> Self {
        let (x, y) = p.raw();
        Self::new(p, point(x.saturating_add(w), y.saturating_add(h))).unwrap_or(SEGMENT)
    }

    fn touching((x, y): (i32, i32), n: Direction, size: i32, r: &mut Random) -> Self {
        let s = size / n.length;
        let (a, b) = (r.small(9), r.small(9));
        if r.once_in(2) {
            // Along the line, the point within it or not.
            let end = |k: i32| point(x - k * (s / 9) * n.y, y + k * (s / 9) * n.x);
            return Self::new(end(a), end(b)).unwrap_or(SEGMENT);
        }
        // An end at the point.
        let q = point(x + s * n.x - a * (s / 9) * n.y, y + s * n.y + a * (s / 9) * n.x);
        Self::new(point(x, y), q).unwrap_or(SEGMENT)
    }

    fn place(&self) -> Vec2 {
        self.a()
    }
}

const BOX: Aabb = match Aabb::new(Vec2::ZERO, Vec2::from_ints(1, 1)) {
    Ok(shape) => shape,
    Err(_) => panic!("a box"),
};
const CIRCLE: Circle = match Circle::new(Vec2::ZERO, Fx::ONE) {
    Ok(shape) => shape,
    Err(_) => panic!("a circle"),
};
const SEGMENT: Segment = match Segment::new(Vec2::ZERO, Vec2::from_ints(1, 1)) {
    Ok(shape) => shape,
    Err(_) => panic!("a segment"),
};

/// Two shapes of a class, and a motion of the first one.
pub(crate) fn pair<A: Draw, B: Draw>(r: &mut Random, class: Class) -> (A, B, Vec2) {
    // At most 2^29 less 2^25: room for what is around.
    let far = DOMAIN - (1 << 25);
    let (at, class) = match class {
        Class::Far => {
            let end = |r: &mut Random| if r.once_in(2) { far } else { -far };
            let kind = Class::of(r.below(4));
            (Vec2::from_raw(end(r), end(r)), kind)
        }
        _ => (Vec2::ZERO, class),
    };
    let (a, b) = match class {
        Class::Near | Class::Touch => {
            let (n, few) = (Direction::any(r), if class == Class::Near { 2 } else { 0 });
            let (x, y) = at.raw();
            let (x, y) = (x + r.signed(20), y + r.signed(20));
            let (size_a, size_b) = (99 + (r.signed(19).abs()), 99 + (r.signed(19).abs()));
            let moved = (x + r.small(few), y + r.small(few));
            (A::touching(moved, n, size_a, r), B::touching((x, y), n.reversed(), size_b, r))
        }
        _ => (A::any(r, class, at), B::any(r, class, at)),
    };
    let motion = any_motion(r, class, a.place(), b.place());
    (a, b, motion)
}
