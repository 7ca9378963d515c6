//! Mirrored, transposed, shifted and exchanged scenes give mirrored, transposed, equal and
//! exchanged bits.
//!
//! Degenerate contacts are exempt: their axis is a convention. (An x/y tie of boxes is one: x wins,
//! so transposing it shows.)

use proptest::prelude::*;
use tilesat::Contact;
use tilesat_judge::oracle::figure::{Figure, Kind, PAIRS, Point};
use tilesat_judge::oracle::generate::{CLASSES, Pairs, aabb};
use tilesat_judge::oracle::kernel;

/// A map of the plane to itself that keeps distances and the origin.
pub(super) type Map = fn(Point) -> Point;

pub(super) const MAPS: [(&str, Map); 4] = [
    ("mirror x", |p| (-p.0, p.1)),
    ("mirror y", |p| (p.0, -p.1)),
    ("transpose", |p| (p.1, p.0)),
    ("turn", |p| (-p.1, p.0)),
];

/// Pairs from the judge's generators. A seed does not shrink, so small scenes come from [`small`]
/// as well.
fn generated() -> impl Strategy<Value = (Figure, Figure)> {
    (0..PAIRS.len(), 0..CLASSES.len(), any::<u64>())
        .prop_map(|(pair, class, seed)| Pairs::new(PAIRS[pair], CLASSES[class], seed).next())
}

fn figure(kind: Kind, size: i64, unit: i64) -> impl Strategy<Value = Figure> {
    let n = -size..=size;
    (n.clone(), n.clone(), n.clone(), n).prop_map(move |(x, y, z, w)| {
        let (p, q) = ((x * unit, y * unit), (z * unit, w * unit));
        match kind {
            Kind::Aabb => aabb(p, q),
            Kind::Circle => Figure::Circle { centre: p, radius: q.0.abs() },
            Kind::Segment => Figure::Segment { a: p, b: q },
        }
    })
}

/// A few lattice points of any spacing: full of ties.
fn small() -> impl Strategy<Value = (Figure, Figure)> {
    let units = prop_oneof![Just(1i64), Just(3), Just(1 << 16), Just(16_777_213)];
    (0..PAIRS.len(), units, 1i64..=15).prop_flat_map(|(pair, unit, size)| {
        let (a, b) = PAIRS[pair];
        (figure(a, size, unit), figure(b, size, unit))
    })
}

fn pairs() -> impl Strategy<Value = (Figure, Figure)> {
    prop_oneof![generated(), small()]
}

/// Axis, push-out and unit normal.
type Directions = [Point; 3];

pub(super) fn directions(contact: &Contact) -> Directions {
    let (axis, normal) = (contact.axis(), contact.normal().raw());
    [(axis.x.into(), axis.y.into()), kernel::point(contact.push_out()), (normal.0.into(), normal.1.into())]
}

/// Both scenes give the same booleans, distances and depths, and directions that `map` maps onto
/// each other.
fn same(
    name: &str,
    (a, b): (&Figure, &Figure),
    (c, d): (&Figure, &Figure),
    map: impl Fn(Point) -> Point,
) -> Result<(), TestCaseError> {
    prop_assert_eq!(kernel::overlaps(a, b), kernel::overlaps(c, d), "{}", name);
    prop_assert_eq!(kernel::touches(a, b), kernel::touches(c, d), "{}", name);
    prop_assert_eq!(kernel::distance(a, b), kernel::distance(c, d), "{}", name);
    let (first, second) = (kernel::contact(a, b), kernel::contact(c, d));
    prop_assert_eq!(first.is_some(), second.is_some(), "{}", name);
    if let (Some(first), Some(second)) = (first, second) {
        prop_assert_eq!(first.depth(), second.depth(), "{}", name);
        prop_assert_eq!(first.is_degenerate(), second.is_degenerate(), "{}", name);
        if !first.is_degenerate() {
            prop_assert_eq!(directions(&first).map(map), directions(&second), "{}", name);
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 20_000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn mirrored_and_transposed_scenes((a, b) in pairs()) {
        for (name, map) in MAPS {
            let (c, d) = (a.map(map), b.map(map));
            same(name, (&a, &b), (&c, &d), map)?;
            prop_assert_eq!(kernel::contains(&a, &b), kernel::contains(&c, &d), "{}", name);
            // Each component is rounded separately, ties toward the query's point: the same for
            // mirror images.
            let p = b.vertices()[0];
            prop_assert_eq!(map(kernel::closest_point(&a, p)), kernel::closest_point(&c, map(p)), "{}", name);
        }
    }

    #[test]
    fn moved_scenes((a, b) in pairs(), dx in -1_000_000_000i64..1_000_000_000, dy in -70_000i64..70_000) {
        for by in [(dx, dy), (dy, dx), (dx % 3, dy % 3)] {
            let (c, d) = (a.moved(by), b.moved(by));
            if c.in_domain() && d.in_domain() {
                same("move", (&a, &b), (&c, &d), |p| p)?;
                let moved = |p: Point| (p.0 + by.0, p.1 + by.1);
                let points = kernel::closest_points(&a, &b).map(|(p, q)| (moved(p), moved(q)));
                prop_assert_eq!(points, kernel::closest_points(&c, &d));
                let points = |a, b| kernel::contact(a, b).map(|c| (kernel::point(c.point_on_a()), kernel::point(c.point_on_b())));
                prop_assert_eq!(points(&a, &b).map(|(p, q)| (moved(p), moved(q))), points(&c, &d));
            }
        }
    }

    #[test]
    fn exchanged_shapes((a, b) in pairs()) {
        same("exchange", (&a, &b), (&b, &a), |p| (-p.0, -p.1))?;
        let exchanged = kernel::closest_points(&b, &a).map(|(p, q)| (q, p));
        prop_assert_eq!(kernel::closest_points(&a, &b), exchanged);
    }

    #[test]
    fn reversed_segments((a, b) in pairs()) {
        let reversed = |f: Figure| match f {
            Figure::Segment { a, b } => Figure::Segment { a: b, b: a },
            other => other,
        };
        let (c, d) = (reversed(a), reversed(b));
        same("reverse", (&a, &b), (&c, &d), |p| p)?;
        let degenerate = |a, b| kernel::contact(a, b).map(|c| (directions(&c), c.is_degenerate()));
        prop_assert_eq!(degenerate(&a, &b), degenerate(&c, &d));
        let p = b.vertices()[0];
        prop_assert_eq!(kernel::closest_point(&a, p), kernel::closest_point(&c, p));
        prop_assert_eq!(kernel::closest_points(&a, &b), kernel::closest_points(&c, &d));
    }
}
