//! Random levels on small lattices: tiles side by side, polygons across each other, holes, walls
//! and one-way chains.

use super::level::{Point, Shape};
use crate::Random;
use tilesat::PathKind::{Hole, OneWay, Solid, Wall};

/// The polygons of tiles on the lattice 0..=2.
const TILES: [&[Point]; 8] = [
    &[(0, 0), (2, 0), (2, 2), (0, 2)],
    &[(0, 1), (2, 1), (2, 2), (0, 2)],
    &[(0, 0), (1, 0), (1, 2), (0, 2)],
    &[(0, 2), (2, 0), (2, 2)],
    &[(0, 0), (2, 0), (0, 2)],
    &[(0, 2), (2, 1), (2, 2)],
    &[(0, 1), (2, 0), (2, 2), (0, 2)],
    &[(1, 0), (2, 0), (2, 2), (0, 2)],
];

/// The same polygon from another corner on, perhaps in the other direction.
fn shuffled(random: &mut Random, mut points: Vec<Point>) -> Vec<Point> {
    let start = random.below(points.len() as i64) as usize;
    points.rotate_left(start);
    if random.one_in(2) {
        points.reverse();
    }
    points
}

/// A mosaic of up to 4 x 4 tiles: whole and partial edges shared, corners touched.
pub fn mosaic(random: &mut Random) -> Vec<Shape> {
    let (width, height) = (random.within(1, 4), random.within(1, 4));
    let mut shapes = Vec::new();
    for (x, y) in (0..width).flat_map(|x| (0..height).map(move |y| (x, y))) {
        if !random.one_in(3) {
            let tile = TILES[random.below(8) as usize];
            let points = tile.iter().map(|p| (p.0 + 2 * x, p.1 + 2 * y)).collect();
            shapes.push(Shape { kind: Solid, points: shuffled(random, points), flags: 0 });
        }
    }
    if shapes.is_empty() {
        shapes.push(Shape { kind: Solid, points: TILES[0].to_vec(), flags: 0 });
    }
    shapes
}

fn point(random: &mut Random, n: i64) -> Point {
    (random.within(0, n), random.within(0, n))
}

/// A triangle, or a rectangle, which shares lines more often.
fn polygon(random: &mut Random, n: i64) -> Vec<Point> {
    loop {
        let (p, q, r) = (point(random, n), point(random, n), point(random, n));
        if random.one_in(2) {
            if p.0 != q.0 && p.1 != q.1 {
                return shuffled(random, vec![p, (q.0, p.1), q, (p.0, q.1)]);
            }
        } else if (q.0 - p.0) * (r.1 - p.1) != (q.1 - p.1) * (r.0 - p.0) {
            return vec![p, q, r];
        }
    }
}

fn chain(random: &mut Random, n: i64) -> Vec<Point> {
    let mut points = vec![point(random, n)];
    while points.len() < 2 || !random.one_in(3) {
        let next = if points.len() > 2 && random.one_in(4) { points[0] } else { point(random, n) };
        if points.last() != Some(&next) {
            points.push(next);
        }
    }
    points
}

/// Anything over anything, on the lattice 0..=n.
pub fn heap(random: &mut Random, n: i64) -> Vec<Shape> {
    let count = random.within(1, 6);
    let mut shapes: Vec<Shape> = Vec::new();
    for _ in 0..count {
        let kind = [Solid, Solid, Hole, Wall, OneWay][random.below(5) as usize];
        let points = match kind {
            Solid | Hole if random.one_in(8) && !shapes.is_empty() => {
                shapes[random.below(shapes.len() as i64) as usize].points.clone()
            }
            Solid | Hole => polygon(random, n),
            Wall | OneWay => chain(random, n),
        };
        shapes.push(Shape { kind, points, flags: random.below(256) as u8 });
    }
    // A chain's points need not make a polygon.
    shapes.retain(|s| matches!(s.kind, Wall | OneWay) || has_area(&s.points));
    if shapes.is_empty() { mosaic(random) } else { shapes }
}

fn has_area(points: &[Point]) -> bool {
    let n = points.len();
    let closed = n > 2 && points[0] != points[n - 1];
    let twice = |i: usize| {
        let (p, q) = (points[i], points[(i + 1) % n]);
        p.0 * q.1 - p.1 * q.0
    };
    closed && (0..n).map(twice).sum::<i64>() != 0
}
