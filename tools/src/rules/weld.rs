//! Welds the corners of tiles' polygons. People draw them by hand, and a gap of a hundredth of a
//! pixel between two tiles is a step for a body.
//!
//! A corner near its tile's border moves onto the border. Then a corner near one of another
//! polygon, or of a shape of the library in a cell, moves onto that. Either move is at most the
//! tolerance along x and along y. A polygon stays as drawn if it would lose its area or cross
//! itself, or if it is convex and would not stay so.

use std::collections::{BTreeMap, BTreeSet, HashMap, HashSet};

use crate::geometry::{Edge, Meeting, Point, Side, doubled_area, meet, orient};
use crate::model::decimal::Decimal;
use crate::model::object::{Spot, raw};

/// The check of a changed polygon compares all pairs of its edges.
const MOST_CORNERS: usize = 64;

/// Moves corners onto the border of a box, at most `most` raw units along x and y. Returns how many
/// moved.
pub(super) fn onto_border(points: &mut Vec<Spot>, closed: bool, (lo, hi): (Spot, Spot), most: i64) -> u32 {
    if most == 0 {
        return 0;
    }
    let off = |v: Decimal, to: Decimal| (v - to).raw().abs();
    let snap = |v: Decimal, lo: Decimal, hi: Decimal| [lo, hi].into_iter().find(|to| off(v, *to) <= most).unwrap_or(v);
    let near = |v: Decimal, lo: Decimal, hi: Decimal| v >= lo && v <= hi || off(v, lo) <= most || off(v, hi) <= most;
    let place = |&(x, y): &Spot| {
        let beside = near(x, lo.0, hi.0) && near(y, lo.1, hi.1);
        if beside { (snap(x, lo.0, hi.0), snap(y, lo.1, hi.1)) } else { (x, y) }
    };
    let new = points.iter().map(place).collect();
    exchange(points, new, closed)
}

/// Takes the new corners, without those that have come to lie on the one before. Returns how many
/// moved: none, if the new ones are no sound form.
fn exchange(points: &mut Vec<Spot>, mut new: Vec<Spot>, closed: bool) -> u32 {
    if *points == new {
        return 0;
    }
    // Without those that stay at their raw point.
    let moved = raw(points).iter().zip(raw(&new)).filter(|(old, new)| **old != *new).count();
    new.dedup();
    if closed && new.len() > 1 && new.first() == new.last() {
        new.pop();
    }
    if !is_sound(&raw(points), &raw(&new), closed) {
        return 0;
    }
    *points = new;
    moved as u32
}

/// Whether changed corners can replace the drawn ones.
fn is_sound(old: &[Point], new: &[Point], closed: bool) -> bool {
    if new.len() > MOST_CORNERS || new.len() < if closed { 3 } else { 2 } {
        return false;
    }
    let ends = new.iter().copied().skip(1).chain(new.first().copied().filter(|_| closed));
    let edge = |((&a, b), number)| Edge { a, b, outline: None, number, side: Side::Wall };
    let edges: Vec<Edge> = new.iter().zip(ends).zip(0..).map(edge).collect();
    if edges.iter().any(|edge| edge.a == edge.b) {
        return false;
    }
    let follows = |i: usize, j: usize| j == i + 1 || closed && i == 0 && j + 1 == edges.len();
    let apart = |i: usize, j: usize| match meet(&edges[i], &edges[j]) {
        Meeting::Apart => true,
        Meeting::SharedEnd(_) => follows(i, j),
        Meeting::Cross(_) | Meeting::Tee(_) | Meeting::Overlap { .. } => false,
    };
    if !(0..edges.len()).all(|j| (0..j).all(|i| apart(i, j))) {
        return false;
    }
    if !closed {
        return true;
    }
    let same_side = doubled_area(old).signum() == doubled_area(new).signum() && doubled_area(new) != 0;
    same_side && (!is_convex(old) || is_convex(new))
}

fn is_convex(points: &[Point]) -> bool {
    let count = points.len();
    let turn = |i: usize| orient(points[i], points[(i + 1) % count], points[(i + 2) % count]);
    let (mut left, mut right) = (false, false);
    for i in 0..count {
        (left, right) = (left || turn(i) < 0, right || turn(i) > 0);
    }
    !(left && right)
}

