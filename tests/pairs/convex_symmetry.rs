//! Mirrored, transposed, shifted and exchanged scenes of convex shapes give mirrored, transposed,
//! equal and exchanged bits.
//!
//! Degenerate contacts are exempt: their axis is a convention.

use super::symmetry::{MAPS, directions};
use tilesat_judge::convex::ask;
use tilesat_judge::convex::generate::{CLASSES, Pairs};
use tilesat_judge::convex::shape::{Shape, pairs};
use tilesat_judge::oracle::figure::Point;
use tilesat_judge::oracle::kernel::point;

fn same(name: &str, (a, b): (&Shape, &Shape), (c, d): (&Shape, &Shape), map: impl Fn(Point) -> Point) {
    let case = || format!("{name}: {a:?} {b:?}");
    assert_eq!(ask::touches(a, b), ask::touches(c, d), "{}", case());
    assert_eq!(ask::distance(a, b), ask::distance(c, d), "{}", case());
    assert_eq!(ask::contains(a, b), ask::contains(c, d), "{}", case());
    let (first, second) = (ask::contact(a, b), ask::contact(c, d));
    assert_eq!(first.is_some(), second.is_some(), "{}", case());
    let (Some(first), Some(second)) = (first, second) else { return };
    assert_eq!(first.depth(), second.depth(), "{}", case());
    assert_eq!(first.is_degenerate(), second.is_degenerate(), "{}", case());
    if !first.is_degenerate() {
        assert_eq!(directions(&first).map(map), directions(&second), "{}", case());
    }
}

fn each(mut check: impl FnMut(&Shape, &Shape)) {
    for pair in pairs() {
        for class in CLASSES {
            let mut stream = Pairs::new(pair, class, 0x311);
            for _ in 0..tilesat_judge::cases(300) {
                let (a, b) = stream.next();
                check(&a, &b);
            }
        }
    }
}

#[test]
fn mirrored_and_transposed_scenes() {
    each(|a, b| {
        for (name, map) in MAPS {
            same(name, (a, b), (&a.map(map, map), &b.map(map, map)), map);
        }
    });
}

#[test]
fn moved_scenes() {
    each(|a, b| {
        for by in [(1, 0), (-7, 65_537), (400_000_000, -123_456_789)] {
            let (c, d) = (a.moved(by), b.moved(by));
            if !c.in_domain() || !d.in_domain() {
                continue;
            }
            same("move", (a, b), (&c, &d), |p| p);
            let moved = |p: Point| (p.0 + by.0, p.1 + by.1);
            let points = ask::closest_points(a, b).map(|(p, q)| (moved(p), moved(q)));
            assert_eq!(points, ask::closest_points(&c, &d), "{a:?} {b:?} by {by:?}");
            let deepest = |a, b| ask::contact(a, b).map(|c| (point(c.point_on_a()), point(c.point_on_b())));
            assert_eq!(deepest(a, b).map(|(p, q)| (moved(p), moved(q))), deepest(&c, &d), "{a:?} {b:?} by {by:?}");
        }
    });
}

/// An oriented box along x and y is an [`Aabb`](tilesat::Aabb), a capsule without length a circle,
/// one without radius a segment: the same bits.
#[test]
fn plain_shapes_in_other_words() {
    let words = |s: &Shape| match *s {
        Shape::Aabb { min, max } if (max.0 - min.0) % 2 == 0 && (max.1 - min.1) % 2 == 0 => Some(Shape::Turned {
            centre: (min.0 + (max.0 - min.0) / 2, min.1 + (max.1 - min.1) / 2),
            half: ((max.0 - min.0) / 2, (max.1 - min.1) / 2),
            direction: (1, 0),
            radius: 0,
        }),
        Shape::Circle { centre, radius } => Some(Shape::Capsule { a: centre, b: centre, radius }),
        Shape::Segment { a, b } => Some(Shape::Capsule { a: b, b: a, radius: 0 }),
        _ => None,
    };
    let mut told = 0;
    each(|a, b| {
        if let Some(other) = words(b) {
            same("in other words", (a, b), (a, &other), |p| p);
            told += 1;
        }
    });
    assert!(told > 1000);
}
