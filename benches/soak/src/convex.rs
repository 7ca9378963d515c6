//! Pairs of all six shapes, capsules, oriented boxes and convex polygons too, in adversarial
//! classes. The fast judge checks every answer of the library, and the slow judge some.

use crate::queries::Tally;
use crate::quick;
use tilesat::query::Separation;
use tilesat_judge::Random;
use tilesat_judge::convex::ask;
use tilesat_judge::convex::generate::{self, Pairs, touch, wound};
use tilesat_judge::convex::shape::{KINDS, Kind, Shape, hull};
use tilesat_judge::convex::verify;
use tilesat_judge::oracle::figure::{LIMIT, Point};
use tilesat_judge::oracle::kernel::point;

/// Each pair runs once as generated, then this often with its numbers moved by a raw unit.
const JITTERS: u64 = 3;
/// Pairs per batch, with those moved.
pub const PAIRS_A_BATCH: u64 = 4_000;
/// The judge of the tests also checks one generated pair in so many.
const THOROUGH: u64 = 250;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Class {
    /// The classes of the tests: uniform, lattice, touching, near touching, whole domain, slivers.
    Of(generate::Class),
    /// Sides along one direction, of both, on each other or up to 2 raw off.
    Parallel,
    /// Corners of both are the same points.
    Shared,
    /// A shape as large as the domain allows, and one of a few raw on its border.
    Huge,
    /// Numbers at the ends of the domain.
    Ends,
}

pub const CLASSES: [(&str, Class); 10] = [
    ("uniform", Class::Of(generate::Class::Uniform)),
    ("lattice", Class::Of(generate::Class::Lattice)),
    ("touch", Class::Of(generate::Class::Touch)),
    ("near", Class::Of(generate::Class::Near)),
    ("domain", Class::Of(generate::Class::Domain)),
    ("thin", Class::Of(generate::Class::Thin)),
    ("parallel", Class::Parallel),
    ("shared", Class::Shared),
    ("huge", Class::Huge),
    ("ends", Class::Ends),
];

/// The unordered pairs of kinds, the one that is less plain first.
pub const PAIRS: usize = KINDS.len() * (KINDS.len() + 1) / 2;

/// Each pair of kinds in each class.
pub const ROWS: usize = PAIRS * CLASSES.len();

pub fn pair_of(row: usize) -> (Kind, Kind) {
    let pairs = (0..KINDS.len()).flat_map(|i| (0..=i).map(move |j| (KINDS[i], KINDS[j])));
    pairs.clone().nth(row / CLASSES.len()).unwrap_or((KINDS[0], KINDS[0]))
}

pub fn class_of(row: usize) -> (&'static str, Class) {
    CLASSES[row % CLASSES.len()]
}

/// Such as `polygon-turned/near`.
pub fn name(row: usize) -> String {
    let (a, b) = pair_of(row);
    format!("{a:?}-{b:?}/{}", class_of(row).0).to_lowercase()
}

/// Runs one batch of a row. Equal numbers give equal batches. Panics with the input if an answer is
/// wrong.
pub fn batch(row: usize, seed: u64, number: u64) -> Tally {
    let mut r = Random::new(seed.wrapping_mul(0x9fb2_1c65_1e98_df25) ^ (row as u64) << 48 ^ number);
    let mut source = Source::new(row, r.next());
    let mut tally = Tally::default();
    for i in 0.. {
        if tally.pairs >= PAIRS_A_BATCH {
            break;
        }
        let (a, b) = source.next(&mut r);
        let mut hint = Separation::default();
        check(&a, &b, &mut hint, true, &mut tally);
        if i % THOROUGH == 0 {
            verify::Pair::new(&a, &b).all();
            tally.thorough += 1;
        }
        for _ in 0..JITTERS {
            let (Some(a), Some(b)) = (moved(&mut r, &a), moved(&mut r, &b)) else { continue };
            if a.in_domain() && b.in_domain() {
                check(&a, &b, &mut hint, false, &mut tally);
            }
        }
    }
    tally
}

/// The pairs of a batch.
pub fn samples(row: usize, seed: u64, count: usize) -> Vec<(Shape, Shape)> {
    let mut r = Random::new(seed);
    let mut source = Source::new(row, r.next());
    (0..count).map(|_| source.next(&mut r)).collect()
}

