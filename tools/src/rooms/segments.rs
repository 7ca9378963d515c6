//! The polygons that a room needs: those that reach it or its apron. Their edges there are as
//! drawn.

use super::Baked;
use super::part::Part;
use crate::bake::segments::Shapes;
use crate::fail::Result;
use crate::geometry::doubled_area;
use crate::rules::flags::Flags;
use crate::rules::kind::Kind;
use crate::rules::outline::Outline;

type Point = (i64, i64);

/// The bytes of a room's segment map, in coordinates of the room. `None` if nothing reaches it.
pub(super) fn of(parts: &[Part], room: &Baked, cell: u16, apron: u16, flags: &mut Flags) -> Result<Option<Vec<u8>>> {
    let side = i64::from(cell) << 16;
    let first = (i64::from(room.first.0) * side, i64::from(room.first.1) * side);
    let margin = i64::from(apron) * side;
    let end = (i64::from(room.size.0) * side + margin, i64::from(room.size.1) * side + margin);
    let window = [(-1, 0, -margin), (1, 0, end.0), (0, -1, -margin), (0, 1, end.1)];
    let outlines = parts.iter().filter(|part| part.plane == room.plane).flat_map(|part| &part.outlines);
    let mut cuts = [0; 4];
    let near: Vec<Outline> =
        outlines.filter_map(|outline| near(moved(outline, first), window.map(Beyond::from), &mut cuts)).collect();
    if near.is_empty() {
        return Ok(None);
    }
    let shapes = Shapes::of(&near, flags)?;
    shapes.build_or(&near, shapes.cell(cell), "use smaller rooms").map(Some)
}

fn moved(outline: &Outline, by: Point) -> Outline {
    let points = outline.points.iter().map(|p| (p.0 - by.0, p.1 - by.1)).collect();
    Outline { points, ..outline.clone() }
}

/// This many polygons are cut along one line. The next ones are cut a raw unit further out.
///
/// Cut edges of one line share parts. For each part the library reads all polygons with an edge on
/// that line. 400 strips around each other take 13 s on one line, and 0.4 s in lines of 16.
const CUT_TOGETHER: i64 = 16;

/// The points strictly beyond a side of a window.
#[derive(Clone, Copy)]
struct Beyond {
    /// Along x or y, outward.
    out: Point,
    /// The position of the side.
    at: i64,
}

impl From<(i64, i64, i64)> for Beyond {
    fn from((x, y, at): (i64, i64, i64)) -> Self {
        Self { out: (x, y), at: if x + y < 0 { -at } else { at } }
    }
}

impl Beyond {
    fn along(&self, p: Point) -> i64 {
        p.0 * self.out.0 + p.1 * self.out.1
    }

    /// A side further out, by so many raw units.
    fn further(self, by: i64) -> Self {
        Self { at: self.at + by, ..self }
    }

    fn holds(&self, p: Point) -> bool {
        self.along(p) > self.at
    }
}

/// An outline without its parts far from a window. `None` if no part is near.
///
/// Cuts edges beyond the window, at a raw point exactly on them if there is one. Of consecutive
/// points beyond a side, the first and the last stay, with a straight way between them. So
/// everything that reaches the window is as drawn, and winds around its points as often. All
/// changes are beyond a side. Counts the outlines that were cut at each side.
fn near(outline: Outline, window: [Beyond; 4], cuts: &mut [i64; 4]) -> Option<Outline> {
    if window.iter().any(|side| outline.points.iter().all(|&p| side.holds(p))) {
        return None;
    }
    let mut short = outline.clone();
    for (side, cuts) in window.into_iter().zip(cuts) {
        let side = side.further(*cuts / CUT_TOGETHER);
        let points = cut(&short.points, outline.closed, side);
        *cuts += i64::from(points.len() > short.points.len());
        short.points = without_runs(&points, outline.closed, side);
    }
    short.rounding = vec![0; short.points.len()];
    let area = |outline: &Outline| doubled_area(&outline.points) != 0;
    match outline.kind {
        Kind::Wall | Kind::OneWay => Some(short).filter(|short| short.points.len() > 1),
        // Only a way there and back.
        Kind::Solid | Kind::Hole if short.points.len() < 3 => None,
        // The library requires an area. The halves of a figure of eight can cancel.
        Kind::Solid | Kind::Hole => Some(if area(&short) { short } else { outline }),
    }
}

/// Adds a point to each edge that leaves through a side, as near behind it as possible.
fn cut(points: &[Point], closed: bool, side: Beyond) -> Vec<Point> {
    let mut all = Vec::with_capacity(points.len());
    for (i, &a) in points.iter().enumerate() {
        all.push(a);
        let next = if closed { points.get((i + 1) % points.len()) } else { points.get(i + 1) };
        let Some(&b) = next.filter(|&&b| side.holds(a) != side.holds(b)) else { continue };
        let (inner, outer) = if side.holds(b) { (a, b) } else { (b, a) };
        let way = (outer.0 - inner.0, outer.1 - inner.1);
        let count = gcd(way.0.unsigned_abs(), way.1.unsigned_abs()) as i64;
        let step = (way.0 / count, way.1 / count);
        // Outward, because one end is beyond the side and the other is not.
        let steps = (side.at - side.along(inner)).div_euclid(side.along(step)) + 1;
        if steps < count {
            all.push((inner.0 + step.0 * steps, inner.1 + step.1 * steps));
        }
    }
    all
}

fn gcd(a: u64, b: u64) -> u64 {
    if b == 0 { a } else { gcd(b, a % b) }
}

fn without_runs(points: &[Point], closed: bool, side: Beyond) -> Vec<Point> {
    let beyond = |i: usize| points.get(i).is_none_or(|&p| side.holds(p));
    let count = points.len();
    if count == 0 {
        // All of it was beyond another side.
        return Vec::new();
    }
    // Before the first point of a chain and after the last one, nothing is near.
    let (before, after) = if closed { (count - 1, 0) } else { (count, count) };
    let goes = |i: usize| {
        let last = if i == 0 { before } else { i - 1 };
        let next = if i + 1 == count { after } else { i + 1 };
        beyond(last) && beyond(i) && beyond(next)
    };
    let mut kept: Vec<Point> = (0..count).filter(|&i| !goes(i)).map(|i| points[i]).collect();
    kept.dedup();
    // A polygon closes itself.
    if closed && kept.len() > 1 && kept.first() == kept.last() {
        kept.pop();
    }
    kept
}
