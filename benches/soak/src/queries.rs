//! Pairs of shapes in adversarial classes. The fast judge checks every answer of the library, and
//! the slow judges check some.

use crate::quick;
use tilesat::Inside;
use tilesat_judge::Random;
use tilesat_judge::casts::ask::{self, cast};
use tilesat_judge::oracle::figure::{Figure, Kind, LIMIT, PAIRS, Point};
use tilesat_judge::oracle::generate::{self, Pairs, UNIT, aabb};
use tilesat_judge::oracle::int256::Int256;
use tilesat_judge::oracle::kernel;
use tilesat_judge::oracle::verify;

/// Motions are smaller than this.
const MOTION: i64 = 1 << 28;
/// Each pair runs once as generated, then this often with its numbers moved by up to 2 raw.
const JITTERS: u64 = 7;
/// Pairs per batch.
const PAIRS_A_BATCH: u64 = 5_000;
/// The judges of the tests also check one pair in so many. They know axes, points, times and
/// positions.
const THOROUGH: u64 = 256;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Class {
    /// The classes of the tests: uniform, near touching, touching, far away, whole domain, one
    /// inside the other.
    Of(generate::Class),
    /// A few lattice points of any spacing, with many ties.
    Lattice,
    /// Shapes of 0 to 3 raw, up to 4 raw apart.
    Tiny,
    /// A shape as large as the domain allows, and one of a few raw on its border.
    Giant,
}

pub const CLASSES: [(&str, Class); 9] = [
    ("uniform", Class::Of(generate::Class::Uniform)),
    ("near", Class::Of(generate::Class::Near)),
    ("exact", Class::Of(generate::Class::Exact)),
    ("far", Class::Of(generate::Class::Far)),
    ("domain", Class::Of(generate::Class::Domain)),
    ("deep", Class::Of(generate::Class::Deep)),
    ("lattice", Class::Lattice),
    ("tiny", Class::Tiny),
    ("giant", Class::Giant),
];

/// Each pair of kinds in each class.
pub const ROWS: usize = PAIRS.len() * CLASSES.len();

pub fn pair_of(row: usize) -> (Kind, Kind) {
    PAIRS[row / CLASSES.len()]
}

pub fn class_of(row: usize) -> (&'static str, Class) {
    CLASSES[row % CLASSES.len()]
}

#[derive(Clone, Copy, Debug, Default)]
pub struct Tally {
    /// Answers of the library that were compared.
    pub answers: u64,
    pub pairs: u64,
    pub overlaps: u64,
    /// Pairs that touch and do not overlap.
    pub touches: u64,
    pub casts: u64,
    pub hits: u64,
    /// Pairs and casts that the slow judges checked as well.
    pub thorough: u64,
}

impl Tally {
    pub fn add(&mut self, o: &Self) {
        let sum = self.numbers().iter().zip(o.numbers()).map(|(a, b)| a + b).collect::<Vec<_>>();
        *self = Self::from(&sum).unwrap_or_default();
    }

    pub fn numbers(&self) -> [u64; 7] {
        [self.answers, self.pairs, self.overlaps, self.touches, self.casts, self.hits, self.thorough]
    }

    pub fn from(numbers: &[u64]) -> Option<Self> {
        let &[answers, pairs, overlaps, touches, casts, hits, thorough] = numbers else { return None };
        Some(Self { answers, pairs, overlaps, touches, casts, hits, thorough })
    }
}

/// Runs one batch of a row. Equal numbers give equal batches. Panics with the input if an answer is
/// wrong.
pub fn batch(row: usize, seed: u64, number: u64) -> Tally {
    let (pair, (_, class)) = (pair_of(row), class_of(row));
    let mut r = Random::new(seed.wrapping_mul(0x2545_f491_4f6c_dd1d) ^ (row as u64) << 56 ^ number);
    let mut source = Source::new(pair, class, r.next());
    let mut tally = Tally::default();
    for i in 0..PAIRS_A_BATCH {
        let (a, b) = source.next(&mut r);
        for jitter in 0..=JITTERS {
            let (a, b) = if jitter == 0 { (a, b) } else { (moved(&mut r, &a), moved(&mut r, &b)) };
            if a.in_domain() && b.in_domain() {
                let thorough = jitter == i % (JITTERS + 1) && i.is_multiple_of(THOROUGH / (JITTERS + 1));
                check(&mut r, &a, &b, thorough, &mut tally);
            }
        }
    }
    tally
}

