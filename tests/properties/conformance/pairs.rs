//! `pairs.csv` and `closest.csv`: two shapes at rest, from the exact judge.

use super::portable;
use super::table::{Table, bit, figure, maybe, pair, reduced};
use tilesat_judge::num_bigint::BigInt;
use tilesat_judge::oracle::figure::{Figure, PAIRS, Point};
use tilesat_judge::oracle::generate::{CLASSES, Pairs};
use tilesat_judge::oracle::int256::Int256;
use tilesat_judge::oracle::measure::{Measure, contains};
use tilesat_judge::oracle::nearest::nearest_point;
use tilesat_judge::oracle::sum::{Place, Sum};

const EACH: usize = 34;
pub(crate) const COLUMNS: &str = "id,source,theirs,a,b,overlaps,touches,a_contains_b,b_contains_a,place,square_num,square_den,radius,depth_up,distance_down,normal";

/// Decimal digits, of a fraction in lowest terms.
pub(crate) fn fraction(num: Int256, den: Int256) -> (BigInt, BigInt) {
    let big = |n: Int256| {
        let bytes: Vec<u8> = n.limbs().iter().flat_map(|limb| limb.to_le_bytes()).collect();
        BigInt::from_signed_bytes_le(&bytes)
    };
    let ratio = num_rational::BigRational::new(big(num), big(den));
    (ratio.numer().clone(), ratio.denom().clone())
}

/// The shortest way out, from A to B. `None` if there are several.
fn only_exit(sum: &Sum, exact: &Measure) -> Option<Point> {
    if !exact.one_exit {
        return None;
    }
    let edges = sum.edges().map(|(p, q)| (q.1 - p.1, p.0 - q.0));
    let all = edges.chain(sum.points().iter().copied()).flat_map(|u| [u, (-u.0, -u.1)]);
    all.filter(|u| *u != (0, 0)).find(|u| exact.is_shortest_exit(sum, *u)).map(reduced)
}

/// The least n for which a test holds. It holds for all greater n.
fn least(mut holds: impl FnMut(i64) -> bool) -> i64 {
    let (mut low, mut high) = (-1i64, 1i64 << 32);
    while high - low > 1 {
        let middle = i64::midpoint(low, high);
        if holds(middle) { high = middle } else { low = middle }
    }
    high
}

/// Two shapes as text, their sum, and whether each contains the other.
pub(crate) struct Two {
    pub(crate) a: String,
    pub(crate) b: String,
    pub(crate) sum: Sum,
    pub(crate) contains: [bool; 2],
}

impl Two {
    fn of(a: &Figure, b: &Figure) -> Self {
        Self { a: figure(a), b: figure(b), sum: Sum::new(a, b), contains: [contains(a, b), contains(b, a)] }
    }
}

pub(crate) fn row(id: usize, source: &str, theirs: &str, two: Two) -> Vec<String> {
    let (sum, exact) = (two.sum, Measure::of(&two.sum));
    let place = match exact.place {
        Place::Inside => "inside",
        Place::On => "on",
        Place::Outside => "outside",
    };
    let (num, den) = fraction(exact.square.num, exact.square.den);
    let overlap = exact.overlaps();
    let depth = overlap.then(|| least(|d| deeper(&exact, d)));
    let distance = if exact.touches() { 0 } else { least(|d| exact.square.root_minus(exact.radius + d + 1) < 0) };
    vec![
        id.to_string(),
        source.into(),
        theirs.into(),
        two.a,
        two.b,
        bit(overlap),
        bit(exact.touches()),
        bit(two.contains[0]),
        bit(two.contains[1]),
        place.into(),
        num.to_string(),
        den.to_string(),
        exact.radius.to_string(),
        maybe(depth),
        distance.to_string(),
        if overlap { maybe(only_exit(&sum, &exact).map(pair)) } else { String::new() },
    ]
}

/// Whether a length is at least the depth.
fn deeper(exact: &Measure, d: i64) -> bool {
    match exact.place {
        Place::Inside => d >= exact.radius && exact.square.root_minus(d - exact.radius) <= 0,
        _ => exact.square.root_minus(exact.radius - d) >= 0,
    }
}

pub(crate) fn make() -> Table {
    let mut table = Table::new(COLUMNS);
    for case in portable::pairs() {
        table.push(&row(table.rows.len(), case.source, case.theirs, Two::of(&case.a, &case.b)));
    }
    for (pair, class) in PAIRS.iter().flat_map(|p| CLASSES.map(|c| (*p, c))) {
        let mut pairs = Pairs::new(pair, class, 0xc5f);
        for _ in 0..EACH {
            let (a, b) = pairs.next();
            table.push(&row(table.rows.len(), &format!("{class:?}").to_lowercase(), "", Two::of(&a, &b)));
        }
    }
    table
}

/// The point of a shape nearest to a point: `(x, y) / den + arm * (ux, uy) / |u|`.
pub(crate) fn closest() -> Table {
    let mut table = Table::new("id,shape,point,inside,x_num,y_num,den,arm,u");
    for (pair_of, class) in [PAIRS[0], PAIRS[1], PAIRS[3]].iter().flat_map(|p| CLASSES.map(|c| (*p, c))) {
        let mut pairs = Pairs::new(pair_of, class, 0xc1d);
        for _ in 0..20 {
            let (first, second) = pairs.next();
            // For the third pair it is the segment's point. The other point belongs to the other
            // shape.
            let (shape, other) =
                if matches!(second, Figure::Segment { .. }) { (second, first) } else { (first, second) };
            let p = other.vertices()[0];
            let point = Figure::Circle { centre: p, radius: 0 };
            let inside = Measure::new(&shape, &point).touches();
            let (x, y, den, arm, u) = match shape {
                _ if inside => (p.0.into(), p.1.into(), 1.into(), 0, (0, 0)),
                Figure::Circle { centre, radius } => (
                    centre.0.into(),
                    centre.1.into(),
                    BigInt::from(1),
                    radius,
                    reduced((p.0 - centre.0, p.1 - centre.1)),
                ),
                _ => {
                    let near = nearest_point(&Sum::new(&shape, &point)).at.plus(p);
                    let ((x, d), (y, e)) = (fraction(near.x, near.den), fraction(near.y, near.den));
                    // One denominator for both.
                    (&x * &e, &y * &d, &d * &e, 0, (0, 0))
                }
            };
            let cells = [
                table.rows.len().to_string(),
                figure(&shape),
                pair(p),
                bit(inside),
                x.to_string(),
                y.to_string(),
                den.to_string(),
                arm.to_string(),
                pair(u),
            ];
            table.push(&cells);
        }
    }
    table
}
