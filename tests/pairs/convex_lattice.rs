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
