//! Rays through a grid.

use crate::Place;
use tilesat::{Fx, Grid, TileKind, TileKinds, TileMap, Vec2};
use tilesat_textbook::dda;

/// A start and a motion, in a grid.
pub struct Ray<'a, M, V> {
    pub map: &'a M,
    pub o: V,
    pub d: V,
}

impl<'a, M, V: Place> Ray<'a, M, V> {
    pub fn of(map: &'a M, words: &[i32]) -> Self {
        Self { map, o: V::of(words[0], words[1]), d: V::of(words[2], words[3]) }
    }
}

/// A grid of 256 x 256 cells of 16 pixels.
pub trait Map {
    fn of(cells: &'static [u8]) -> Self;
}

pub(crate) static KINDS: TileKinds = TileKinds::EMPTY.with(1, TileKind::FULL);

impl Map for TileMap<'static> {
    fn of(cells: &'static [u8]) -> Self {
        let grid = Grid::new(256, 256, Fx::from_bits(1 << 20), Vec2::ZERO).expect("a legal grid");
        TileMap::on_grid(cells, grid, &KINDS).expect("a legal map")
    }
}

impl Map for dda::Grid<'static> {
    fn of(cells: &'static [u8]) -> Self {
        Self { cells, width: 256, height: 256 }
    }
}

/// Calls a macro for each ray: the row's keys, its grid, start and answer, the call, and whether
/// the answer is a hit.
#[macro_export]
macro_rules! each_ray {
    ($each:ident) => {
        each_ray! { map $each "rays: room 5 %" }
        each_ray! { map $each "rays: platformer 20 %" }
        each_ray! { map $each "rays: cave 50 %" }
    };
    (map $each:ident $workload:literal) => {
        $each! { $workload, "tilesat", tilesat::TileMap<'static>, tilesat::Vec2, Result<Option<tilesat::RayHit>, tilesat::RangeError>,
            |r| r.map.cast_ray(r.o, r.d, tilesat::Inside::Ignore), |o| matches!(o, Ok(Some(_))) }
        $each! { $workload, "plain integer DDA", dda::Grid<'static>, (i32, i32), Option<dda::ExactHit>,
            |r| dda::cast_exact(r.map, r.o, r.d), |o| o.is_some() }
        each_ray! { book $each $workload, "naive Q16.16", Q16 }
        each_ray! { book $each $workload, "wide Q16.16", Wide }
        each_ray! { book $each $workload, "textbook f32", f32 }
        each_ray! { book $each $workload, "textbook f64", f64 }
    };
    (book $each:ident $workload:literal, $backend:literal, $s:ty) => {
        $each! { $workload, $backend, dda::Grid<'static>, book::Vector<$s>, Option<dda::Hit<$s>>, |r| dda::cast(r.map, r.o, r.d), |o| o.is_some() }
    };
}
