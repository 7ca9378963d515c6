//! Joins polygons of neighbouring tiles to few large ones. Common borders of two of them disappear.
//!
//! Sums up the borders of all polygons, each with its solid on the right (y down). Opposite edges
//! cancel, and the number of polygons around each point stays the same. The rest forms loops again:
//! loops in a polygon's direction are solid, and the others are holes.

use std::cmp::Ordering;
use std::collections::{BTreeMap, HashMap};

use crate::geometry::{Point, crossing, doubled_area};

/// A loop: its corners, and whether it is a hole.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Loop {
    pub(super) points: Vec<Point>,
    pub(super) hole: bool,
}

/// A line that contains edges. Its direction is reduced and points right or straight down. Also its
/// distance from the origin.
type Carrier = (i64, i64, i128);

/// The borders of these polygons as loops. Their order does not depend on the order of the
/// polygons.
pub(super) fn union(polygons: &[Vec<Point>]) -> Vec<Loop> {
    loops(&left_over(polygons))
}

fn cross(a: Point, b: Point) -> i128 {
    i128::from(a.0) * i128::from(b.1) - i128::from(a.1) * i128::from(b.0)
}

/// The greatest excess of polygons with a border in one direction over the other, at one point of a
/// line.
pub(crate) fn depth(polygons: &[Vec<Point>]) -> u32 {
    let edges = runs(polygons).map(|(_, count)| count.unsigned_abs());
    edges.max().unwrap_or(0)
}

/// The edges that do not cancel, directed.
fn left_over(polygons: &[Vec<Point>]) -> Vec<(Point, Point)> {
    let directed = |((start, end), count): ((Point, Point), i32)| {
        let edge = if count > 0 { (start, end) } else { (end, start) };
        std::iter::repeat_n(edge, count.unsigned_abs() as usize)
    };
    runs(polygons).flat_map(directed).collect()
}

/// Parts of lines, and the excess of forward edges over backward ones.
fn runs(polygons: &[Vec<Point>]) -> impl Iterator<Item = ((Point, Point), i32)> {
    // For each line: the points where edges begin or end, and the change of their number.
    let mut lines: BTreeMap<Carrier, BTreeMap<Point, i32>> = BTreeMap::new();
    for points in polygons {
        let right = doubled_area(points) > 0;
        for (&a, &b) in points.iter().zip(points.iter().skip(1).chain(points.first())).filter(|(a, b)| a != b) {
            let (from, to) = if right { (a, b) } else { (b, a) };
            let (dx, dy) = (to.0 - from.0, to.1 - from.1);
            let divisor = gcd(dx.unsigned_abs(), dy.unsigned_abs()) as i64;
            let sign = if (dx, dy) > (0, 0) { 1 } else { -1 };
            let dir = (sign * dx / divisor, sign * dy / divisor);
            let line = lines.entry((dir.0, dir.1, cross(dir, from))).or_default();
            // Along a line that points right or down, points are in sorted order.
            *line.entry(from.min(to)).or_default() += sign as i32;
            *line.entry(from.max(to)).or_default() -= sign as i32;
        }
    }
    lines.into_values().flat_map(|line| {
        let (mut count, mut start) = (0, None);
        let mut parts = Vec::new();
        for (point, change) in line {
            parts.extend(start.filter(|_| count != 0).map(|start| ((start, point), count)));
            count += change;
            start = Some(point);
        }
        parts
    })
}

fn gcd(a: u64, b: u64) -> u64 {
    if b == 0 { a.max(1) } else { gcd(b, a % b) }
}

