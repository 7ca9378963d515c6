//! Simple polygons as convex parts: every polygon of up to five corners on a small lattice, and
//! larger random ones. Sums of cross products give areas, and winding counts judge points.

use tilesat::shape::{ConvexParts, PartsError};
use tilesat::{Quantity, RangeError, Vec2};
use tilesat_judge::{Random, cases};

type P = (i64, i64);

/// Corners are even, samples are odd multiples of small parts: no sample is on a side.
const UNIT: i64 = 1 << 10;

fn cross(o: P, p: P, q: P) -> i64 {
    (p.0 - o.0) * (q.1 - o.1) - (p.1 - o.1) * (q.0 - o.0)
}

fn area(points: &[P]) -> i64 {
    (0..points.len()).map(|i| cross((0, 0), points[i], points[(i + 1) % points.len()])).sum()
}

/// How often the corners wind around a point that is on none of their sides, counted by rays to the
/// right.
fn winding(points: &[P], m: P) -> i32 {
    (0..points.len())
        .map(|i| {
            let (p, q) = (points[i], points[(i + 1) % points.len()]);
            match (p.1 < m.1, q.1 < m.1) {
                (true, false) if cross(p, q, m) > 0 => 1,
                (false, true) if cross(p, q, m) < 0 => -1,
                _ => 0,
            }
        })
        .sum()
}

/// Whether two segments have a common point. Clips the second one with the line and the ends of the
/// first, in fractions of its length.
fn meet(a: P, b: P, c: P, d: P) -> bool {
    let along = |p: P| (p.0 - a.0) * (b.0 - a.0) + (p.1 - a.1) * (b.1 - a.1);
    let (s, t) = (cross(a, b, c), cross(a, b, d));
    let length = along(b);
    if s == 0 && t == 0 {
        return along(c).max(along(d)) >= 0 && along(c).min(along(d)) <= length;
    }
    if (s > 0 && t > 0) || (s < 0 && t < 0) {
        return false;
    }
    // Where it crosses the line: c + (d - c) s / (s - t).
    let (num, den) = (along(c) * (s - t) + (along(d) - along(c)) * s, s - t);
    let (num, den) = if den < 0 { (-num, -den) } else { (num, den) };
    num >= 0 && num <= length * den
}

fn is_simple(points: &[P]) -> bool {
    let n = points.len();
    let at = |i: usize| points[i % n];
    (0..n).all(|i| {
        at(i) != at(i + 1)
            && (i + 1..n).all(|j| {
                let (a, b, c, d) = (at(i), at(i + 1), at(j), at(j + 1));
                if j == i + 1 || (i == 0 && j == n - 1) {
                    // One common end: the other ends are on no common ray from it.
                    let (o, p, q) = if j == i + 1 { (b, a, d) } else { (a, b, c) };
                    let ahead = (p.0 - o.0) * (q.0 - o.0) + (p.1 - o.1) * (q.1 - o.1);
                    cross(o, p, q) != 0 || ahead < 0
                } else {
                    !meet(a, b, c, d)
                }
            })
    })
}

/// Whether it was cut.
fn check<const N: usize, const M: usize>(points: &[P], samples: &[P]) -> bool {
    let corners: Vec<Vec2> = points.iter().map(|p| Vec2::from_raw(p.0 as i32, p.1 as i32)).collect();
    let cut = ConvexParts::<N, M>::of(&corners);
    let simple = is_simple(points);
    let cut = match cut {
        Ok(cut) => cut,
        Err(error) => {
            assert!(matches!(error, PartsError::Crosses { .. }) && !simple, "{error}: {points:?}");
            return false;
        }
    };
    assert!(simple, "{points:?}");
    let parts: Vec<Vec<P>> = (cut.parts().iter())
        .map(|part| part.vertices().iter().map(|p| p.raw()).map(|(x, y)| (i64::from(x), i64::from(y))).collect())
        .collect();
    for part in &parts {
        let n = part.len();
        assert!((0..n).all(|i| cross(part[i], part[(i + 1) % n], part[(i + 2) % n]) > 0), "{part:?} of {points:?}");
        assert!(part.iter().all(|p| points.contains(p)), "{part:?} of {points:?}");
    }
    assert_eq!(parts.iter().map(|part| area(part)).sum::<i64>(), area(points).abs(), "{parts:?} of {points:?}");
    for &m in samples {
        let inside = parts.iter().filter(|part| winding(part, m) != 0).count();
        assert_eq!(inside, usize::from(winding(points, m) != 0), "{m:?}: {parts:?} of {points:?}");
    }
    true
}

fn samples(width: i64, height: i64) -> Vec<P> {
    let near = |n: i64, k: i64, by: i64| (0..4 * n).map(move |i| i * UNIT / 4 + by + k * (i % 3)).collect::<Vec<_>>();
    let (xs, ys) = (near(width, 2, 37), near(height, 6, 91));
    xs.iter().flat_map(|x| ys.iter().map(|y| (*x, *y))).collect()
}