/// The pairs of a batch.
pub fn samples(row: usize, seed: u64, count: usize) -> Vec<(Figure, Figure)> {
    let mut r = Random::new(seed);
    let mut source = Source::new(pair_of(row), class_of(row).1, r.next());
    (0..count).map(|_| source.next(&mut r)).collect()
}

/// Every number of a shape moved by up to 2 raw.
fn moved(r: &mut Random, f: &Figure) -> Figure {
    let mut by = |p: Point| (p.0 + r.around(2), p.1 + r.around(2));
    match *f {
        Figure::Aabb { min, max } => aabb(by(min), by(max)),
        Figure::Segment { a, b } => Figure::Segment { a: by(a), b: by(b) },
        Figure::Circle { centre, radius } => {
            let centre = by(centre);
            Figure::Circle { centre, radius: (radius + r.around(2)).max(0) }
        }
    }
}

fn check(r: &mut Random, a: &Figure, b: &Figure, thorough: bool, tally: &mut Tally) {
    let exact = quick::Pair::new(a, b);
    let (overlap, touch) = (exact.overlaps(), exact.touches());
    assert_eq!(kernel::overlaps(a, b), overlap, "overlaps, the judge on the right: {a:?} {b:?}");
    assert_eq!(kernel::overlaps(b, a), overlap, "overlaps, the judge on the right: {b:?} {a:?}");
    assert_eq!(kernel::touches(a, b), touch, "touches, the judge on the right: {a:?} {b:?}");
    assert_eq!(kernel::touches(b, a), touch, "touches, the judge on the right: {b:?} {a:?}");
    let contact = kernel::contact(a, b);
    assert_eq!(contact.is_some(), overlap, "contact, the judge on the right: {a:?} {b:?}");
    if let Some(contact) = contact {
        let depth = i64::from(contact.depth().to_bits());
        assert!(depth >= 1 && exact.depth_is(depth), "depth {depth}: {a:?} {b:?}");
        let free = a.moved(kernel::point(contact.push_out()));
        assert!(!quick::Pair::new(&free, b).overlaps(), "not out after {:?}: {a:?} {b:?}", contact.push_out());
    }
    let distance = kernel::distance(a, b);
    assert!(exact.distance_is(distance), "distance {distance}: {a:?} {b:?}");
    tally.pairs += 1;
    tally.answers += 6;
    tally.overlaps += u64::from(overlap);
    tally.touches += u64::from(touch && !overlap);
    if thorough {
        let pair = verify::Pair::new(a, b);
        pair.booleans();
        pair.contact();
        pair.distances();
        tally.thorough += 1;
    }
    if let Some((a, d)) = through(r, a, b) {
        motion(&a, b, d, thorough, tally);
    }
}

/// A motion of A through its position, or from or to it, and sometimes not quite there.
fn through(r: &mut Random, a: &Figure, b: &Figure) -> Option<(Figure, Point)> {
    let most = if r.one_in(4) { MOTION - 1 } else { 64 * UNIT };
    let u = match r.below(6) {
        0 => (r.sign() * r.magnitude(most), 0),
        1 => (0, r.sign() * r.magnitude(most)),
        // Along or across the line between two corners: grazing.
        2 | 3 => {
            let corner = |r: &mut Random, f: &Figure| {
                let (points, count) = f.corners();
                points[r.below(count as i64) as usize]
            };
            let f = if r.one_in(2) { a } else { b };
            let other = if r.one_in(4) { a } else { f };
            let (p, q) = (corner(r, f), corner(r, other));
            let e = (q.0 - p.0, q.1 - p.1);
            let k = 1 + e.0.abs().max(e.1.abs()) / most + r.below(8);
            if r.one_in(2) { (e.0 / k, e.1 / k) } else { (-e.1 / k, e.0 / k) }
        }
        _ => (r.sign() * r.magnitude(most), r.sign() * r.magnitude(most)),
    };
    let n = r.within(1, 9);
    let i = r.within(0, n);
    let (u, d) = if u.0.abs().max(u.1.abs()) * n < MOTION { (u, (u.0 * n, u.1 * n)) } else { ((u.0 / n, u.1 / n), u) };
    let off = if r.one_in(2) { (0, 0) } else { (r.around(2), r.around(2)) };
    let a = a.moved((off.0 - u.0 * i, off.1 - u.1 * i));
    (a.in_domain() && d.0.abs().max(d.1.abs()) < MOTION).then_some((a, d))
}

