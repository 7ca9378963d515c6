//! Polygons that cross themselves.
//!
//! At a crossing the inside of a polygon can change sides: the corners of a rectangle in a wrong
//! order are two triangles of opposite directions. A union would take the one for a hole in the
//! other, so each becomes a polygon.

use super::union::halves;
use crate::geometry::{Point, crossing, doubled_area, winding};

/// A polygon with more crossings is no drawing.
const MOST_PARTS: usize = 256;

/// A polygon without a crossing, one with several parts, or one whose inside nobody knows.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum Knot {
    /// As drawn. Its parts, if it has some, have one direction, or lie as holes in each other.
    Plain,
    Parts(Vec<Vec<Point>>),
    /// It crosses itself here.
    Unclear(Point),
}

/// What to make of a polygon.
pub(super) fn of(points: &[Point]) -> Knot {
    let Some(first) = repeated(points).map(|(_, at)| points[at]).or_else(|| Some(crossing(points, |_| true)?.2)) else {
        return Knot::Plain;
    };
    let Some(loops) = Loop::all(points) else { return Knot::Unclear(first) };
    let depth = |inner: &Loop| -> i128 {
        let around = loops.iter().filter(|outer| outer.contains(inner));
        around.map(|outer| outer.area.signum()).sum::<i128>() + inner.area.signum()
    };
    let depths: Vec<i128> = loops.iter().map(depth).collect();
    if !(depths.iter().any(|&depth| depth < 0) && depths.iter().any(|&depth| depth > 0)) {
        return Knot::Plain;
    }
    let opposite = |a: &Loop, b: &Loop| a.area.signum() != b.area.signum() && a.contains(b);
    if loops.iter().any(|a| loops.iter().any(|b| opposite(a, b))) {
        return Knot::Unclear(first);
    }
    Knot::Parts(loops.into_iter().map(|part| part.points).collect())
}

/// The parts of a polygon if they have one direction, as those of a star. Its inside is their
/// union.
pub(super) fn parts(points: &[Point]) -> Option<Vec<Vec<Point>>> {
    let parts = Loop::all(points)?;
    let same = parts.windows(2).all(|pair| pair[0].area.signum() == pair[1].area.signum());
    same.then(|| parts.into_iter().map(|part| part.points).collect())
}

/// Whether a polygon surrounds anything.
pub(super) fn has_inside(points: &[Point]) -> bool {
    Loop::all(points).is_none_or(|loops| !loops.is_empty())
}

/// A part that does not cross itself.
struct Loop {
    points: Vec<Point>,
    area: i128,
    /// A point within, in doubled coordinates.
    within: Point,
}

impl Loop {
    /// Those of a polygon that have an inside.
    fn all(points: &[Point]) -> Option<Vec<Self>> {
        Some(loops(points.to_vec())?.into_iter().filter_map(Self::new).collect())
    }

    /// `None` for one without an inside.
    fn new(points: Vec<Point>) -> Option<Self> {
        let area = doubled_area(&points);
        let within = within(&points).filter(|_| area != 0)?;
        Some(Self { points, area, within })
    }

    fn contains(&self, other: &Self) -> bool {
        self.area.abs() > other.area.abs() && winding(&self.points, other.within) != 0
    }
}

/// Takes a polygon apart at each crossing and at each point that it passes twice.
fn loops(points: Vec<Point>) -> Option<Vec<Vec<Point>>> {
    let (mut rest, mut found) = (vec![points], Vec::new());
    while let Some(mut points) = rest.pop() {
        points.dedup();
        if points.len() > 1 && points.first() == points.last() {
            points.pop();
        }
        if found.len() + rest.len() > MOST_PARTS {
            return None;
        }
        if points.len() < 3 {
            continue;
        }
        if let Some((from, to)) = repeated(&points) {
            rest.push(points.drain(from..to).collect());
            rest.push(points);
        } else if let Some(parts) = halves(&points) {
            rest.extend(parts);
        } else {
            found.push(points);
        }
    }
    Some(found)
}

