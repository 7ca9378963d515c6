//! The level of all tile shapes: a quarter of the cells hold one, at random.

use crate::inputs::{Random, UNIT, circle, vec};
use tilesat::{Aabb, AllShapes, Circle, Fx, Grid, Outside, TileKind, TileKinds, TileMap, TileShape, Vec2};

pub const SIDE: usize = 32;
pub const CELL: i32 = 24;

/// The ids of N++.
static KINDS: TileKinds = {
    let (mut kinds, mut id) = (TileKinds::EMPTY, 0u8);
    while id < 34 {
        kinds = kinds.with(id, TileKind::of(TileShape::ALL[id as usize]));
        id += 1;
    }
    kinds
};

static TILES: [u8; SIDE * SIDE] = tiles(64);

/// Random tiles: this many of 256 hold a shape.
pub const fn tiles(dense: u32) -> [u8; SIDE * SIDE] {
    let (mut tiles, mut i, mut state) = ([0; SIDE * SIDE], 0, 1u32);
    while i < SIDE * SIDE {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        let solid = state >> 24 < dense;
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        if solid {
            tiles[i] = 1 + ((state >> 16) % 33) as u8;
        }
        i += 1;
    }
    tiles
}

/// A quarter of the cells are full, at random.
pub static BLOCKS: [u8; SIDE * SIDE] = {
    let (mut tiles, mut i, mut state) = ([0; SIDE * SIDE], 0, 1u32);
    while i < SIDE * SIDE {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        tiles[i] = (state >> 30 == 0) as u8;
        i += 1;
    }
    tiles
};

pub type Map = TileMap<'static, AllShapes>;

/// The level of these rows.
pub fn level() -> Option<Map> {
    on(&TILES, SIDE as u16, SIDE as u16)
}

/// A closed room.
pub fn on(tiles: &'static [u8], width: u16, height: u16) -> Option<Map> {
    let grid = Grid::new(width, height, Fx::from_bits(CELL * UNIT), Vec2::ZERO).ok()?;
    Some(Map::of(tiles, grid, &KINDS).ok()?.with_outside(Outside::Solid))
}

/// A point of the map, a cell away from its border.
pub fn place(r: &mut Random) -> (i32, i32) {
    let last = (SIDE as i32 - 1) * CELL;
    (r.raw(CELL, last), r.raw(CELL, last))
}

pub fn ball(r: &mut Random) -> Option<Circle> {
    circle(place(r), 10 * UNIT)
}

pub fn crate_(r: &mut Random) -> Option<Aabb> {
    let (x, y) = place(r);
    Aabb::new(vec((x, y)), vec((x + 14 * UNIT, y + 20 * UNIT))).ok()
}