/// Compares the yes/no answers in both orders. `full`: depth, way out and distance too.
pub fn check(a: &Shape, b: &Shape, hint: &mut Separation, full: bool, tally: &mut Tally) {
    let exact = quick::Pair::new(a, b);
    let (overlap, touch) = (exact.overlaps(), exact.touches());
    for (a, b) in [(a, b), (b, a)] {
        assert_eq!(ask::overlaps(a, b), overlap, "overlaps, the judge on the right: {a:?} {b:?}");
        assert_eq!(ask::touches(a, b), touch, "touches, the judge on the right: {a:?} {b:?}");
    }
    tally.pairs += 1;
    tally.answers += 4;
    tally.overlaps += u64::from(overlap);
    tally.touches += u64::from(touch && !overlap);
    if !a.is_plain() {
        // First the hint that the last pair left.
        assert_eq!(ask::overlaps_from(a, b, hint), overlap, "with {hint:?}, the judge on the right: {a:?} {b:?}");
        tally.answers += 1;
    }
    if full {
        lengths(a, b, &exact, overlap);
        lengths(b, a, &quick::Pair::new(b, a), overlap);
        tally.answers += 4;
    }
}

/// The contact with its depth and way out, and the distance.
fn lengths(a: &Shape, b: &Shape, exact: &quick::Pair, overlap: bool) {
    let contact = ask::contact(a, b);
    assert_eq!(contact.is_some(), overlap, "contact, the judge on the right: {a:?} {b:?}");
    if let Some(contact) = contact {
        let depth = i64::from(contact.depth().to_bits());
        assert!(depth >= 1 && exact.depth_is(depth), "depth {depth}: {a:?} {b:?}");
        let push = point(contact.push_out());
        assert!(!exact.moved(push).overlaps(), "not out after {push:?}: {a:?} {b:?}");
    }
    let distance = ask::distance(a, b);
    assert!(exact.distance_is(distance), "distance {distance}: {a:?} {b:?}");
}

/// Every number of a shape moved by up to a raw unit. `None` if nothing is left of a polygon.
fn moved(r: &mut Random, shape: &Shape) -> Option<Shape> {
    if r.one_in(2) {
        return Some(shape.moved((r.around(1), r.around(1))));
    }
    let radius = |r: &mut Random, n: i64| (n + r.around(1)).max(0);
    let by = |r: &mut Random, p: Point| (p.0 + r.around(1), p.1 + r.around(1));
    Some(match *shape {
        Shape::Aabb { min, max } => boxed(by(r, min), by(r, max)),
        Shape::Circle { centre, radius: n } => Shape::Circle { centre: by(r, centre), radius: radius(r, n) },
        Shape::Segment { a, b } => Shape::Segment { a: by(r, a), b: by(r, b) },
        Shape::Capsule { a, b, radius: n } => Shape::Capsule { a: by(r, a), b: by(r, b), radius: radius(r, n) },
        Shape::Turned { centre, half, direction, radius: n } => Shape::Turned {
            centre: by(r, centre),
            half: (radius(r, half.0), radius(r, half.1)),
            direction,
            radius: radius(r, n),
        },
        Shape::Polygon { points, count, radius: n } => {
            let all: Vec<Point> = points[..count].iter().map(|p| by(r, *p)).collect();
            let corners = hull(&all);
            if corners.len() < 3 {
                return None;
            }
            Shape::polygon(&corners, radius(r, n))
        }
    })
}

fn boxed(p: Point, q: Point) -> Shape {
    Shape::Aabb { min: (p.0.min(q.0), p.1.min(q.1)), max: (p.0.max(q.0), p.1.max(q.1)) }
}

/// The sources of pairs.
struct Source {
    kinds: (Kind, Kind),
    class: Class,
    known: Option<Pairs>,
}

impl Source {
    fn new(row: usize, seed: u64) -> Self {
        let (kinds, (_, class)) = (pair_of(row), class_of(row));
        let known = if let Class::Of(class) = class { Some(Pairs::new(kinds, class, seed)) } else { None };
        Self { kinds, class, known }
    }

    fn next(&mut self, r: &mut Random) -> (Shape, Shape) {
        if let Some(pairs) = &mut self.known {
            return pairs.next();
        }
        loop {
            let pair = match self.class {
                Class::Parallel => parallel(r, self.kinds),
                Class::Shared => shared(r, self.kinds),
                Class::Huge => huge(r, self.kinds),
                _ => ends(r, self.kinds),
            };
            if let Some((a, b)) = pair
                && a.in_domain()
                && b.in_domain()
            {
                return (a, b);
            }
        }
    }
}

type Both = Option<(Shape, Shape)>;

/// A radius, most often none: then sides and corners are those of the cores.
fn round(r: &mut Random, most: i64) -> i64 {
    if r.one_in(2) { 0 } else { r.magnitude(most) }
}