/// Edges that lead into each other: at each point, as many begin as end.
fn loops(edges: &[(Point, Point)]) -> Vec<Loop> {
    let next = followers(edges);
    let (mut done, mut found) = (vec![false; edges.len()], Vec::new());
    for first in 0..edges.len() {
        let (mut points, mut edge) = (Vec::new(), first);
        while !done[edge] {
            done[edge] = true;
            points.push(edges[edge].0);
            edge = next[edge];
        }
        let mut parts = simple(points);
        while let Some(points) = parts.pop().map(straight) {
            let area = doubled_area(&points);
            if area != 0 {
                found.push(Loop { points, hole: area < 0 });
            } else {
                // Its lobes cancel, and each of them alone is a border.
                parts.extend(halves(&points).into_iter().flatten());
            }
        }
    }
    found
}

/// The edge that follows each edge.
///
/// Around a point, the solid begins right of an edge that leaves, and ends at one that arrives.
/// These two belong to one loop, and solids over each other nest like brackets. So no two ways
/// through a point cross there, and polygons that only meet in a corner stay apart.
fn followers(edges: &[(Point, Point)]) -> Vec<usize> {
    // The direction of an edge as seen from the point, whether it leaves, and its number.
    let mut around: HashMap<Point, Vec<(Point, bool, usize)>> = HashMap::new();
    for (number, &(a, b)) in edges.iter().enumerate() {
        let (x, y) = (b.0 - a.0, b.1 - a.1);
        around.entry(a).or_default().push(((x, y), true, number));
        around.entry(b).or_default().push(((-x, -y), false, number));
    }
    let mut next: Vec<usize> = (0..edges.len()).collect();
    for mut rays in around.into_values() {
        rays.sort_by(|a, b| clockwise(a.0, b.0).then(a.2.cmp(&b.2)));
        let (mut open, mut closed) = (Vec::new(), vec![false; rays.len()]);
        // A solid can begin before the last ray and end behind the first one.
        for (i, &(_, leaves, number)) in rays.iter().enumerate().cycle().take(2 * rays.len()) {
            if closed[i] {
                continue;
            }
            if leaves {
                closed[i] = true;
                open.push(number);
            } else if let Some(follower) = open.pop() {
                closed[i] = true;
                next[number] = follower;
            }
        }
    }
    next
}

/// The order of two directions, clockwise from the right (y down).
fn clockwise(a: Point, b: Point) -> Ordering {
    let upper = |d: Point| d.1 < 0 || d.1 == 0 && d.0 < 0;
    upper(a).cmp(&upper(b)).then(0.cmp(&cross(a, b)))
}

/// Splits a loop at each point that it passes twice. A hole that touches the border of its solid is
/// a loop of its own.
fn simple(points: Vec<Point>) -> Vec<Vec<Point>> {
    let (mut way, mut on_way, mut found) = (Vec::new(), HashMap::new(), Vec::new());
    for point in points {
        if let Some(&from) = on_way.get(&point) {
            let part: Vec<Point> = way.split_off(from);
            for passed in &part {
                on_way.remove(passed);
            }
            found.push(part);
        }
        on_way.insert(point, way.len());
        way.push(point);
    }
    found.push(way);
    found
}

/// Splits a loop where it first crosses itself. Borders of polygons over each other do.
pub(super) fn halves(points: &[Point]) -> Option<[Vec<Point>; 2]> {
    let (from, to, at) = crossing(points, |_| true)?;
    let mut parts = [points[from + 1..=to].to_vec(), [&points[to + 1..], &points[..=from]].concat()];
    for part in &mut parts {
        part.retain(|p| *p != at);
        part.push(at);
    }
    Some(parts)
}

