//! `convex_pairs.csv` and `convex_casts.csv`: capsules, oriented boxes and polygons with each other
//! and with the plain shapes, at rest and moving.

use super::pairs::{self, Two};
use super::table::{Table, pair, reduced};
use super::{casts, stored};
use tilesat::{Axis, Inside};
use tilesat_judge::Random;
use tilesat_judge::casts::judge::Forbidden;
use tilesat_judge::convex::ask;
use tilesat_judge::convex::generate::{CLASSES, Class, Pairs};
use tilesat_judge::convex::shape::{Shape, pairs as kinds, sum};
use tilesat_judge::convex::verify::contains;

const EACH: usize = 5;

fn text(shape: &Shape) -> String {
    match *shape {
        Shape::Aabb { min, max } => format!("B {} {}", pair(min), pair(max)),
        Shape::Circle { centre, radius } => format!("C {} {radius}", pair(centre)),
        Shape::Segment { a, b } => format!("S {} {}", pair(a), pair(b)),
        Shape::Capsule { a, b, radius } => format!("K {} {} {radius}", pair(a), pair(b)),
        Shape::Turned { centre, half, direction, radius } => {
            format!("O {} {} {} {radius}", pair(centre), pair(half), pair(direction))
        }
        Shape::Polygon { points, count, radius } => {
            let corners: Vec<_> = points[..count].iter().map(|p| pair(*p)).collect();
            format!("P {} {radius}", corners.join(" "))
        }
    }
}

fn shape(text: &str) -> Shape {
    let n: Vec<i64> = text[2..].split(' ').map(|n| n.parse().unwrap()).collect();
    let at = |i: usize| (n[i], n[i + 1]);
    match &text[..1] {
        "B" => Shape::Aabb { min: at(0), max: at(2) },
        "C" => Shape::Circle { centre: at(0), radius: n[2] },
        "S" => Shape::Segment { a: at(0), b: at(2) },
        "K" => Shape::Capsule { a: at(0), b: at(2), radius: n[4] },
        "O" => Shape::Turned { centre: at(0), half: at(2), direction: at(4), radius: n[6] },
        _ => {
            let corners: Vec<_> = n.chunks_exact(2).map(|p| (p[0], p[1])).collect();
            Shape::polygon(&corners, n[n.len() - 1])
        }
    }
}

fn streams(seed: u64) -> impl Iterator<Item = (Pairs, Class)> {
    kinds().flat_map(move |pair| CLASSES.map(|class| (Pairs::new(pair, class, seed), class)))
}

pub(crate) fn at_rest() -> Table {
    let mut table = Table::new(pairs::COLUMNS);
    for (mut pairs, class) in streams(0xc0f) {
        for _ in 0..EACH {
            let (a, b) = pairs.next();
            let two =
                Two { a: text(&a), b: text(&b), sum: sum(&a, &b), contains: [contains(&a, &b), contains(&b, &a)] };
            table.push(&super::pairs::row(table.rows.len(), &format!("{class:?}").to_lowercase(), "", two));
        }
    }
    table
}

pub(crate) fn moving() -> Table {
    let mut table = Table::new(casts::COLUMNS);
    for (mut pairs, class) in streams(0xc1a) {
        let mut r = Random::new(0xd16 + class as u64);
        let mut made = 0;
        while made < EACH {
            let (a, b) = pairs.next();
            let most = if class == Class::Domain { (1 << 28) - 1 } else { 1 << 22 };
            let d = (r.sign() * r.magnitude(most), if r.one_in(4) { 0 } else { r.sign() * r.magnitude(most) });
            // Through the pair's position, from it, or to it.
            let part = r.within(0, 2);
            let start = a.moved((-d.0 / 2 * part, -d.1 / 2 * part));
            if start.in_domain() && start.moved(d).in_domain() {
                let all = sum(&b, &start);
                let set = Forbidden { hull: all.points().to_vec(), radius: all.radius };
                let source = format!("{class:?}").to_lowercase();
                let id = table.rows.len();
                table.push(&casts::row(id, &source, "", (&text(&start), &text(&b)), &set, d));
                made += 1;
            }
        }
    }
    table
}

#[test]
fn pairs_at_rest() {
    stored("convex_pairs.csv").each(|row| {
        let (a, b) = (shape(row.text("a")), shape(row.text("b")));
        assert_eq!(ask::overlaps(&a, &b), row.yes("overlaps"), "{row:?}");
        assert_eq!(ask::touches(&a, &b), row.yes("touches"), "{row:?}");
        assert_eq!(ask::contains(&a, &b), row.yes("a_contains_b"), "{row:?}");
        assert_eq!(ask::contains(&b, &a), row.yes("b_contains_a"), "{row:?}");
        assert_eq!(ask::distance(&a, &b), row.number("distance_down"), "{row:?}");
        let contact = ask::contact(&a, &b);
        assert_eq!(contact.map(|c| i64::from(c.depth().to_bits())), row.maybe("depth_up"), "{row:?}");
        if let Some(contact) = contact {
            let normal = row.points("normal").first().copied();
            assert_eq!(contact.is_degenerate(), normal.is_none(), "{row:?}");
            assert!(normal.is_none_or(|n| n == lowest(contact.axis())), "{:?}: {row:?}", contact.axis());
        }
    });
}

fn lowest(axis: Axis) -> (i64, i64) {
    reduced((axis.x.into(), axis.y.into()))
}

#[test]
fn pairs_that_move() {
    stored("convex_casts.csv").each(|row| {
        let (a, d, b) = (shape(row.text("a")), row.point("motion"), shape(row.text("b")));
        let answer = ask::cast(&a, &b, d, Inside::Ignore).unwrap();
        assert_eq!(answer.yes, row.yes("hit"), "{row:?}");
        assert_eq!(answer.exact.map(|t| i64::from(t.raw())), row.maybe("toi30"), "{row:?}");
        assert_eq!(answer.hit.is_some(), row.yes("hit"), "{row:?}");
        let inside = ask::cast(&a, &b, d, Inside::Hit).unwrap();
        assert_eq!(inside.hit.is_some_and(|h| h.inside), row.yes("inside"), "{row:?}");
        if let Some(hit) = answer.hit {
            let normals = row.points("normals");
            assert!(normals.is_empty() || normals.contains(&lowest(hit.axis)), "{:?}: {row:?}", hit.axis);
        }
    });
}
