//! Circles among solid cells: visits every cell that the box of the circle, or of its whole way,
//! covers.

use crate::dda::{CELL, Grid};
use crate::shape::{Aabb, Circle, Vector};
use crate::{Scalar, cast, pair};

/// The solid cells that a box covers, each as a box.
fn solid<S: Scalar>(grid: &Grid<'_>, lo: Vector<S>, hi: Vector<S>) -> impl Iterator<Item = Aabb<S>> {
    let cell = |v: S| v.floor().div_euclid(CELL);
    let (columns, rows) = (cell(lo.x)..=cell(hi.x), cell(lo.y)..=cell(hi.y));
    let places = rows.flat_map(move |y| columns.clone().map(move |x| (x, y)));
    places.filter(|&(x, y)| grid.solid(x, y) == Some(true)).map(|(x, y)| {
        let corner = |x: i32, y: i32| Vector { x: S::of_int(x * CELL), y: S::of_int(y * CELL) };
        Aabb { lo: corner(x, y), hi: corner(x + 1, y + 1) }
    })
}

pub fn overlaps<S: Scalar>(grid: &Grid<'_>, a: &Circle<S>) -> bool {
    let r = Vector { x: a.r, y: a.r };
    solid(grid, a.c - r, a.c + r).any(|cell| pair::circle_aabb(a, &cell))
}

/// The first time of all cells.
pub fn first<S: Scalar>(grid: &Grid<'_>, a: &Circle<S>, d: Vector<S>) -> Option<S> {
    let (r, end) = (Vector { x: a.r, y: a.r }, a.c + d);
    let lo = Vector { x: a.c.x.least(end.x), y: a.c.y.least(end.y) } - r;
    let hi = Vector { x: a.c.x.most(end.x), y: a.c.y.most(end.y) } + r;
    let mut first = None;
    for cell in solid(grid, lo, hi) {
        let Some(t) = cast::circle_aabb(a, &cell, d) else { continue };
        if first.is_none_or(|f| t < f) {
            first = Some(t);
        }
    }
    first
}