fn motion(a: &Figure, b: &Figure, d: Point, thorough: bool, tally: &mut Tally) {
    let exact = quick::Pair::new(a, b);
    let wanted = !exact.overlaps() && exact.is_met(d);
    let answer = cast(a, b, d, Inside::Ignore).unwrap_or_else(|e| panic!("{e}: {a:?} by {d:?} on {b:?}"));
    assert_eq!(answer.yes, wanted, "would_hit, the judge on the right: {a:?} by {d:?} on {b:?}");
    assert_eq!(answer.hit.is_some(), wanted, "cast_shape, the judge on the right: {a:?} by {d:?} on {b:?}");
    if let (Some(hit), Some(floor)) = (answer.hit, answer.exact) {
        let there = a.moved(kernel::point(hit.displacement));
        assert!(!quick::Pair::new(&there, b).overlaps(), "ends inside, {hit:?}: {a:?} by {d:?} on {b:?}");
        assert!(hit.toi <= floor, "late, {hit:?}, exact {floor:?}: {a:?} by {d:?} on {b:?}");
    }
    tally.answers += 2;
    tally.casts += 1;
    tally.hits += u64::from(wanted);
    if thorough {
        // Within two raw along both axes, and one for an early time.
        ask::check::<Int256>(a, b, d, 4);
        tally.thorough += 1;
    }
}

/// The sources of pairs.
struct Source {
    kinds: (Kind, Kind),
    class: Class,
    known: Option<Pairs>,
}

impl Source {
    fn new(kinds: (Kind, Kind), class: Class, seed: u64) -> Self {
        let known = if let Class::Of(class) = class { Some(Pairs::new(kinds, class, seed)) } else { None };
        Self { kinds, class, known }
    }

    fn next(&mut self, r: &mut Random) -> (Figure, Figure) {
        if let Some(pairs) = &mut self.known {
            return pairs.next();
        }
        loop {
            let (a, b) = match self.class {
                Class::Lattice => {
                    let unit = [1, 3, UNIT, 16_777_213][r.below(4) as usize];
                    let size = r.within(1, 15);
                    (lattice(r, self.kinds.0, size, unit), lattice(r, self.kinds.1, size, unit))
                }
                Class::Tiny => {
                    let by = (r.sign() * r.magnitude(LIMIT - 16), r.sign() * r.magnitude(LIMIT - 16));
                    let size = r.within(1, 3);
                    let (a, b) = (lattice(r, self.kinds.0, size, 1), lattice(r, self.kinds.1, size, 1));
                    (a.moved(by), b.moved(by))
                }
                _ => giant(r, self.kinds),
            };
            if a.in_domain() && b.in_domain() {
                return (a, b);
            }
        }
    }
}

fn lattice(r: &mut Random, kind: Kind, size: i64, unit: i64) -> Figure {
    let mut n = || r.around(size) * unit;
    shape(kind, (n(), n()), (n(), n()))
}

fn shape(kind: Kind, p: Point, q: Point) -> Figure {
    match kind {
        Kind::Aabb => aabb(p, q),
        Kind::Circle => Figure::Circle { centre: p, radius: (q.0 - p.0).abs() },
        Kind::Segment => Figure::Segment { a: p, b: q },
    }
}

/// The second shape sits on a corner or a side of the first. For a circle: as near to it as the
/// lattice allows.
fn giant(r: &mut Random, kinds: (Kind, Kind)) -> (Figure, Figure) {
    let end = LIMIT - 1;
    let mut far = || r.sign() * (end - r.magnitude(end));
    let (p, q) = ((far(), far()), (far(), far()));
    let first = match kinds.0 {
        Kind::Circle => {
            let centre = (p.0 / 8, p.1 / 8);
            Figure::Circle { centre, radius: end - centre.0.abs().max(centre.1.abs()) - r.magnitude(end / 2) }
        }
        kind => shape(kind, p, q),
    };
    let on = match first {
        Figure::Circle { centre, radius } => {
            let x = r.around(radius);
            (centre.0 + x, centre.1 + r.sign() * (radius * radius - x * x).isqrt())
        }
        _ => {
            let (corners, count) = first.corners();
            let i = r.below(count as i64) as usize;
            let (u, v, k) = (corners[i], corners[(i + 1) % count], r.within(0, 4));
            (u.0 + (v.0 - u.0) / 4 * k, u.1 + (v.1 - u.1) / 4 * k)
        }
    };
    let size = if r.one_in(4) { end / 4 } else { 3 };
    let mut n = || r.around(size);
    (first, shape(kinds.1, (on.0 + n().signum() * 2, on.1 + n().signum() * 2), (on.0 + n(), on.1 + n())))
}