/// Removes the points at which its way goes straight on.
fn straight(points: Vec<Point>) -> Vec<Point> {
    let count = points.len();
    let is_corner = |i: usize| {
        let (a, b, c) = (points[(i + count - 1) % count], points[i], points[(i + 1) % count]);
        cross((b.0 - a.0, b.1 - a.1), (c.0 - b.0, c.1 - b.1)) != 0
    };
    let corners: Vec<Point> = (0..count).filter(|&i| is_corner(i)).map(|i| points[i]).collect();
    if corners.len() < 3 { points } else { corners }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Edge, Meeting, Side, meet, winding};

    /// A quarter of a cell.
    const QUARTER: i64 = 1 << 14;
    /// Full, halves and slopes, in quarters of a cell.
    const SHAPES: [&[Point]; 8] = [
        &[(0, 0), (4, 0), (4, 4), (0, 4)],
        &[(2, 0), (4, 0), (4, 4), (2, 4)],
        &[(0, 2), (4, 2), (4, 4), (0, 4)],
        &[(4, 0), (4, 4), (0, 4)],
        &[(0, 0), (4, 0), (0, 4)],
        &[(0, 0), (4, 4), (0, 4)],
        &[(0, 4), (4, 2), (4, 4)],
        &[(0, 0), (4, 0), (4, 2)],
    ];

    fn at(shape: usize, (x, y): Point) -> Vec<Point> {
        SHAPES[shape].iter().map(|p| ((x + p.0) * QUARTER, (y + p.1) * QUARTER)).collect()
    }

    /// How often polygons wind around points between all lines, four in a quarter of a cell.
    fn solid(polygons: &[Vec<Point>]) -> Vec<i32> {
        let middles = |i: i64| i * QUARTER / 2 + 1777;
        let points = (-1..50).flat_map(|j| (-1..50).map(move |i| (2 * middles(i), 2 * middles(j) + 2 * 3226)));
        points.map(|p| polygons.iter().map(|points| winding(points, p)).sum()).collect()
    }

    fn joined(polygons: &[Vec<Point>]) -> Vec<Vec<Point>> {
        union(polygons).into_iter().map(|path| path.points).collect()
    }

    /// Whether no two edges meet within one, and no two corners of a loop are at one point.
    fn is_simple(points: &[Point]) -> bool {
        let ends = points.iter().zip(points.iter().cycle().skip(1)).zip(0..);
        let edges: Vec<Edge> =
            ends.map(|((&a, &b), number)| Edge { a, b, outline: None, number, side: Side::Solid }).collect();
        let apart = |i: usize, j: usize| match meet(&edges[i], &edges[j]) {
            Meeting::Apart => true,
            Meeting::SharedEnd(_) => j == i + 1 || i == 0 && j + 1 == edges.len(),
            _ => false,
        };
        (0..edges.len()).all(|j| (0..j).all(|i| apart(i, j)))
    }

    /// Two lobes of one area, one of them a pocket, touched in a corner of three tiles.
    #[test]
    fn a_pocket_beside_a_half() {
        let tiles = [at(1, (6, 12)), at(3, (10, 12)), at(3, (6, 16)), at(3, (10, 16))];
        let loops = joined(&tiles);
        assert_eq!(solid(&loops), solid(&tiles));
        assert!(loops.iter().all(|points| is_simple(points)), "{loops:?}");
    }

    /// Layers of random tiles, moved by halves of a cell against each other.
    #[test]
    fn the_union_is_as_solid_as_its_tiles() {
        let mut state = 1u64;
        let mut random = |below: u64| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) % below
        };
        for case in 0..400 {
            let mut tiles = Vec::new();
            for _ in 0..=random(2) {
                let moved = (2 * random(2) as i64, 2 * random(2) as i64);
                let cells: Vec<Point> = (0..20).map(|i| (i % 5 * 4 + moved.0, i / 5 * 4 + moved.1)).collect();
                tiles.extend(cells.into_iter().filter_map(|cell| {
                    let (shape, drawn) = (random(8) as usize, random(3) > 0);
                    drawn.then(|| at(shape, cell))
                }));
            }
            let loops = joined(&tiles);
            assert_eq!(solid(&loops), solid(&tiles), "case {case}");
            let apart = solid(&tiles).iter().all(|&count| count < 2);
            assert!(!apart || loops.iter().all(|points| is_simple(points)), "case {case}: {loops:?}");
        }
    }
}
