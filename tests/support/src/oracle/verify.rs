//! Compares the library's answers about a pair with the judge. Failures print the pair as raw
//! integers.

use super::closest::are_closest_points;
use super::exit;
use super::figure::{Figure, Point};
use super::kernel;
use super::measure::{self, Measure};
use super::nearest::is_closest_point;
use super::sum::Sum;
use tilesat::Contact;

/// The verdicts on one pair.
#[derive(Clone, Copy)]
pub struct Pair<'a> {
    pub a: &'a Figure,
    pub b: &'a Figure,
    pub sum: Sum,
    pub exact: Measure,
}

impl<'a> Pair<'a> {
    pub fn new(a: &'a Figure, b: &'a Figure) -> Self {
        let sum = Sum::new(a, b);
        Self { a, b, sum, exact: Measure::of(&sum) }
    }

    /// `overlaps`, `touches` and whether there is a contact, in both orders.
    pub fn booleans(&self) {
        let (overlap, touch) = (self.exact.overlaps(), self.exact.touches());
        for (a, b) in [(self.a, self.b), (self.b, self.a)] {
            assert_eq!(kernel::overlaps(a, b), overlap, "overlaps of {a:?} and {b:?}, the judge on the right");
            assert_eq!(kernel::touches(a, b), touch, "touches of {a:?} and {b:?}, the judge on the right");
            assert_eq!(kernel::contact(a, b).is_some(), overlap, "contact of {a:?} and {b:?}, the judge on the right");
        }
    }

    /// Everything about the contact of A with B, and that B's with A mirrors it.
    pub fn contact(&self) {
        let (a, b) = (self.a, self.b);
        let (Some(contact), Some(back)) = (kernel::contact(a, b), kernel::contact(b, a)) else {
            assert!(!self.exact.overlaps(), "no contact of {a:?} and {b:?}");
            return;
        };
        self.exit(&contact);
        self.points(&contact);
        assert_eq!(contact.is_degenerate(), !self.exact.one_exit, "degenerate {a:?} {b:?}");
        assert_eq!(back.is_degenerate(), contact.is_degenerate(), "degenerate {b:?} {a:?}");
        assert_eq!(back.depth(), contact.depth(), "depth {b:?} {a:?}");
        if contact.is_degenerate() {
            Self::new(b, a).exit(&back);
            Self::new(b, a).points(&back);
        } else {
            let mirrored = (-back.axis(), -back.push_out(), back.point_on_b(), back.point_on_a());
            let seen = (contact.axis(), contact.push_out(), contact.point_on_a(), contact.point_on_b());
            assert_eq!(seen, mirrored, "contact and mirrored contact of {a:?} {b:?}");
            let (n, m) = (contact.normal().raw(), back.normal().raw());
            assert_eq!(n, (-m.0, -m.1), "normals of {a:?} {b:?}");
        }
    }

    /// Axis, depth, push and normal.
    fn exit(&self, contact: &Contact) {
        let (a, b) = (self.a, self.b);
        let push = exit::verify(&self.sum, &self.exact, contact, &format!("{a:?} {b:?}"));
        let moved = a.moved(push);
        assert!(!Measure::new(&moved, b).overlaps(), "still overlapping after {push:?}: {a:?} {b:?}");
        if let Some(moved) = kernel::translated(a, push) {
            assert!(!kernel::overlaps(&moved, b), "still overlapping after {push:?}: {a:?} {b:?}");
        }
    }

    /// The deepest points.
    fn points(&self, contact: &Contact) {
        let (a, b) = (self.a, self.b);
        let seen = |figure: &Figure, at| Sum::new(figure, &Figure::Circle { centre: at, radius: 0 });
        let (p, q) = (kernel::point(contact.point_on_a()), kernel::point(contact.point_on_b()));
        exit::verify_points(contact, (&seen(a, p), a.radius()), (&seen(b, q), b.radius()), &format!("{a:?} {b:?}"));
    }

    /// Distance, closest points and containment, in both orders.
    pub fn distances(&self) {
        for (a, b) in [(self.a, self.b), (self.b, self.a)] {
            let d = kernel::distance(a, b);
            assert!(self.exact.distance_is(d), "distance {d} of {a:?} {b:?}");
            assert_eq!(kernel::contains(a, b), measure::contains(a, b), "{a:?} contains {b:?}, the judge on the right");
            match kernel::closest_points(a, b) {
                Some((p, q)) => {
                    assert!(!self.exact.touches(), "closest points of touching {a:?} {b:?}");
                    assert!(are_closest_points(a, b, p, q), "closest points {p:?} {q:?} of {a:?} {b:?}");
                }
                None => assert!(self.exact.touches(), "no closest points of {a:?} {b:?}"),
            }
        }
    }
}

/// Distance to a point anywhere, the point nearest to it, and whether it is inside.
pub fn point(figure: &Figure, p: Point) {
    let dot = Figure::Circle { centre: p, radius: 0 };
    let exact = Measure::new(figure, &dot);
    let d = kernel::distance_to_point(figure, p);
    let saturated = d == i64::from(i32::MAX) && exact.square.root_minus(d + exact.radius) >= 0;
    assert!(saturated || exact.distance_is(d), "distance {d} of {figure:?} to {p:?}");
    assert_eq!(kernel::contains_point(figure, p), exact.touches(), "{figure:?} contains {p:?}, the judge on the right");
    let x = kernel::closest_point(figure, p);
    assert!(is_closest_point(figure, p, x), "closest point {x:?} of {figure:?} to {p:?}");
}