/// All lists of corners on a lattice whose first corner is the least. Any list is one of these from
/// another corner.
fn all(n: usize, width: i64, height: i64) -> (u64, u64) {
    let lattice: Vec<P> = (0..width * height).map(|i| (i % width * UNIT, i / width * UNIT)).collect();
    let samples = samples(width - 1, height - 1);
    let (mut cut, mut not) = (0, 0);
    let mut at = vec![0usize; n];
    loop {
        if at.iter().all(|i| *i >= at[0]) {
            let points: Vec<P> = at.iter().map(|i| lattice[*i]).collect();
            if check::<8, 8>(&points, &samples) { cut += 1 } else { not += 1 }
        }
        let Some(k) = at.iter().rposition(|i| i + 1 < lattice.len()) else { return (cut, not) };
        at[k] += 1;
        at[k + 1..].fill(0);
    }
}

#[test]
fn every_small_polygon() {
    for (n, width, height) in [(3, 4, 4), (4, 4, 4), (5, 4, 3), (6, 3, 3)] {
        let (cut, not) = all(n, width, height);
        println!("{n} corners of {width} x {height}: {cut} cut, {not} cross themselves");
        assert!(cut > 100 && not > 100, "{cut} {not}");
    }
}

/// Simple by untangling: two sides that cross are exchanged until none do.
fn untangled(random: &mut Random, n: usize, size: i64) -> Option<Vec<P>> {
    let mut points: Vec<P> = (0..n).map(|_| (random.below(size) * UNIT, random.below(size) * UNIT)).collect();
    for _ in 0..200 {
        if is_simple(&points) {
            return Some(points);
        }
        let pair = (0..n)
            .flat_map(|i| (i + 2..n).map(move |j| (i, j)))
            .find(|&(i, j)| (i, j) != (0, n - 1) && meet(points[i], points[i + 1], points[j], points[(j + 1) % n]));
        let (i, j) = pair?;
        points[i + 1..=j].reverse();
    }
    None
}

#[test]
fn many_corners() {
    let mut random = Random::new(0xca7);
    let samples = samples(8, 8);
    let mut cut = 0;
    for _ in 0..cases(4_000) {
        let n = random.within(6, 20) as usize;
        if let Some(points) = untangled(&mut random, n, 9) {
            cut += u64::from(check::<5, 20>(&points, &samples));
            check::<3, 20>(&points, &samples);
        }
    }
    assert!(cut > 1_000, "{cut}");
}

#[test]
fn errors() {
    let corners = |n: usize| (0..n).map(|i| Vec2::from_raw(i as i32 % 64, i as i32)).collect::<Vec<_>>();
    assert_eq!(ConvexParts::<4, 4>::of(&corners(2)), Err(PartsError::TooFew { count: 2 }));
    assert_eq!(ConvexParts::<4, 4>::of(&corners(129)), Err(PartsError::TooMany { count: 129 }));
    let far = [(0, 0), (9000, 0), (0, 9)].map(|(x, y)| Vec2::from_ints(x, y));
    let error = ConvexParts::<4, 4>::of(&far).unwrap_err();
    assert!(matches!(error, PartsError::Range { at: 1, error: RangeError { what: Quantity::X, .. } }));
    let l = [(0, 0), (3, 0), (3, 1), (1, 1), (1, 3), (0, 3)].map(|(x, y)| Vec2::from_ints(x, y));
    assert_eq!(ConvexParts::<4, 1>::of(&l), Err(PartsError::NoRoom { capacity: 1 }));
    assert_eq!(ConvexParts::<2, 9>::of(&l), Err(PartsError::NoRoom { capacity: 9 }));
    assert_eq!(ConvexParts::<4, 2>::of(&l).unwrap().parts().len(), 2);
    let bow = [(0, 0), (2, 2), (2, 0), (0, 2)].map(|(x, y)| Vec2::from_ints(x, y));
    assert_eq!(ConvexParts::<4, 4>::of(&bow), Err(PartsError::Crosses { at: 0, other: 2 }));
}

/// Corners without a turn, given or left by a cut, cost no part.
#[test]
fn straight_corners_are_left_out() {
    let turned = |list: &[(i16, i16)], by: usize| {
        let mut list: Vec<Vec2> = list.iter().map(|(x, y)| Vec2::from_ints(*x, *y)).collect();
        list.rotate_left(by);
        list
    };
    let square = [(0, 0), (1, 0), (2, 0), (2, 1), (2, 2), (1, 2), (0, 2), (0, 1)];
    let t = [(1, 0), (2, 0), (2, 2), (3, 2), (3, 3), (0, 3), (0, 2), (1, 2)];
    for by in 0..8 {
        assert_eq!(ConvexParts::<4, 1>::of(&turned(&square, by)).map(|cut| cut.parts().len()), Ok(1));
        assert_eq!(ConvexParts::<4, 3>::of(&turned(&t, by)).map(|cut| cut.parts().len()), Ok(2));
    }
}
