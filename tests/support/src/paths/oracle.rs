//! Which cells a segment meets, and how often a point is wound around, in 128-bit integers.

use super::level::{Level, Point, SOLID, Seg, Shape};
use crate::gcd;
use std::collections::HashMap;
use tilesat::PathKind;

fn cross(u: (i128, i128), v: (i128, i128)) -> i128 {
    u.0 * v.1 - u.1 * v.0
}

fn wide(p: Point) -> (i128, i128) {
    (i128::from(p.0), i128::from(p.1))
}

/// Whether a closed segment meets a closed box: clipped by the four sides, with fractions of the
/// segment as (number, positive divisor).
pub fn meets(a: Point, b: Point, lo: Point, hi: Point) -> bool {
    let (mut from, mut to) = ((0i128, 1i128), (1i128, 1i128));
    for (a, b, lo, hi) in [(a.0, b.0, lo.0, hi.0), (a.1, b.1, lo.1, hi.1)] {
        let (a, d, lo, hi) = (i128::from(a), i128::from(b - a), i128::from(lo), i128::from(hi));
        if d == 0 {
            if a < lo || a > hi {
                return false;
            }
            continue;
        }
        let (enter, leave) = if d > 0 { ((lo - a, d), (hi - a, d)) } else { ((a - hi, -d), (a - lo, -d)) };
        if enter.0 * from.1 > from.0 * enter.1 {
            from = enter;
        }
        if leave.0 * to.1 < to.0 * leave.1 {
            to = leave;
        }
    }
    from.0 * to.1 <= to.0 * from.1
}

/// Every cell has exactly the segments that meet its closed square.
pub fn check_refs(level: &Level) {
    for (index, refs) in level.refs.iter().enumerate() {
        let (x, y) = level.corner(index);
        let hi = (x + level.cell, y + level.cell);
        let met = |s: &Seg| meets(s.a, s.b(), (x, y), hi);
        let expected: Vec<u16> = (0..level.segs.len()).filter(|&i| met(&level.segs[i])).map(|i| i as u16).collect();
        assert_eq!(refs, &expected, "cell {index} of {level:?}");
    }
}

fn area2(points: &[Point]) -> i128 {
    (0..points.len()).map(|i| cross(wide(points[i]), wide(points[(i + 1) % points.len()]))).sum()
}

/// The directed edges of all polygons, the solid on the left (y up): a hole's inside is not.
pub fn polygon_edges(shapes: &[Shape]) -> Vec<(Point, Point)> {
    let mut edges = Vec::new();
    for s in shapes.iter().filter(|s| matches!(s.kind, PathKind::Solid | PathKind::Hole)) {
        let n = s.points.len();
        let against = (area2(&s.points) > 0) != (s.kind == PathKind::Solid);
        for i in 0..n {
            let (a, b) = (s.points[i], s.points[(i + 1) % n]);
            edges.push(if against { (b, a) } else { (a, b) });
        }
    }
    edges
}

/// How often the edges wind around the point `p / scale`, moved by an infinitesimal along `v` and a
/// much smaller one along `w`.
///
/// Counted where they cross the ray toward growing y.
pub fn winding(edges: &[(Point, Point)], scale: i64, p: Point, v: Point, w: Point) -> i32 {
    let sign = |terms: [i128; 3]| terms.into_iter().find(|&t| t != 0).expect("never on an edge").signum();
    let mut sum = 0;
    for &(a, b) in edges {
        let (a, b) = (wide((a.0 * scale, a.1 * scale)), wide((b.0 * scale, b.1 * scale)));
        let (p, v, w) = (wide(p), wide(v), wide(w));
        let (a_left, b_left) = (sign([a.0 - p.0, -v.0, -w.0]) < 0, sign([b.0 - p.0, -v.0, -w.0]) < 0);
        if a_left == b_left {
            continue;
        }
        let d = (b.0 - a.0, b.1 - a.1);
        let side = sign([cross(d, (p.0 - a.0, p.1 - a.1)), cross(d, v), cross(d, w)]);
        if b_left && side > 0 {
            sum += 1;
        } else if a_left && side < 0 {
            sum -= 1;
        }
    }
    sum
}

/// The winding number of every cell's reference point is that of the polygons.
pub fn check_winding(level: &Level, edges: &[(Point, Point)]) {
    for (index, &found) in level.winding.iter().enumerate() {
        let expected = winding(edges, 1, level.corner(index), (1, 0), (0, 1));
        assert_eq!(i32::from(found), expected, "cell {index} of {level:?}");
    }
}

/// On each lattice step of the polygons, the number of remaining segments is the difference of the
/// winding numbers, all in the same direction.
///
/// For levels on a small lattice: steps are counted.
pub fn check_outline(level: &Level, shapes: &[Shape]) {
    let edges = polygon_edges(shapes);
    let mut left: HashMap<(Point, Point), i32> = HashMap::new();
    for s in level.segs.iter().filter(|s| s.kind == SOLID) {
        for t in 0..s.len {
            *left.entry((s.at(t), s.at(t + 1))).or_default() += 1;
        }
    }
    let mut total = 0;
    let mut seen = std::collections::HashSet::new();
    for &(a, b) in &edges {
        let (dx, dy) = (b.0 - a.0, b.1 - a.1);
        let g = gcd(dx.abs(), dy.abs());
        let d = (dx / g, dy / g);
        for t in 0..g {
            let p = (a.0 + t * d.0, a.1 + t * d.1);
            let q = (p.0 + d.0, p.1 + d.1);
            if !seen.insert((p, q)) {
                continue;
            }
            let (along, against) = (left.get(&(p, q)).unwrap_or(&0), left.get(&(q, p)).unwrap_or(&0));
            let middle = (p.0 + q.0, p.1 + q.1);
            let side = |n: Point| winding(&edges, 2, middle, d, n);
            let step = side((-d.1, d.0)) - side((d.1, -d.0));
            assert_eq!((*along, *against), (step.max(0), (-step).max(0)), "{p:?} to {q:?} of {shapes:?}");
            total += along;
        }
    }
    // Nothing else is left.
    assert_eq!(total, left.values().sum::<i32>(), "{shapes:?}");
}
