//! The hits of a ray, from the rules: all pieces of the surface, each tested separately, in numbers
//! of any size.

use super::level::{Cell, Level, is_inside};
use super::moment::Moment;
use super::solid::{Point, Solid, exact, small};
use crate::gcd;
use num_bigint::BigInt;
use std::cmp::Ordering;

/// A piece of the surface.
#[derive(Clone, Debug)]
pub struct Piece {
    pub line: Line,
    pub owner: (i64, i64),
    pub index: u16,
    pub id: u8,
}

#[derive(Clone, Debug)]
pub enum Line {
    /// Solid to the right of the way from a to b, in a picture with y down.
    Straight { a: Point, b: Point },
    /// A quarter: both components of a point relative to the centre have the signs of `quadrant`,
    /// or are zero.
    Round { centre: Point, radius: i64, quadrant: Point, convex: bool },
}

#[derive(Clone, Debug)]
pub struct Hit {
    pub moment: Moment,
    /// Reduced; `None` within an arc.
    pub normal: Option<Point>,
    pub piece: Piece,
}

/// A level, ready for many rays.
#[derive(Debug)]
pub struct Scene {
    pub cells: Vec<Cell>,
    pub pieces: Vec<Piece>,
}

fn big(v: i128) -> BigInt {
    BigInt::from(v)
}

/// Halves of a cell's side, if the side is one: from corner to corner, split in the middle where it
/// is finite.
fn halves(a: Point, b: Point, cell: i64) -> Vec<(Point, Point)> {
    if (b.0 - a.0).abs() + (b.1 - a.1).abs() == cell {
        let m = (i64::midpoint(a.0, b.0), i64::midpoint(a.1, b.1));
        vec![(a, m), (m, b)]
    } else {
        vec![(a, b)]
    }
}

impl Scene {
    pub fn new(level: &Level) -> Self {
        let cells = level.cells();
        // The side of its cell on which an edge lies: that toward row 0, then turning right.
        // Otherwise it is within.
        let side = |c: &Cell, a: Point, b: Point| {
            if a.1 == b.1 && a.1 == c.lo.1 {
                0
            } else if a.0 == b.0 && a.0 == c.hi.0 {
                1
            } else if a.1 == b.1 && a.1 == c.hi.1 {
                2
            } else if a.0 == b.0 && a.0 == c.lo.0 {
                3
            } else {
                8
            }
        };
        let mut edges: Vec<Piece> = Vec::new();
        let mut arcs = Vec::new();
        for c in &cells {
            let owner = (c.column, c.row);
            for (a, b) in c.solid.sides() {
                let index = side(c, a, b);
                let parts = if index == 8 { vec![(a, b)] } else { halves(a, b, level.cell) };
                edges.extend(parts.into_iter().map(|(a, b)| Piece {
                    line: Line::Straight { a, b },
                    owner,
                    index,
                    id: c.id,
                }));
            }
            if let Solid::Round { lo, hi, centre, convex } = c.solid {
                let quadrant = ((lo.0 + hi.0 - 2 * centre.0).signum(), (lo.1 + hi.1 - 2 * centre.1).signum());
                let line = Line::Round { centre, radius: level.cell, quadrant, convex };
                arcs.push(Piece { line, owner, index: 8, id: c.id });
            }
        }
        let ends = |p: &Piece| match p.line {
            Line::Straight { a, b } => (a, b),
            Line::Round { .. } => unreachable!(),
        };
        let covered = |a: Point, b: Point| edges.iter().any(|p| ends(p) == (b, a));
        let mut pieces: Vec<Piece> = edges.iter().filter(|p| !covered(ends(p).0, ends(p).1)).cloned().collect();
        for c in &cells {
            let (lo, hi) = (c.lo, c.hi);
            let Some(k) = c.id.checked_sub(34) else { continue };
            let corners = [lo, (hi.0, lo.1), hi, (lo.0, hi.1)];
            let (a, b) = (corners[usize::from(k)], corners[usize::from((k + 1) % 4)]);
            for (a, b) in halves(a, b, level.cell) {
                if !covered(a, b) {
                    let line = Line::Straight { a, b };
                    pieces.push(Piece { line, owner: (c.column, c.row), index: u16::from(k), id: c.id });
                }
            }
        }
        pieces.extend(arcs);
        Self { cells, pieces }
    }

    pub fn inside(&self, o: Point) -> bool {
        is_inside(&self.cells, o, &exact(o))
    }

    /// Whether the points just after the start are inside.
    pub fn enters(&self, o: Point, d: Point) -> bool {
        let (early, start) = (small(120, false), exact(o));
        let p = (start.0 + &early * d.0, start.1 + &early * d.1);
        d != (0, 0) && is_inside(&self.cells, o, &p)
    }

