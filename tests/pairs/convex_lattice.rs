//! All triangles and quadrangles of a small lattice with each other, and with rounded corners:
//! exhaustive up to a move.

use tilesat_judge::convex::shape::{Shape, hull};
use tilesat_judge::convex::verify::Pair;
use tilesat_judge::oracle::figure::Point;

/// Every strictly convex polygon of `corners` corners with its points on a lattice of `side` by
/// `side`.
fn polygons(side: i64, corners: usize) -> Vec<Vec<Point>> {
    let all: Vec<Point> = (0..side * side).map(|i| (i % side, i / side)).collect();
    let mut found = Vec::new();
    let mut chosen = Vec::new();
    choose(&all, corners, 0, &mut chosen, &mut found);
    found
}

fn choose(all: &[Point], left: usize, from: usize, chosen: &mut Vec<Point>, found: &mut Vec<Vec<Point>>) {
    if left == 0 {
        let around = hull(chosen);
        if around.len() == chosen.len() {
            found.push(around);
        }
        return;
    }
    for i in from..all.len() {
        chosen.push(all[i]);
        choose(all, left - 1, i + 1, chosen, found);
        chosen.pop();
    }
}

/// One of `stride` pairs of the two lists; a stride of 1 is all.
fn exhaust(name: &str, first: &[Vec<Point>], second: &[Vec<Point>], stride: usize) {
    let mut count = 0u64;
    for (i, a) in first.iter().enumerate() {
        let a = Shape::polygon(a, 0);
        for b in second.iter().skip(i % stride).step_by(stride) {
            Pair::new(&a, &Shape::polygon(b, 0)).all();
            count += 1;
        }
    }
    println!("{name}: {} x {}, {count} pairs, 0 wrong", first.len(), second.len());
}

#[test]
fn triangles_with_triangles() {
    let all = polygons(3, 3);
    exhaust("triangles of 3 x 3", &all, &all, 1);
    let all = polygons(5, 3);
    exhaust("triangles of 5 x 5, one pair of 97", &all, &all, tilesat_judge::cases(97));
}

#[test]
fn triangles_with_quadrangles() {
    exhaust("of 3 x 3", &polygons(3, 3), &polygons(3, 4), 1);
    exhaust("of 5 x 5, one pair of 397", &polygons(5, 3), &polygons(5, 4), tilesat_judge::cases(397));
}

#[test]
fn quadrangles_with_quadrangles() {
    let all = polygons(3, 4);
    exhaust("quadrangles of 3 x 3", &all, &all, 1);
    let all = polygons(5, 4);
    exhaust("quadrangles of 5 x 5, one pair of 997", &all, &all, tilesat_judge::cases(997));
}

/// Rounded triangles with segments and points around them.
#[test]
fn rounded_triangles() {
    let triangles = polygons(3, 3);
    let points: Vec<Point> = (0..49).map(|i| (i % 7 - 2, i / 7 - 2)).collect();
    for t in &triangles {
        for radius in [1, 2] {
            let t = Shape::polygon(t, radius);
            for (i, a) in points.iter().enumerate() {
                Pair::new(&t, &Shape::Circle { centre: *a, radius: 1 }).all();
                for b in points.iter().skip(i).step_by(5) {
                    Pair::new(&t, &Shape::Segment { a: *a, b: *b }).all();
                }
            }
        }
    }
}

/// Tiny boxes in all directions of a lattice, rounded to parallelograms of any slant, and discs.
#[test]
fn tiny_turned_boxes_and_discs() {
    let mut count = 0u64;
    for half in [(1, 1), (1, 2), (3, 1), (2, 3)] {
        for direction in (-3..=3).flat_map(|x| (-3..=3).map(move |y| (x, y))).filter(|d| *d != (0, 0)) {
            for radius in [0, 1] {
                let turned = Shape::Turned { centre: (0, 0), half, direction, radius };
                // Far enough for a point that is beyond two sides to be beside the end of one.
                let every = tilesat_judge::thorough(5, 1);
                for centre in (-9..=9).flat_map(|x| (-9..=9).map(move |y| (x, y))).step_by(every) {
                    for radius in [0, 1, 3, 8] {
                        Pair::new(&turned, &Shape::Circle { centre, radius }).all();
                        count += 1;
                    }
                }
            }
        }
    }
    println!("{count} pairs, 0 wrong");
}

/// The same boxes with each other.
#[test]
fn tiny_turned_boxes() {
    let directions = [(1, 0), (0, 1), (1, 1), (2, 1), (-1, 3), (3, -2), (-3, -3), (1, -2)];
    let boxes: Vec<Shape> = [(1, 1), (1, 2), (3, 1), (2, 3)]
        .into_iter()
        .flat_map(|half| directions.map(|direction| Shape::Turned { centre: (0, 0), half, direction, radius: 0 }))
        .collect();
    let stride = tilesat_judge::cases(5);
    let mut count = 0u64;
    for (i, a) in boxes.iter().enumerate() {
        for b in &boxes {
            for p in (0..169).skip(i % stride).step_by(stride) {
                Pair::new(a, &b.moved((p % 13 - 6, p / 13 - 6))).all();
                count += 1;
            }
        }
    }
    println!("{count} pairs, 0 wrong");
}

/// Capsules on a lattice: parallel, crossing, and with ends on the line of the other one.
#[test]
fn capsules_of_a_lattice() {
    let points: Vec<Point> = (0..25).map(|i| (i % 5, i / 5)).collect();
    let capsule = |a: Point, b: Point, radius| Shape::Capsule { a, b, radius };
    let stride = tilesat_judge::cases(7);
    let mut count = 0u64;
    for (i, a) in points.iter().enumerate() {
        for b in &points {
            for (j, p) in points.iter().enumerate().skip(i % stride).step_by(stride) {
                for q in points.iter().skip(j) {
                    for radius in [1, 2] {
                        Pair::new(&capsule(*a, *b, radius), &capsule(*p, *q, 0)).all();
                        count += 1;
                    }
                }
            }
        }
    }
    println!("{count} pairs, 0 wrong");
}