fn parallel(r: &mut Random, (i, j): (Kind, Kind)) -> Both {
    let size = 1 << r.within(1, 22);
    let axis = [(1, 0), (0, 1), (1, 1)][r.below(3) as usize];
    let u = if i == Kind::Aabb || j == Kind::Aabb || r.one_in(4) { axis } else { (r.around(size), r.around(size)) };
    let (a, b) = (along(r, i, u, size)?, along(r, j, u, size)?);
    let (a, b) = touch(r, a, b);
    let off = if r.one_in(2) { (0, 0) } else { (r.around(2), r.around(2)) };
    Some((a.moved(off), b))
}

/// A shape with a side along `u`, where its kind can have one.
fn along(r: &mut Random, kind: Kind, u: Point, size: i64) -> Option<Shape> {
    let times = |p: Point, k: i64| (p.0 + u.0 * k, p.1 + u.1 * k);
    let p = (r.around(size), r.around(size));
    let q = times(p, r.within(1, 8));
    Some(match kind {
        Kind::Segment => Shape::Segment { a: p, b: q },
        Kind::Capsule => Shape::Capsule { a: p, b: q, radius: round(r, size) },
        Kind::Turned if u != (0, 0) => {
            let half = (r.magnitude(4 * size), r.magnitude(4 * size));
            Shape::Turned { centre: p, half, direction: u, radius: round(r, size) }
        }
        Kind::Polygon => {
            let w = (p.0 + r.around(size), p.1 + r.around(size));
            let v = times(w, r.within(-2, 6));
            let corners = wound(r, &[p, q, v, w])?;
            Shape::polygon(&corners, round(r, size))
        }
        _ => generate::shape(r, kind, size, 1),
    })
}

/// Both take corners from the same few points.
fn shared(r: &mut Random, (i, j): (Kind, Kind)) -> Both {
    let size = 1 << r.within(1, 24);
    let mut pool = [(0, 0); 5];
    pool.iter_mut().for_each(|p| *p = (r.around(size), r.around(size)));
    let of = |r: &mut Random, kind| {
        let radius = round(r, size);
        by_corners(r, kind, &mut |r| pool[r.below(5) as usize], radius, size)
    };
    Some((of(r, i)?, of(r, j)?))
}

/// A shape by corners that are chosen one by one.
fn by_corners(
    r: &mut Random,
    kind: Kind,
    corner: &mut dyn FnMut(&mut Random) -> Point,
    radius: i64,
    size: i64,
) -> Option<Shape> {
    let (p, q) = (corner(r), corner(r));
    Some(match kind {
        Kind::Aabb => boxed(p, q),
        Kind::Circle => Shape::Circle { centre: p, radius },
        Kind::Segment => Shape::Segment { a: p, b: q },
        Kind::Capsule => Shape::Capsule { a: p, b: q, radius },
        Kind::Turned => {
            let d = if p == q { (1, 0) } else { (q.0 - p.0, q.1 - p.1) };
            let half = (r.magnitude(size), r.magnitude(size));
            let any = Shape::Turned { centre: (0, 0), half, direction: d, radius };
            let at = any.vertices()[r.below(4) as usize];
            any.moved((p.0 - at.0, p.1 - at.1))
        }
        Kind::Polygon => {
            let mut points = vec![p, q];
            (0..r.within(1, 4)).for_each(|_| points.push(corner(r)));
            Shape::polygon(&wound(r, &points)?, radius)
        }
    })
}

fn huge(r: &mut Random, (i, j): (Kind, Kind)) -> Both {
    let few = r.within(1, 6);
    if r.one_in(2) {
        let (a, b) = (generate::shape(r, i, few, 1), generate::shape(r, j, LIMIT - 1, 1));
        let (a, b) = touch(r, a, b);
        Some((a.moved((r.around(1), r.around(1))), b))
    } else {
        let (a, b) = (generate::shape(r, i, LIMIT - 1, 1), generate::shape(r, j, few, 1));
        let (b, a) = touch(r, b, a);
        Some((a, b.moved((r.around(1), r.around(1)))))
    }
}

fn ends(r: &mut Random, (i, j): (Kind, Kind)) -> Both {
    let of = |r: &mut Random, kind| {
        let radius = round(r, LIMIT - 1);
        let reach = LIMIT - 1 - radius;
        let far = |r: &mut Random| r.sign() * (reach - r.magnitude(reach));
        by_corners(r, kind, &mut |r| (far(r), far(r)), radius, reach)
    };
    let (a, b) = (of(r, i)?, of(r, j)?);
    Some(if r.one_in(2) { touch(r, a, b) } else { (a, b) })
}
