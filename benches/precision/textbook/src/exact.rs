//! The same booleans in integers wide enough for every product. They are never wrong, and test
//! nothing before the deciding comparison.
//!
//! This is not the library's code: it shows the cost of its answers without its filters.
//! Coordinates are below 2^29, so sums of two products are below 2^62.

/// Raw units.
#[derive(Clone, Copy, Debug)]
pub struct Point {
    pub x: i32,
    pub y: i32,
}

impl Point {
    #[inline]
    fn to(self, o: Self) -> (i64, i64) {
        (i64::from(o.x) - i64::from(self.x), i64::from(o.y) - i64::from(self.y))
    }
}

#[derive(Clone, Copy, Debug)]
pub struct Circle {
    pub c: Point,
    pub r: i32,
}

#[derive(Clone, Copy, Debug)]
pub struct Aabb {
    pub lo: Point,
    pub hi: Point,
}

#[derive(Clone, Copy, Debug)]
pub struct Segment {
    pub a: Point,
    pub b: Point,
}

#[inline]
fn dot(p: (i64, i64), q: (i64, i64)) -> i64 {
    p.0 * q.0 + p.1 * q.1
}

#[inline]
fn cross(p: (i64, i64), q: (i64, i64)) -> i64 {
    p.0 * q.1 - p.1 * q.0
}

#[inline]
fn in_disc(d: (i64, i64), r: i64) -> bool {
    dot(d, d) < r * r
}

#[inline]
pub fn circle_circle(a: &Circle, b: &Circle) -> bool {
    in_disc(a.c.to(b.c), i64::from(a.r) + i64::from(b.r))
}

#[inline]
pub fn circle_aabb(a: &Circle, b: &Aabb) -> bool {
    if a.r == 0 {
        return b.lo.x < a.c.x && a.c.x < b.hi.x && b.lo.y < a.c.y && a.c.y < b.hi.y;
    }
    let near = Point { x: a.c.x.clamp(b.lo.x, b.hi.x), y: a.c.y.clamp(b.lo.y, b.hi.y) };
    in_disc(a.c.to(near), a.r.into())
}

#[inline]
pub fn circle_segment(a: &Circle, b: &Segment) -> bool {
    let (e, p, r) = (b.a.to(b.b), b.a.to(a.c), i64::from(a.r));
    let (along, square) = (dot(p, e), dot(e, e));
    if along <= 0 {
        in_disc(p, r)
    } else if along >= square {
        in_disc(b.b.to(a.c), r)
    } else {
        let aside = i128::from(cross(e, p));
        aside * aside < i128::from(r * r) * i128::from(square)
    }
}

#[inline]
pub fn aabb_aabb(a: &Aabb, b: &Aabb) -> bool {
    a.lo.x < b.hi.x && b.lo.x < a.hi.x && a.lo.y < b.hi.y && b.lo.y < a.hi.y
}

/// The three axes, from twice the middles.
#[inline]
pub fn aabb_segment(a: &Aabb, b: &Segment) -> bool {
    let (e, d) = (a.lo.to(a.hi), b.a.to(b.b));
    let (p, q) = (a.lo.to(b.a), a.hi.to(b.b));
    let m = (p.0 + q.0, p.1 + q.1);
    let (w, h) = (d.0.abs(), d.1.abs());
    m.0.abs() < e.0 + w && m.1.abs() < e.1 + h && ((w == 0 && h == 0) || cross(m, d).abs() < e.0 * h + e.1 * w)
}

#[inline]
pub fn segment_segment(a: &Segment, b: &Segment) -> bool {
    let beside = |s: &Segment, p: Point| cross(s.a.to(s.b), s.a.to(p));
    let apart = |p: i64, q: i64| (p < 0 && q > 0) || (p > 0 && q < 0);
    apart(beside(a, b.a), beside(a, b.b)) && apart(beside(b, a.a), beside(b, a.b))
}
