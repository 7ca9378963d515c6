//! `casts.csv`: a shape that moves toward another, from the exact judge.

use super::portable;
use super::table::{Table, bit, figure, list, maybe, pair, reduced};
use tilesat_judge::Random;
use tilesat_judge::casts::judge::{Forbidden, ONE};
use tilesat_judge::oracle::figure::{Figure, PAIRS, Point};
use tilesat_judge::oracle::generate::{CLASSES, Class, Pairs};
use tilesat_judge::oracle::int256::Int256;

const EACH: usize = 26;
pub(crate) const COLUMNS: &str = "id,source,theirs,a,motion,b,inside,hit,toi30,toi_num,toi_den,normals";

/// The time at which a path enters a convex polygon, `num / den`, and the sides (outward normals).
/// `None` if it does not meet the inside. Coordinates are below 2^30: products of three of them are
/// below 2^93.
pub(crate) fn entry(hull: &[Point], d: Point) -> Option<((i128, i128), Vec<Point>)> {
    if hull.len() < 3 {
        return None;
    }
    let edges = (0..hull.len()).map(|i| (hull[i], hull[(i + 1) % hull.len()]));
    let cross = |a: Point, b: Point| i128::from(a.0) * i128::from(b.1) - i128::from(a.1) * i128::from(b.0);
    let (mut from, mut to) = ((0, 1), (1, 1));
    let mut sides = Vec::new();
    for (a, b) in edges {
        let e = (b.0 - a.0, b.1 - a.1);
        // Inside is where cross(e, p - a) > 0: rise * t > wanted.
        let (rise, wanted) = (cross(e, d), cross(e, a));
        let normal = reduced((e.1, -e.0));
        if rise > 0 {
            let before: i128 = wanted * from.1 - from.0 * rise;
            if before > 0 {
                (from, sides) = ((wanted, rise), vec![normal]);
            } else if before == 0 {
                sides.push(normal);
            }
        } else if rise < 0 {
            if -wanted * to.1 < to.0 * -rise {
                to = (-wanted, -rise);
            }
        } else if wanted >= 0 {
            return None;
        }
    }
    (from.0 * to.1 < to.0 * from.1).then(|| {
        sides.sort_unstable();
        (lowest(from), sides)
    })
}

pub(crate) fn lowest((num, den): (i128, i128)) -> (i128, i128) {
    fn gcd(a: i128, b: i128) -> i128 {
        if b == 0 { a.abs() } else { gcd(b, a % b) }
    }
    let g = gcd(num, den).max(1);
    (num / g, den / g)
}

/// The greatest part of 2^30 before which it does not meet the set.
fn floor(set: &Forbidden, d: Point) -> i64 {
    let (mut low, mut high) = (0, ONE);
    while high - low > 1 {
        let middle = i64::midpoint(low, high);
        if set.met::<Int256>(d, middle) { high = middle } else { low = middle }
    }
    low
}

/// The row of a set of positions that overlap, around the position of A.
pub(crate) fn row(
    id: usize,
    source: &str,
    theirs: &str,
    (a, b): (&str, &str),
    set: &Forbidden,
    d: Point,
) -> Vec<String> {
    let inside = set.holds::<Int256>((0, 0));
    let hit = !inside && set.met::<Int256>(d, ONE);
    let exact = if hit && set.radius == 0 { entry(&set.hull, d) } else { None };
    let toi = hit.then(|| floor(set, d));
    if let (Some(((num, den), _)), Some(toi)) = (&exact, toi) {
        assert_eq!((num << 30).div_euclid(*den), i128::from(toi), "two judges: {a} {b} {d:?}");
    }
    let time = exact.as_ref().map(|e| e.0);
    vec![
        id.to_string(),
        source.into(),
        theirs.into(),
        a.into(),
        pair(d),
        b.into(),
        bit(inside),
        bit(hit),
        maybe(toi),
        maybe(time.map(|t| t.0)),
        maybe(time.map(|t| t.1)),
        exact.map_or_else(String::new, |e| list(&e.1)),
    ]
}

pub(crate) fn make() -> Table {
    let mut table = Table::new(COLUMNS);
    let of = |id, source: &str, theirs: &str, (a, b): (&Figure, &Figure), d| {
        row(id, source, theirs, (&figure(a), &figure(b)), &Forbidden::new(a, b), d)
    };
    for case in portable::casts() {
        table.push(&of(table.rows.len(), case.source, case.theirs, (&case.a, &case.b), case.d));
    }
    for (kinds, class) in PAIRS.iter().flat_map(|p| CLASSES.map(|c| (*p, c))) {
        let (mut pairs, mut r) = (Pairs::new(kinds, class, 0xca5), Random::new(0xd15 + class as u64));
        let mut made = 0;
        while made < EACH {
            let (a, b) = pairs.next();
            let most = if class == Class::Domain { (1 << 28) - 1 } else { 1 << 22 };
            let u = (r.sign() * r.magnitude(most / 9), if r.one_in(4) { 0 } else { r.sign() * r.magnitude(most / 9) });
            let (n, i) = (r.within(1, 9), r.within(0, 9));
            // Through the pair's position, from it, or to it, in either direction.
            let i = i.min(n);
            let start = a.moved((-u.0 * i, -u.1 * i));
            if start.in_domain() && start.moved((u.0 * n, u.1 * n)).in_domain() {
                let source = format!("{class:?}").to_lowercase();
                table.push(&of(table.rows.len(), &source, "", (&start, &b), (u.0 * n, u.1 * n)));
                made += 1;
            }
        }
    }
    table
}
