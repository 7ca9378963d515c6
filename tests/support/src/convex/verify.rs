//! Compares the library's answers about a pair with the judge. Failures print the pair as raw
//! integers.

use super::ask;
use super::shape::{Shape, sum};
use crate::casts::ask::{self as casts, Case};
use crate::casts::judge::Forbidden;
use crate::casts::number::Number;
use crate::oracle::exit;
use crate::oracle::figure::Point;
use crate::oracle::int256::Int256;
use crate::oracle::kernel::point;
use crate::oracle::measure::Measure;
use crate::oracle::sum::{Place, Sum, dot, orient};
use tilesat::{Contact, Inside};

/// The verdicts on one pair.
pub struct Pair<'a> {
    pub a: &'a Shape,
    pub b: &'a Shape,
    pub sum: Sum,
    pub exact: Measure,
}

impl<'a> Pair<'a> {
    pub fn new(a: &'a Shape, b: &'a Shape) -> Self {
        let sum = sum(a, b);
        Self { a, b, sum, exact: Measure::of(&sum) }
    }

    /// Everything.
    pub fn all(&self) {
        self.booleans();
        self.contact();
        self.manifold();
        self.points_between();
    }

    /// Overlap, touch, containment and distance, in both orders.
    pub fn booleans(&self) {
        let (overlap, touch) = (self.exact.overlaps(), self.exact.touches());
        for (a, b) in [(self.a, self.b), (self.b, self.a)] {
            assert_eq!(ask::overlaps(a, b), overlap, "overlaps of {a:?} and {b:?}, the judge on the right");
            assert_eq!(ask::touches(a, b), touch, "touches of {a:?} and {b:?}, the judge on the right");
            assert_eq!(ask::contact(a, b).is_some(), overlap, "contact of {a:?} and {b:?}, the judge on the right");
            assert_eq!(ask::contains(a, b), contains(a, b), "{a:?} contains {b:?}, the judge on the right");
            let d = ask::distance(a, b);
            assert!(self.exact.distance_is(d), "distance {d} of {a:?} {b:?}");
        }
    }

    /// The contact of A with B, and that B's with A mirrors it.
    pub fn contact(&self) {
        let (a, b) = (self.a, self.b);
        let (Some(contact), Some(back)) = (ask::contact(a, b), ask::contact(b, a)) else { return };
        self.exit(&contact);
        assert_eq!(contact.is_degenerate(), !self.exact.one_exit, "degenerate {a:?} {b:?}");
        assert_eq!(back.is_degenerate(), contact.is_degenerate(), "degenerate {b:?} {a:?}");
        assert_eq!(back.depth(), contact.depth(), "depth {b:?} {a:?}");
        if contact.is_degenerate() {
            Self::new(b, a).exit(&back);
        } else {
            let mirrored = (-back.axis(), -back.push_out(), back.point_on_b(), back.point_on_a());
            let seen = (contact.axis(), contact.push_out(), contact.point_on_a(), contact.point_on_b());
            assert_eq!(seen, mirrored, "contact and mirrored contact of {a:?} {b:?}");
        }
    }

    fn exit(&self, contact: &Contact) {
        let (a, b) = (self.a, self.b);
        let case = format!("{a:?} {b:?}");
        let push = exit::verify(&self.sum, &self.exact, contact, &case);
        let moved = a.moved(push);
        assert!(!Measure::of(&sum(&moved, b)).overlaps(), "still overlapping after {push:?}: {case}");
        if moved.in_domain() {
            assert!(!ask::overlaps(&moved, b), "still overlapping after {push:?}: {case}");
        }
        let seen = |s: &Shape, at| sum(&s.sharp(), &dot_at(at));
        let (p, q) = (point(contact.point_on_a()), point(contact.point_on_b()));
        exit::verify_points(contact, (&seen(a, p), a.radius()), (&seen(b, q), b.radius()), &case);
    }

    /// One or two points, along the contact's axis, on their shapes, with their depth there, and
    /// mirrored in the other order.
    pub fn manifold(&self) {
        let (a, b) = (self.a, self.b);
        let (Some(found), Some(contact)) = (ask::manifold(a, b), ask::contact(a, b)) else {
            assert_eq!(ask::manifold(a, b).is_some(), self.exact.overlaps(), "manifold of {a:?} {b:?}");
            return;
        };
        let case = format!("{a:?} {b:?}: {found:?}");
        if !a.is_plain() || !b.is_plain() {
            assert_eq!(found.axis(), contact.axis(), "{case}");
        } else if contact.is_degenerate() {
            // If there are several shortest exits, contacts of plain shapes take one and polygons
            // another.
            self.exit(&found.deepest().contact);
        } else {
            let (u, v) = (found.axis(), contact.axis());
            assert!(u.perp_dot(v) == 0 && u.dot(v) > 0, "{case}");
        }
        assert_eq!(found.deepest().contact.depth(), contact.depth(), "{case}");
        let points: Vec<_> = found.points().collect();
        assert!(
            points.len() < 2 || (points[0].part_a, points[0].part_b) != (points[1].part_a, points[1].part_b),
            "{case}"
        );
        for p in &points {
            let c = &p.contact;
            assert!(
                c.axis() == found.axis() && c.depth() > 0 && c.depth() <= contact.depth() + tilesat::Fx::from_bits(1),
                "{case}"
            );
            let u = (i64::from(c.axis().x), i64::from(c.axis().y));
            let (on_a, on_b) = (point(c.point_on_a()), point(c.point_on_b()));
            // In A and in B, within 2 raw per component, and opposite to each other.
            for (shape, at) in [(a, on_a), (b, on_b)] {
                assert!(is_within(shape, at, 3), "{at:?} off: {case}");
            }
            let across = orient((0, 0), u, (on_a.0 - on_b.0, on_a.1 - on_b.1));
            assert!(across.squared() <= Int256::new(36) * dot(u, u), "points are not opposite: {case}");
            // As far apart along the axis as their depth.
            let along = dot(u, (on_a.0 - on_b.0, on_a.1 - on_b.1));
            let d = i64::from(c.depth().to_bits());
            let side = |n: i64| exit::compare_root(along, n, dot(u, u));
            assert!(side(d - 6) >= 0 && side(d + 6) <= 0, "depth {d}: {case}");
            for (shape, part) in [(a, p.part_a), (b, p.part_b)] {
                let (tilesat::query::Part::Corner(i) | tilesat::query::Part::Side(i)) = part;
                assert!(usize::from(i) < shape.vertices().len(), "{case}");
            }
        }
        if !contact.is_degenerate() {
            let back = ask::manifold(b, a).expect("overlap has no order");
            let turned: Vec<_> = back
                .points()
                .map(|p| (p.part_b, p.part_a, p.contact.depth(), p.contact.point_on_b(), p.contact.point_on_a()))
                .collect();
            let seen: Vec<_> = points
                .iter()
                .map(|p| (p.part_a, p.part_b, p.contact.depth(), p.contact.point_on_a(), p.contact.point_on_b()))
                .collect();
            assert_eq!(seen, turned, "exchanged: {case}");
        }
    }