/// A polygon or chain at its position.
pub(super) struct Form<'a> {
    pub(super) points: &'a mut Vec<Spot>,
    pub(super) closed: bool,
    /// Whether somebody drew its corners. Those of a round form stay.
    pub(super) drawn: bool,
}

impl Form<'_> {
    /// Forms with many corners stay, so that the work is bounded.
    fn can_move(&self) -> bool {
        self.drawn && self.points.len() <= MOST_CORNERS
    }
}

/// Moves corners onto those of other forms, or onto the `fixed` ones near them, by at most `most`
/// raw units. Returns how many moved. The order of the forms has no effect.
pub(super) fn onto_neighbours(forms: &mut [Form<'_>], fixed: impl Fn(Point) -> Vec<Point>, most: i64) -> u32 {
    if most == 0 {
        return 0;
    }
    // Each point and the forms that have it, in the order of the points.
    let mut all: BTreeMap<Point, (Spot, Vec<usize>)> = BTreeMap::new();
    for (number, form) in forms.iter().enumerate().filter(|(_, form)| form.can_move()) {
        for &spot in form.points.iter() {
            all.entry((spot.0.raw(), spot.1.raw())).or_insert_with(|| (spot, Vec::new())).1.push(number);
        }
    }
    let mut kept = Kept { most, buckets: HashMap::new() };
    for point in all.keys().flat_map(|&point| fixed(point)).collect::<BTreeSet<Point>>() {
        kept.add(point, exact(point), None);
    }
    let mut moves: HashMap<Point, Spot> = HashMap::new();
    for (point, (spot, owners)) in all {
        match kept.join(point, &owners) {
            Some(onto) => drop(moves.insert(point, onto)),
            None => kept.add(point, spot, Some(owners.into_iter().collect())),
        }
    }
    let place = |spot: &Spot| moves.get(&(spot.0.raw(), spot.1.raw())).copied().unwrap_or(*spot);
    let weld = |form: &mut Form<'_>| exchange(form.points, form.points.iter().map(place).collect(), form.closed);
    forms.iter_mut().filter(|form| form.can_move()).map(weld).sum()
}

pub(super) fn exact((x, y): Point) -> Spot {
    let pixels = |raw: i64| Decimal::whole(raw >> 16) + Decimal::whole(raw & 0xffff).scaled(1, 1 << 16);
    (pixels(x), pixels(y))
}

/// The points that stay, by squares of the tolerance.
struct Kept {
    most: i64,
    buckets: HashMap<Point, Vec<Corner>>,
}

struct Corner {
    at: Point,
    spot: Spot,
    /// The forms whose corners are here. `None` for a fixed one, which any number can join.
    owners: Option<HashSet<usize>>,
}

impl Kept {
    fn square(&self, at: Point) -> Point {
        (at.0.div_euclid(self.most), at.1.div_euclid(self.most))
    }

    fn add(&mut self, at: Point, spot: Spot, owners: Option<HashSet<usize>>) {
        self.buckets.entry(self.square(at)).or_default().push(Corner { at, spot, owners });
    }

    /// The nearest point that these owners do not have yet, so that no form loses a corner.
    fn join(&mut self, at: Point, owners: &[usize]) -> Option<Spot> {
        let (x, y) = self.square(at);
        let off = |corner: &Corner| ((corner.at.0 - at.0).abs(), (corner.at.1 - at.1).abs());
        let mut best: Option<((i64, Point), Point, usize)> = None;
        for square in (-1..=1).flat_map(|i| (-1..=1).map(move |j| (x + i, y + j))) {
            for (i, corner) in self.buckets.get(&square).into_iter().flatten().enumerate() {
                let (dx, dy) = off(corner);
                let free = corner.owners.as_ref().is_none_or(|known| !owners.iter().any(|owner| known.contains(owner)));
                let key = (dx * dx + dy * dy, corner.at);
                if dx.max(dy) <= self.most && free && best.is_none_or(|(nearest, ..)| key < nearest) {
                    best = Some((key, square, i));
                }
            }
        }
        let (_, square, i) = best?;
        let corner = &mut self.buckets.get_mut(&square)?[i];
        if let Some(known) = &mut corner.owners {
            known.extend(owners);
        }
        Some(corner.spot)
    }
}
