//! Rays against capsules, oriented boxes and polygons, sharp and rounded, against the exact judge:
//! every one of a small lattice, and streams that touch, nearly touch and cross the domain.
//!
//! `TILESAT_CASES` sets the number of rays per kind and class (default 1500).

use tilesat::{Inside, Vec2};
use tilesat_judge::casts::ask::is_out;
use tilesat_judge::casts::judge::{Forbidden, ONE};
use tilesat_judge::casts::number::Number;
use tilesat_judge::convex::ask::cast_ray;
use tilesat_judge::convex::generate::{CLASSES, Class, Pairs};
use tilesat_judge::convex::shape::{KINDS, Kind, Shape, sum};
use tilesat_judge::oracle::figure::{LIMIT, Point};
use tilesat_judge::oracle::int256::Int256;
use tilesat_judge::oracle::kernel::point;

/// Whether the ray stops, by the definition: it enters the closed set from outside, except for a
/// tangent of a rounded part. From the border it must go in. From a set without an inside, it must
/// leave the set's line.
fn is_stopped<N: Number>(set: &Forbidden, d: Point) -> bool {
    if set.touched::<N>(d, 0) {
        if set.radius > 0 || set.hull.len() > 2 {
            return goes_in::<N>(set, d);
        }
        let (p, q) = (set.hull[0], *set.hull.last().expect("a set has points"));
        let e = (q.0 - p.0, q.1 - p.1);
        return d != (0, 0) && (e == (0, 0) || i128::from(e.0) * i128::from(d.1) != i128::from(e.1) * i128::from(d.0));
    }
    set.touched::<N>(d, ONE) && (set.radius == 0 || goes_in::<N>(set, d))
}

/// Whether the ray, continued for ever, would enter the open set. It does not start there.
fn goes_in<N: Number>(set: &Forbidden, d: Point) -> bool {
    if set.radius == 0 {
        return d != (0, 0) && set.met::<N>((d.0 << 31, d.1 << 31), ONE);
    }
    // The part of its line within the radius of a corner, or across a side, is ahead, or all of it
    // is behind.
    let cross = |p: Point, q: Point| i128::from(p.0) * i128::from(q.1) - i128::from(p.1) * i128::from(q.0);
    let dot = |p: Point| i128::from(p.0) * i128::from(d.0) + i128::from(p.1) * i128::from(d.1);
    let reach = i128::from(set.radius).pow(2) * dot(d);
    let n = set.hull.len();
    let near = |v: &Point| dot(*v) > 0 && cross(d, *v).pow(2) < reach;
    let crosses = |i: usize| {
        let (a, b) = (set.hull[i], set.hull[(i + 1) % n]);
        let e = (b.0 - a.0, b.1 - a.1);
        cross(d, a).signum() * cross(d, b).signum() < 0 && cross(a, e).signum() == cross(d, e).signum()
    };
    set.hull.iter().any(near) || (0..n).any(crosses)
}

fn check<N: Number>(shape: &Shape, o: Point, d: Point) -> bool {
    let case = || format!("{o:?} by {d:?} on {shape:?}");
    let all = sum(shape, &Shape::Circle { centre: o, radius: 0 });
    let set = Forbidden { hull: all.points().to_vec(), radius: all.radius };
    let hit = cast_ray(shape, o, d, Inside::Ignore);
    if set.holds::<N>((0, 0)) {
        assert_eq!(hit, None, "{}", case());
        let hit = cast_ray(shape, o, d, Inside::Hit).unwrap_or_else(|| panic!("inside: {}", case()));
        assert!(hit.inside && hit.toi.raw() == 0 && hit.displacement == Vec2::ZERO, "{}", case());
        return true;
    }
    assert_eq!(hit, cast_ray(shape, o, d, Inside::Hit), "{}", case());
    assert_eq!(hit.is_some(), is_stopped::<N>(&set, d), "the judge on the right: {}", case());
    let Some(hit) = hit else { return false };
    let toi = i64::from(hit.toi.raw());
    assert!(toi <= ONE && (toi == 0 || !set.touched::<N>(d, toi - 1)), "late: {}", case());
    // Four raw units of way. For sharp sides, zero.
    let way = d.0.abs().max(d.1.abs()).max(1);
    let slack = if set.radius == 0 { 1 } else { 4 * ONE / way + 1 };
    assert!(set.touched::<N>(d, (toi + slack).min(ONE)), "early, {toi}: {}", case());
    let p = point(hit.displacement);
    assert!(!set.holds::<N>(p) && set.is_near::<N>(p, set.radius + 6), "{hit:?}: {}", case());
    // The axis is a normal of the set there. Around a corner it is the way from it.
    let along = |v: Point| i128::from(hit.axis.x) * i128::from(v.0) + i128::from(hit.axis.y) * i128::from(v.1);
    let radial = |v: &Point| {
        let way = (p.0 - v.0, p.1 - v.1);
        let axis = (i64::from(hit.axis.x), i64::from(hit.axis.y));
        if way.0 == 0 || way.1 == 0 { (way.0.signum(), way.1.signum()) == axis } else { way == axis }
    };
    if set.radius > 0 && set.hull.iter().any(radial) {
        return true;
    }
    assert!(along(d) < 0, "{hit:?}: {}", case());
    if set.radius == 0 && set.hull.len() < 3 {
        return true;
    }
    let core = set.hull.iter().map(|&v| along(v)).max().expect("a set has points");
    let square = i128::from(hit.axis.length_squared());
    assert!(is_out(along(p) - core, square, set.radius, 7), "{hit:?}: {}", case());
    true
}

