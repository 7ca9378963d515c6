//! Bodies that move through tiles and slide, one frame after the other.

use crate::book::{Aabb, Circle, Vector};
use crate::rays::KINDS as BLOCKS;
use crate::{Place, Scalar};
use tilesat::world::ShapeSet;
use tilesat::{AllShapes, Axis, Blocks, Fx, Grid, Mover, Outside, TileKind, TileKinds, TileMap, TileShape, Vec2};
use tilesat_textbook::tile::Tile;
use tilesat_textbook::tile_set::{RawTile, tile};
use tilesat_textbook::walk;

pub const MOVER: Mover = Mover::platformer(Axis::NEG_Y);

/// A level, as the host describes it.
pub struct Room {
    pub cells: &'static [u8],
    pub width: u16,
    pub height: u16,
    /// A side of a cell in pixels.
    pub cell: i32,
    /// The level's first corner on both axes, raw.
    pub origin: i32,
    /// By id.
    pub tiles: [RawTile; 34],
}

/// A level in a backend's own form, beside the tiles that it refers to.
pub trait Level<'a>: Sized {
    type Tiles;
    fn tiles(room: &Room) -> Self::Tiles;
    fn of(room: &Room, tiles: &'a Self::Tiles) -> Self;
}

static ALL_SHAPES: TileKinds = {
    let (mut kinds, mut id) = (TileKinds::EMPTY, 1);
    while id < 34 {
        kinds = kinds.with(id, TileKind::of(TileShape::ALL[id as usize]));
        id += 1;
    }
    kinds
};

fn map<S: ShapeSet>(room: &Room, kinds: &'static TileKinds) -> TileMap<'static, S> {
    let origin = Vec2::from_raw(room.origin, room.origin);
    let grid = Grid::new(room.width, room.height, Fx::from_bits(room.cell << 16), origin).expect("a legal grid");
    TileMap::<S>::of(room.cells, grid, kinds).expect("a legal map").with_outside(Outside::Solid)
}

impl Level<'_> for TileMap<'static, Blocks> {
    type Tiles = ();

    fn tiles(_: &Room) {}

    fn of(room: &Room, (): &()) -> Self {
        map(room, &BLOCKS)
    }
}

impl Level<'_> for TileMap<'static, AllShapes> {
    type Tiles = ();

    fn tiles(_: &Room) {}

    fn of(room: &Room, (): &()) -> Self {
        map(room, &ALL_SHAPES)
    }
}

impl<'a, S: Scalar> Level<'a> for walk::Level<'a, S> {
    type Tiles = [Tile<S>; 34];

    fn tiles(room: &Room) -> Self::Tiles {
        core::array::from_fn(|id| tile(&room.tiles[id]))
    }

    fn of(room: &Room, tiles: &'a Self::Tiles) -> Self {
        let (width, height) = (room.width.into(), room.height.into());
        let origin = Vector::of_raw(room.origin, room.origin);
        Self { cells: room.cells, width, height, cell: room.cell, origin, tiles }
    }
}

/// A frame: the body's position and its motion.
pub struct Step<'a, L, B, V> {
    pub level: &'a L,
    pub body: B,
    pub motion: V,
}

impl<'a, L, B: Copy, V: Place> Step<'a, L, B, V> {
    pub fn of(level: &'a L, body: &B, motion: (i32, i32)) -> Self {
        Self { level, body: *body, motion: V::of(motion.0, motion.1) }
    }
}

/// The exact position that a body's numbers mean, in 512ths of a raw unit.
pub trait Exact {
    fn exact(&self) -> [i64; 4];
}

const FINE: i64 = 512;

/// To the nearest, halves away from zero.
fn nearest(parts: f64) -> i64 {
    let whole = parts as i64;
    whole + ((parts - whole as f64) * 2.0) as i64
}

fn fine<S: Scalar>(v: S) -> i64 {
    nearest(v.px() * (FINE << 16) as f64)
}

/// The position at which the host judges a box.
fn even<S: Scalar>(v: S) -> i64 {
    2 * nearest(v.px() * (FINE << 15) as f64)
}

impl Exact for tilesat::Circle {
    fn exact(&self) -> [i64; 4] {
        [self.centre().x, self.centre().y, self.radius(), Fx::ZERO].map(|v| i64::from(v.to_bits()) * FINE)
    }
}

impl Exact for tilesat::Aabb {
    fn exact(&self) -> [i64; 4] {
        [self.min().x, self.min().y, self.max().x, self.max().y].map(|v| i64::from(v.to_bits()) * FINE)
    }
}

impl<S: Scalar> Exact for Circle<S> {
    fn exact(&self) -> [i64; 4] {
        [fine(self.c.x), fine(self.c.y), fine(self.r), 0]
    }
}

impl<S: Scalar> Exact for Aabb<S> {
    fn exact(&self) -> [i64; 4] {
        [self.lo.x, self.lo.y, self.hi.x, self.hi.y].map(even)
    }
}

/// Calls a macro for each mover: the row's workload, its kind of body, backend and question, its
/// level, body and motion, and the call of a frame.
///
/// Textbook boxes move by axes among blocks, in two ways. Everything else moves in steps. Their f64
/// form would not fit into 256 KiB of flash beside the others.
#[macro_export]
macro_rules! each_move {
    ($each:ident) => {
        each_move! { level $each "move: blocks 25 %", Blocks, "move" by_axes, "move (columns)" by_columns }
        each_move! { level $each "move: all shapes 25 %", AllShapes, "move" by_steps }
        each_move! { level $each "move: level ninja", AllShapes, "move" by_steps }
    };
    (level $each:ident $workload:literal, $set:ident, $($asked:literal $boxes:ident),+) => {
        each_move! { own $each $workload, "circle", $set, Circle }
        each_move! { own $each $workload, "box", $set, Aabb }
        each_move! { book $each $workload, "naive Q16.16", Q16, $($asked $boxes),+ }
        each_move! { book $each $workload, "textbook f32", f32, $($asked $boxes),+ }
    };
    (own $each:ident $workload:literal, $kind:literal, $set:ident, $body:ident) => {
        $each! { $workload, $kind, "tilesat", "move",
        tilesat::TileMap<'static, tilesat::$set>, tilesat::$body, tilesat::Vec2,
        |s| MOVER.move_and_slide(s.level, &s.body, s.motion).map_or(s.body, |moved| moved.body) }
    };
    (book $each:ident $workload:literal, $backend:literal, $s:ty, $($asked:literal $boxes:ident),+) => {
        $each! { $workload, "circle", $backend, "move",
        walk::Level<'_, $s>, book::Circle<$s>, book::Vector<$s>,
        |s| walk::by_steps(s.level, &s.body, s.motion) }
        $($each! { $workload, "box", $backend, $asked,
        walk::Level<'_, $s>, book::Aabb<$s>, book::Vector<$s>,
        |s| walk::$boxes(s.level, &s.body, s.motion) })+
    };
}
