//! Joins polygons of neighbouring tiles to few large ones. Common borders of two of them disappear.
//!
//! Sums up the borders of all polygons, each with its solid on the right (y down). Opposite edges
//! cancel, and the number of polygons around each point stays the same. The rest forms loops again:
//! loops in a polygon's direction are solid, and the others are holes.

use std::collections::{BTreeMap, HashMap};

use crate::geometry::{Point, doubled_area};

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
    // For each line: the points where the number of edges over it changes, and the change.
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
        for (point, change) in line.into_iter().filter(|(_, change)| *change != 0) {
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
    let mut from: HashMap<Point, Vec<Point>> = HashMap::new();
    for &(a, b) in edges {
        from.entry(a).or_default().push(b);
    }
    let mut found = Vec::new();
    for &(start, second) in edges {
        let Some(at) = from.get(&start).and_then(|ends| ends.iter().position(|&end| end == second)) else { continue };
        from.entry(start).or_default().swap_remove(at);
        let (mut points, mut before, mut here) = (vec![start], start, second);
        while here != start {
            points.push(here);
            let ends = from.entry(here).or_default();
            // The sharpest turn to the solid's side separates polygons that only meet in a corner.
            let turn = |end: &Point| right_turn(before, here, *end);
            let next = ends.iter().enumerate().max_by(|a, b| turn(a.1).total_cmp(&turn(b.1))).map(|(i, _)| i);
            let Some(next) = next else { break };
            before = here;
            here = ends.swap_remove(next);
        }
        let points = straight(points);
        let area = doubled_area(&points);
        if area != 0 {
            found.push(Loop { points, hole: area < 0 });
        }
    }
    found
}

/// The turn of a way to the right at `b`, in radians.
#[allow(clippy::cast_precision_loss, reason = "nearly equal turns may come in either order")]
fn right_turn(a: Point, b: Point, c: Point) -> f64 {
    let (d, e) = ((b.0 - a.0, b.1 - a.1), (c.0 - b.0, c.1 - b.1));
    let dot = i128::from(d.0) * i128::from(e.0) + i128::from(d.1) * i128::from(e.1);
    (cross(d, e) as f64).atan2(dot as f64)
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