/// Two indices of one point that are no neighbours.
fn repeated(points: &[Point]) -> Option<(usize, usize)> {
    let mut sorted: Vec<(Point, usize)> = points.iter().copied().zip(0..).collect();
    sorted.sort_unstable();
    let pairs = sorted.windows(2).filter(|pair| pair[0].0 == pair[1].0).map(|pair| (pair[0].1, pair[1].1));
    let mut apart = pairs.filter(|(from, to)| to - from > 1 && (*from, *to + 1) != (0, points.len()));
    apart.next()
}

/// A point within a polygon, in doubled coordinates: in the middle of the widest piece of a line
/// between two of its corners.
fn within(points: &[Point]) -> Option<Point> {
    let mut rows: Vec<i64> = points.iter().map(|p| p.1).collect();
    rows.sort_unstable();
    let (top, bottom) = rows.windows(2).map(|pair| (pair[0], pair[1])).max_by_key(|(top, bottom)| bottom - top)?;
    let row = top + bottom;
    let ends = points.iter().zip(points.iter().cycle().skip(1));
    let crossed = ends.filter(|(a, b)| (2 * a.1 < row) != (2 * b.1 < row));
    let column = |(a, b): (&Point, &Point)| {
        let along = i128::from(b.0 - a.0) * i128::from(row - 2 * a.1);
        2 * a.0 + along.div_euclid(i128::from(b.1 - a.1)) as i64
    };
    let mut columns: Vec<i64> = crossed.map(column).collect();
    columns.sort_unstable();
    let (left, right) = columns.chunks_exact(2).map(|pair| (pair[0], pair[1])).max_by_key(|(l, r)| r - l)?;
    (right - left > 1).then_some((i64::midpoint(left, right), row))
}

#[cfg(test)]
mod tests {
    use super::{Knot, of};
    use crate::geometry::{Point, doubled_area};

    const BOW: [Point; 4] = [(0, 0), (16, 0), (0, 16), (16, 16)];

    fn areas(points: &[Point]) -> Option<Vec<i128>> {
        let Knot::Parts(parts) = of(&points.iter().map(|p| (p.0 << 16, p.1 << 16)).collect::<Vec<_>>()) else {
            return None;
        };
        let mut areas: Vec<i128> = parts.iter().map(|part| doubled_area(part).abs() >> 32).collect();
        areas.sort_unstable();
        Some(areas)
    }

    #[test]
    fn parts_of_opposite_directions() {
        assert_eq!(areas(&BOW), Some(vec![128, 128]));
        // Its crossing is a corner, once and twice.
        assert_eq!(areas(&[(0, 0), (16, 16), (16, 0), (8, 8), (0, 16)]), Some(vec![128, 128]));
        assert_eq!(areas(&[(0, 0), (8, 8), (16, 16), (16, 0), (8, 8), (0, 16)]), Some(vec![128, 128]));
        // Three in a row: the middle one is a square on its corner.
        let chain = [(0, 0), (16, 16), (32, 0), (32, 16), (16, 0), (0, 16)];
        assert_eq!(areas(&chain), Some(vec![128, 128, 256]));
    }

    #[test]
    fn what_stays_as_drawn() {
        let pentagram = [(8, 0), (13, 16), (0, 6), (16, 6), (3, 16)];
        // A ring that is cut open, and one whose ends lie over each other.
        let keyhole = [(0, 0), (16, 0), (16, 16), (0, 16), (0, 0), (4, 4), (4, 12), (12, 12), (12, 4), (4, 4)];
        let touching = [(0, 0), (16, 0), (16, 16), (8, 0), (0, 16)];
        for points in [&BOW[..3], &pentagram, &keyhole, &touching] {
            assert_eq!(
                of(&points.iter().map(|p| (p.0 << 16, p.1 << 16)).collect::<Vec<_>>()),
                Knot::Plain,
                "{points:?}"
            );
        }
    }

    /// A bow with a hole in one of its halves.
    #[test]
    fn a_hole_in_a_part() {
        let bow = [(0, 0), (0, 16), (32, 0), (32, 8), (28, 8), (24, 7), (24, 9), (28, 8), (32, 8), (32, 16)];
        let points: Vec<Point> = bow.iter().map(|p| (p.0 << 16, p.1 << 16)).collect();
        assert!(matches!(of(&points), Knot::Unclear(_)), "{:?}", of(&points));
    }
}