const UNIT: i64 = 4096;

fn square(size: i64) -> impl Iterator<Item = Point> {
    (-size..=size).flat_map(move |x| (-size..=size).map(move |y| (x * UNIT, y * UNIT)))
}

#[test]
fn every_ray_of_a_lattice() {
    let at = |points: &[Point]| points.iter().map(|p| (p.0 * UNIT, p.1 * UNIT)).collect::<Vec<_>>();
    let mut shapes = Vec::new();
    for radius in [0, UNIT] {
        for b in [(0, 0), (1, 0), (0, 1), (1, 1), (2, 1), (-1, 2)] {
            shapes.push(Shape::Capsule { a: (0, 0), b: (b.0 * UNIT, b.1 * UNIT), radius });
        }
        for (half, direction) in
            [((1, 1), (1, 0)), ((2, 1), (0, 1)), ((1, 0), (1, 1)), ((0, 0), (1, 0)), ((1, 1), (3, 4))]
        {
            shapes.push(Shape::Turned { centre: (0, 0), half: (half.0 * UNIT, half.1 * UNIT), direction, radius });
        }
        for points in [&[(0, 0), (2, 0), (0, 2)][..], &[(0, 0), (2, 1), (-1, 2)], &[(-1, 0), (0, -1), (1, 0), (0, 1)]] {
            shapes.push(Shape::polygon(&at(points), radius));
        }
    }
    let mut stopped = 0;
    for shape in &shapes {
        for o in square(3) {
            for d in square(4) {
                stopped += u32::from(check::<i128>(shape, o, d));
            }
        }
    }
    assert!(stopped > 20_000, "{stopped}");
}

fn rays(class: Class) {
    let mut stopped = 0;
    for kind in KINDS.into_iter().skip(3) {
        // A point of the other shape, at the class's position, is where the ray starts, ends or
        // passes.
        let mut stream = Pairs::new((kind, Kind::Circle), class, 0x7a5);
        let mut done = 0;
        while done < tilesat_judge::cases(1500) {
            let (shape, other) = stream.next();
            let Shape::Circle { centre: p, radius } = other else { continue };
            // Its radius is the shape's, so touching pairs are touching points.
            let shape = match shape {
                Shape::Capsule { a, b, .. } => Shape::Capsule { a, b, radius },
                Shape::Turned { centre, half, direction, .. } => Shape::Turned { centre, half, direction, radius },
                Shape::Polygon { points, count, .. } => Shape::Polygon { points, count, radius },
                other => other,
            };
            let r = &mut stream.random;
            let size = [8, 100, 1 << 12, 1 << 22, 1 << 28, LIMIT - 1][r.below(6) as usize];
            let d = match r.below(4) {
                0 => (r.around(size), 0),
                1 => (0, r.around(size)),
                _ => (r.around(size), r.around(size)),
            };
            let (i, n) = ([0, 1, 1, r.below(5)][r.below(4) as usize], [1, 1, 2, 4][r.below(4) as usize]);
            let o = (p.0 - d.0 * i / n, p.1 - d.1 * i / n);
            let within = |p: Point| p.0.abs() < LIMIT && p.1.abs() < LIMIT;
            if !shape.in_domain() || !within(o) || !within((o.0 + d.0, o.1 + d.1)) {
                continue;
            }
            done += 1;
            stopped += u32::from(check::<Int256>(&shape, o, d));
        }
    }
    println!("{class:?}: {stopped} stopped");
    assert!(stopped > 100, "{class:?}: {stopped}");
}

#[test]
fn streams() {
    for class in CLASSES {
        rays(class);
    }
}

/// An upright box is a box, and a capsule without length a circle, bit for bit.
#[test]
fn plain_shapes_by_other_names() {
    let (a, b) = ((-2 * UNIT, -UNIT), (2 * UNIT, UNIT));
    let plain = Shape::Aabb { min: a, max: b };
    let turned = Shape::Turned { centre: (0, 0), half: b, direction: (1, 0), radius: 0 };
    let ball = Shape::Circle { centre: (UNIT, 0), radius: UNIT + 77 };
    let short = Shape::Capsule { a: (UNIT, 0), b: (UNIT, 0), radius: UNIT + 77 };
    for (o, d) in square(4).flat_map(|o| square(4).map(move |d| (o, d))) {
        for inside in [Inside::Ignore, Inside::Hit] {
            assert_eq!(cast_ray(&plain, o, d, inside), cast_ray(&turned, o, d, inside), "{o:?} by {d:?}");
            assert_eq!(cast_ray(&ball, o, d, inside), cast_ray(&short, o, d, inside), "{o:?} by {d:?}");
        }
    }
}
