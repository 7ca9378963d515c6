//! Fixed pseudo-random inputs, in the classes that the table names.

use tilesat::{Aabb, Circle, Segment, Vec2};

/// One unit, in raw units.
pub const UNIT: i32 = 1 << 16;

/// A xorshift generator. Gives the same numbers on every core.
pub struct Random(u32);

impl Random {
    pub const fn new(seed: u32) -> Self {
        Self(seed.wrapping_mul(0x9e37_79b9) | 1)
    }

    pub fn word(&mut self) -> u32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 17;
        self.0 ^= self.0 << 5;
        self.0
    }

    /// A whole number in `from..to`.
    pub fn whole(&mut self, from: i32, to: i32) -> i32 {
        let span = i64::from(to) - i64::from(from);
        from + ((i64::from(self.word() >> 1) * span) >> 31) as i32
    }

    /// A raw coordinate of `from..to` units.
    pub fn raw(&mut self, from: i32, to: i32) -> i32 {
        self.whole(from * UNIT, to * UNIT)
    }

    /// A point of a 64 unit square.
    pub fn point(&mut self) -> (i32, i32) {
        (self.raw(0, 64), self.raw(0, 64))
    }
}

pub fn vec((x, y): (i32, i32)) -> Vec2 {
    Vec2::from_raw(x, y)
}

pub fn circle(centre: (i32, i32), radius: i32) -> Option<Circle> {
    Circle::new(vec(centre), tilesat::Fx::from_bits(radius)).ok()
}

/// A circle of 1 to 16 units somewhere in the square.
pub fn any_circle(r: &mut Random) -> Option<Circle> {
    circle(r.point(), r.raw(1, 16))
}

/// A box of 1 to 16 units a side somewhere in the square.
pub fn any_box(r: &mut Random) -> Option<Aabb> {
    let (x, y) = r.point();
    Aabb::new(vec((x, y)), vec((x + r.raw(1, 16), y + r.raw(1, 16)))).ok()
}

/// A segment with both ends somewhere in the square.
pub fn any_segment(r: &mut Random) -> Option<Segment> {
    Segment::new(vec(r.point()), vec(r.point())).ok()
}

/// Relation of the bounding boxes of two shapes: apart in x, apart in y only, or overlapping.
#[derive(PartialEq, Eq, Clone, Copy)]
pub enum Boxes {
    ApartInX,
    ApartInY,
    Overlap,
}

pub fn boxes(a: &Aabb, b: &Aabb) -> Boxes {
    if a.max().x <= b.min().x || b.max().x <= a.min().x {
        Boxes::ApartInX
    } else if a.max().y <= b.min().y || b.max().y <= a.min().y {
        Boxes::ApartInY
    } else {
        Boxes::Overlap
    }
}

/// Whole numbers with `p^2 + q^2 = h^2`, with `p` and `q` of any sign. Such vectors have an exact
/// length.
pub fn triple(r: &mut Random) -> (i32, i32, i32) {
    const TRIPLES: [(i32, i32, i32); 5] = [(3, 4, 5), (5, 12, 13), (8, 15, 17), (7, 24, 25), (20, 21, 29)];
    let (p, q, h) = TRIPLES[r.whole(0, 5) as usize];
    let (p, q) = if r.word() & 1 == 0 { (p, q) } else { (q, p) };
    let sign = |odd: bool, v: i32| if odd { -v } else { v };
    (sign(r.word() & 1 != 0, p), sign(r.word() & 1 != 0, q), h)
}

/// Two circles whose boxes overlap.
pub fn near_circles(r: &mut Random) -> Option<(Circle, Circle)> {
    let (a, b) = (any_circle(r)?, any_circle(r)?);
    (boxes(&a.aabb(), &b.aabb()) == Boxes::Overlap).then_some((a, b))
}

/// Two circles whose distance is the sum of the radii, within one raw unit.
pub fn touching_circles(r: &mut Random) -> Option<(Circle, Circle)> {
    let (p, q, h) = triple(r);
    let s = r.whole(2 * UNIT / h, 32 * UNIT / h);
    let (x, y) = r.point();
    let sum = s * h + r.whole(-1, 2);
    let first = r.whole(1, sum);
    Some((circle((x, y), first)?, circle((x + s * p, y + s * q), sum - first)?))
}

/// A circle and a box whose boxes overlap.
pub fn near_box(r: &mut Random) -> Option<(Circle, Aabb)> {
    let (a, b) = (any_circle(r)?, any_box(r)?);
    (boxes(&a.aabb(), &b) == Boxes::Overlap).then_some((a, b))
}

/// A circle that touches a corner of a box, within one raw unit.
pub fn touching_box(r: &mut Random) -> Option<(Circle, Aabb)> {
    let (p, q, h) = triple(r);
    let s = r.whole(2 * UNIT / h, 16 * UNIT / h);
    let (x, y) = r.point();
    let (w, d) = (r.raw(1, 16) * p.signum(), r.raw(1, 16) * q.signum());
    let b = Aabb::new(vec((x.min(x - w), y.min(y - d))), vec((x.max(x - w), y.max(y - d)))).ok()?;
    Some((circle((x + s * p, y + s * q), s * h + r.whole(-1, 2))?, b))
}

/// A circle beside a slanted segment, near enough for their boxes to overlap.
pub fn near_segment(r: &mut Random) -> Option<(Circle, Segment)> {
    let (p, q, h) = triple(r);
    let length = r.whole(8 * UNIT / h, 32 * UNIT / h);
    let along = r.whole(length / 8, length - length / 8);
    let radius = r.raw(2, 12);
    let aside = r.whole(-radius, radius) * 5 / 4 / h;
    beside(r, (p, q), length, (along, aside), radius)
}

/// A circle that touches a slanted segment between its ends, within one raw unit.
pub fn touching_segment(r: &mut Random) -> Option<(Circle, Segment)> {
    let (p, q, h) = triple(r);
    let length = r.whole(8 * UNIT / h, 32 * UNIT / h);
    let along = r.whole(length / 8, length - length / 8);
    let aside = r.whole(2 * UNIT / h, 12 * UNIT / h);
    let radius = aside * h + r.whole(-1, 2);
    beside(r, (p, q), length, (along, aside), radius)
}

fn beside(
    r: &mut Random,
    (p, q): (i32, i32),
    length: i32,
    (along, aside): (i32, i32),
    radius: i32,
) -> Option<(Circle, Segment)> {
    let (x, y) = r.point();
    let a = circle((x + along * p - aside * q, y + along * q + aside * p), radius)?;
    let b = Segment::new(vec((x, y)), vec((x + length * p, y + length * q))).ok()?;
    (boxes(&a.aabb(), &b.aabb()) == Boxes::Overlap).then_some((a, b))
}