    /// All hits, the first one first: one for each moment, the one that the rules prefer, and then
    /// its equals.
    pub fn cast(&self, o: Point, d: Point, one_way: bool) -> Vec<Vec<Hit>> {
        let mut enters = None;
        let mut hits: Vec<Hit> = Vec::new();
        for piece in &self.pieces {
            if piece.id >= 34 && !one_way {
                continue;
            }
            let Some((moment, normal)) = meet(&piece.line, o, d) else { continue };
            if piece.id < 34 && moment.is_zero() && !*enters.get_or_insert_with(|| self.enters(o, d)) {
                continue;
            }
            hits.push(Hit { moment, normal, piece: piece.clone() });
        }
        hits.sort_by(|a, b| a.moment.cmp(&b.moment).then_with(|| rank(a.normal, b.normal, d)));
        let mut groups: Vec<Vec<Hit>> = Vec::new();
        for hit in hits {
            match groups.last_mut() {
                Some(group) if group[0].moment == hit.moment || group[0].moment.cmp(&hit.moment) == Ordering::Equal => {
                    if rank(group[0].normal, hit.normal, d) == Ordering::Equal {
                        group.push(hit);
                    }
                }
                _ => groups.push(vec![hit]),
            }
        }
        groups
    }
}

/// At one moment, less is preferred. More along x, then more against the motion, then +x, then +y.
fn rank(a: Option<Point>, b: Option<Point>, d: Point) -> Ordering {
    let (Some(a), Some(b)) = (a, b) else { return Ordering::Equal };
    let square = |n: Point| i128::from(n.0).pow(2) + i128::from(n.1).pow(2);
    let share = |n: Point, other: Point| i128::from(n.0).pow(2) * square(other);
    let into = |n: Point| -(i128::from(n.0) * i128::from(d.0) + i128::from(n.1) * i128::from(d.1));
    share(b, a).cmp(&share(a, b)).then_with(|| into(b).cmp(&into(a))).then_with(|| b.cmp(&a))
}

/// When a ray meets a piece, and the normal there.
pub fn meet(line: &Line, o: Point, d: Point) -> Option<(Moment, Option<Point>)> {
    match *line {
        Line::Straight { a, b } => {
            let k = gcd(b.0 - a.0, b.1 - a.1);
            let e = (i128::from((b.0 - a.0) / k), i128::from((b.1 - a.1) / k));
            let (w, d) = ((i128::from(o.0 - a.0), i128::from(o.1 - a.1)), (i128::from(d.0), i128::from(d.1)));
            // The normal is to the left of the way in a picture with y down.
            let n = (e.1, -e.0);
            let (against, front) = (-(n.0 * d.0 + n.1 * d.1), n.0 * w.0 + n.1 * w.1);
            if against <= 0 || front < 0 || front > against {
                return None;
            }
            // The place along the edge, by the projection, times `against`.
            let place = (w.0 * e.0 + w.1 * e.1) * against + (d.0 * e.0 + d.1 * e.1) * front;
            if place < 0 || place > i128::from(k) * (e.0 * e.0 + e.1 * e.1) * against {
                return None;
            }
            Some((Moment::fraction(front, against), Some((n.0 as i64, n.1 as i64))))
        }
        Line::Round { centre, radius, quadrant, convex } => {
            let m = (o.0 - centre.0, o.1 - centre.1);
            let (mx, my, dx, dy) = (i128::from(m.0), i128::from(m.1), i128::from(d.0), i128::from(d.1));
            // a t^2 - 2 b t + c = 0.
            let (a, b, c) = (dx * dx + dy * dy, -(mx * dx + my * dy), mx * mx + my * my - i128::from(radius).pow(2));
            if a == 0 {
                return None;
            }
            let root = big(b) * big(b) - big(a) * big(c);
            let zero = big(0);
            let end = |p: Point| (p.0 == 0 || p.1 == 0).then_some(p);
            if root < zero || (root == zero && convex) {
                return None;
            }
            let moment = Moment::quadratic(b, if convex { -1 } else { 1 }, root.clone(), a);
            let (start, whole) = (Moment::fraction(0, 1), Moment::fraction(1, 1));
            if moment < start || moment > whole {
                return None;
            }
            let at = (moment.sign_at(m.0, d.0) as i64 * quadrant.0, moment.sign_at(m.1, d.1) as i64 * quadrant.1);
            if at.0 < 0 || at.1 < 0 {
                return None;
            }
            if root == zero && !moment.is_zero() {
                // A tangent runs along the line on which the arc ends, and continues toward the
                // side of its cell.
                let into =
                    (d.0 == 0 && at.1 == 0 && d.1 * quadrant.1 > 0) || (d.1 == 0 && at.0 == 0 && d.0 * quadrant.0 > 0);
                if !into {
                    return None;
                }
            }
            let outward = if convex { 1 } else { -1 };
            let normal = match end(at) {
                Some(p) => Some((outward * p.0.signum() * quadrant.0, outward * p.1.signum() * quadrant.1)),
                None if moment.is_zero() => Some((outward * m.0, outward * m.1)),
                None => None,
            };
            Some((moment, normal))
        }
    }
}
