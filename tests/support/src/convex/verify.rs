//! What the library says about a pair, held against the judge. Failures print the pair as raw integers.

use super::ask;
use super::shape::{Shape, sum};
use crate::oracle::exit;
use crate::oracle::figure::Point;
use crate::oracle::int256::Int256;
use crate::oracle::kernel::point;
use crate::oracle::measure::Measure;
use crate::oracle::sum::{Place, Sum, dot, orient};
use tilesat::Contact;

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
            let off = Measure::of(&sum(shape, &dot_at(at)));
            assert!(
                off.place != Place::Outside || off.square.root_minus(shape.radius() + 2) <= 0,
                "{at:?} is off {shape:?}"
            );
        }
    }
}

fn dot_at(centre: Point) -> Shape {
    Shape::Circle { centre, radius: 0 }
}

/// Every point of B is one of A: each corner's disc is, by the distance to A's border or into it.
fn contains(a: &Shape, b: &Shape) -> bool {
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
