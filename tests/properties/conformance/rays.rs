//! `rays.csv`: rays at single shapes, from the definition of a closed set.

use super::casts::lowest;
use super::portable;
use super::table::{Table, bit, figure, list, maybe, pair, reduced};
use tilesat_judge::Random;
use tilesat_judge::casts::judge::{Forbidden, ONE};
use tilesat_judge::oracle::figure::{Figure, Point};
use tilesat_judge::oracle::generate::aabb;
use tilesat_judge::oracle::int256::Int256;

const EACH: usize = 300;

/// Whether the ray stops: it enters the closed set from outside, except for a tangent of a disc.
/// From the border it must go in. From a set without an inside, it must leave the set's line.
fn is_stopped(set: &Forbidden, d: Point) -> bool {
    if set.touched::<Int256>(d, 0) {
        if set.radius > 0 || set.hull.len() > 2 {
            return set.met::<Int256>(d, ONE);
        }
        let (p, q) = (set.hull[0], set.hull[set.hull.len() - 1]);
        let e = (q.0 - p.0, q.1 - p.1);
        return d != (0, 0) && (e == (0, 0) || i128::from(e.0) * i128::from(d.1) != i128::from(e.1) * i128::from(d.0));
    }
    // A tangent does not go in, however far it leads.
    set.touched::<Int256>(d, ONE) && (set.radius == 0 || set.met::<Int256>((d.0 * 2, d.1 * 2), ONE))
}

/// The first moment of a touch of a closed set, rounded down. It touches at the least whole part.
/// That is the moment itself if the following instant is not before it. For sets with an inside.
fn floor(set: &Forbidden, d: Point) -> i64 {
    let (mut low, mut high) = (-1, ONE);
    while high - low > 1 {
        let middle = i64::midpoint(low, high);
        if set.touched::<Int256>(d, middle) { high = middle } else { low = middle }
    }
    // Exactly then, if the way up to there has nothing of the inside.
    if high > 0 && set.met::<Int256>(d, high) { high - 1 } else { high }
}

/// The first moment at a closed polygon, or a segment, and the sides there that oppose the ray.
fn first(hull: &[Point], d: Point) -> Option<((i128, i128), Vec<Point>)> {
    let cross = |a: Point, b: Point| i128::from(a.0) * i128::from(b.1) - i128::from(a.1) * i128::from(b.0);
    let mut best: Option<((i128, i128), Vec<Point>)> = None;
    let n = hull.len();
    for i in 0..if n == 1 { 0 } else { n } {
        let (a, b) = (hull[i], hull[(i + 1) % n]);
        let e = (b.0 - a.0, b.1 - a.1);
        // t = cross(a, e) / cross(d, e), at u = cross(a, d) / cross(d, e) of the side.
        let den = cross(d, e);
        // Out of a polygon, whose corners turn from x to y, the normal is (e.1, -e.0). A segment
        // has both.
        if den == 0 || (n > 2 && den > 0) {
            continue;
        }
        let (num, along, den) = (cross(a, e) * den.signum(), cross(a, d) * den.signum(), den.abs());
        if num < 0 || num > den || along < 0 || along > den {
            continue;
        }
        let side = if cross(d, e) < 0 { (e.1, -e.0) } else { (-e.1, e.0) };
        let order = best.as_ref().map(|(t, _)| (num * t.1).cmp(&(t.0 * den)));
        match order {
            Some(std::cmp::Ordering::Greater) => {}
            Some(std::cmp::Ordering::Equal) => best.as_mut().unwrap().1.push(reduced(side)),
            _ => best = Some(((num, den), vec![reduced(side)])),
        }
    }
    if best.is_none() && n < 3 {
        // A point, or along a line: the nearer end.
        let dot = |p: &Point| i128::from(p.0) * i128::from(d.0) + i128::from(p.1) * i128::from(d.1);
        best = hull.iter().map(dot).min().map(|num| ((num, dot(&d)), Vec::new()));
    }
    best.map(|(t, mut sides)| {
        sides.sort_unstable();
        sides.dedup();
        (lowest(t), sides)
    })
}

fn row(id: usize, source: &str, theirs: &str, shape: &Figure, o: Point, d: Point) -> Vec<String> {
    let set = Forbidden::new(&Figure::Segment { a: o, b: o }, shape);
    let inside = set.holds::<Int256>((0, 0));
    let hit = !inside && is_stopped(&set, d);
    // Along a line without an inside, a ray meets no side.
    let exact = if hit && set.radius == 0 { first(&set.hull, d) } else { None };
    let toi = hit.then(|| exact.as_ref().map_or_else(|| floor(&set, d), |e| ((e.0.0 << 30) / e.0.1) as i64));
    let time = exact.as_ref().map(|e| e.0);
    vec![
        id.to_string(),
        source.into(),
        theirs.into(),
        figure(shape),
        pair(o),
        pair(d),
        bit(inside),
        bit(hit),
        maybe(toi),
        maybe(time.map(|t| t.0)),
        maybe(time.map(|t| t.1)),
        exact.map_or_else(String::new, |e| list(&e.1)),
    ]
}

pub(crate) fn make() -> Table {
    let mut table = Table::new("id,source,theirs,shape,from,motion,inside,hit,toi30,toi_num,toi_den,normals");
    for case in portable::rays() {
        table.push(&row(table.rows.len(), case.source, case.theirs, &case.shape, case.from, case.d));
    }
    let mut r = Random::new(0x7a7);
    for kind in 0..3 {
        for _ in 0..EACH {
            // A lattice of four sizes, near the origin and far from it.
            let unit = [1, 4096, 65_536, 1_048_573][r.below(4) as usize];
            let by = if r.one_in(3) { (400_000_001, -300_000_007) } else { (0, 0) };
            let mut at = |n: i64| (by.0 + r.around(n) * unit, by.1 + r.around(n) * unit);
            let (p, q, o, e) = (at(4), at(4), at(8), at(8));
            let shape = match kind {
                0 => aabb(p, q),
                1 => Figure::Circle { centre: p, radius: (q.0 - p.0).abs().max((q.1 - p.1).abs()) },
                _ => Figure::Segment { a: p, b: q },
            };
            let off = if r.one_in(4) { (r.around(1), r.around(1)) } else { (0, 0) };
            let o = (o.0 + off.0, o.1 + off.1);
            table.push(&row(table.rows.len(), "lattice", "", &shape, o, (e.0 - o.0, e.1 - o.1)));
        }
    }
    table
}