    /// Closest points are on their shapes and as far apart as these are, each within 2 raw.
    pub fn points_between(&self) {
        let (a, b) = (self.a, self.b);
        let Some((p, q)) = ask::closest_points(a, b) else {
            assert!(self.exact.touches(), "no closest points of {a:?} {b:?}");
            return;
        };
        assert!(!self.exact.touches(), "closest points of touching {a:?} {b:?}");
        assert_eq!(ask::closest_points(b, a), Some((q, p)), "{b:?} {a:?}");
        let between = Measure::of(&sum(&dot_at(p), &dot_at(q))).square;
        let far = |n: i64| self.exact.square.root_minus(n + self.sum.radius);
        // floor(|p - q|) is within 3 of the distance, and both points are near their shapes.
        let d = between.num;
        let bound = |n: i64| Int256::product(n, n);
        let k = ask::distance(a, b);
        assert!(far(k) >= 0 && d <= bound(k + 4) && (k < 3 || d >= bound(k - 3)), "{p:?} {q:?} of {a:?} {b:?}");
        for (shape, at) in [(a, p), (b, q)] {
            assert!(is_within(shape, at, 2), "{at:?} is off {shape:?}");
        }
    }
}

/// Whether a point is in a shape, or at most so far from it.
fn is_within(shape: &Shape, at: Point, distance: i64) -> bool {
    let off = Measure::of(&sum(shape, &dot_at(at)));
    off.place != Place::Outside || off.square.root_minus(shape.radius() + distance) <= 0
}

/// A cast of A by `d` on B, and of B by the reversed motion on A.
pub fn cast<N: Number>(a: &Shape, b: &Shape, d: Point, tolerance: i64) -> Case {
    // The positions of A's origin: B minus A.
    let all = sum(b, a);
    let set = Forbidden { hull: all.points().to_vec(), radius: all.radius };
    let case = || format!("{a:?} by {d:?} on {b:?}");
    let forth = |inside| ask::cast(a, b, d, inside).unwrap_or_else(|e| panic!("{e}: {}", case()));
    let back = || ask::cast(b, a, (-d.0, -d.1), Inside::Ignore);
    casts::check_interval::<N>(&set, d, ask::interval(a, b, d), case);
    casts::verify::<N>(&set, d, tolerance, forth, back, case)
}

/// The answers about a shape and a point anywhere.
pub fn about_point(shape: &Shape, p: Point) {
    let exact = Measure::of(&sum(shape, &dot_at(p)));
    let (holds, d, x) = ask::about_point(shape, p);
    assert_eq!(holds, exact.touches(), "{shape:?} contains {p:?}, the judge on the right");
    // As documented: by the distance of the core.
    let saturated = d == i64::from(i32::MAX) && exact.square.root_minus(1 << 31) >= 0;
    assert!(saturated || exact.distance_is(d), "distance {d} of {shape:?} to {p:?}");
    if holds {
        assert_eq!(x, p, "{shape:?}");
        return;
    }
    // At the shape's distance, and on it: within a raw unit per component.
    let off = Measure::of(&sum(shape, &dot_at(x)));
    assert!(off.place != Place::Outside || off.square.root_minus(shape.radius() + 2) <= 0, "{x:?} is off {shape:?}");
    let v = (x.0 - p.0, x.1 - p.1);
    let square = dot(v, v);
    let near = |n: i64| (square - Int256::product(n, n)).signum();
    assert!(saturated || near(d + 3) <= 0, "{x:?} of {shape:?} is not the nearest to {p:?}");
}

fn dot_at(centre: Point) -> Shape {
    Shape::Circle { centre, radius: 0 }
}

/// Every point of B is one of A. So is each corner's disc, by the distance to A's border or into
/// it.
pub fn contains(a: &Shape, b: &Shape) -> bool {
    let rest = a.radius() - b.radius();
    b.vertices().iter().all(|p| {
        let core = sum(&a.sharp(), &dot_at(*p));
        let exact = Measure::of(&core);
        if rest >= 0 {
            return exact.place != Place::Outside || exact.square.root_minus(rest) <= 0;
        }
        // A disc of that radius around an origin inside.
        exact.place == Place::Inside
            && core.edges().all(|(p, q)| {
                let e = (q.0 - p.0, q.1 - p.1);
                orient(p, q, (0, 0)).squared() >= Int256::product(rest, rest) * dot(e, e)
            })
    })
}
