//! The tiles of a layer, where `LDtk` draws them.

use std::collections::{BTreeMap, HashMap};

use super::raw;
use crate::model::decimal::Decimal;
use crate::model::flip::Flip;
use crate::model::map::{Content, Layer, Placed, Tiles};
use crate::model::object::Spot;

/// Tiles in one cell of a layer. More cannot be distinguished in a picture.
const MOST_PILED: u64 = 8;

/// The meaning of the numbers of a level's layers, while it grows.
pub(super) struct Palette {
    pub(super) all: Vec<Placed>,
    tiles: HashMap<Placing, u32>,
    pub(super) values: HashMap<(String, i64), u32>,
}

impl Palette {
    /// With nothing as the first entry.
    pub(super) fn new() -> Self {
        Self { all: vec![Placed::Nothing], tiles: HashMap::new(), values: HashMap::new() }
    }
}

/// A tile of a tileset, its flips, and the moves of its picture in raw units.
type Placing = (usize, u32, Flip, (i64, i64));

/// The tileset of a layer: its index, and the side of its tiles in pixels.
#[derive(Clone, Copy)]
pub(super) struct Set {
    pub(super) index: usize,
    pub(super) side: u32,
}

/// How `LDtk` draws the tiles of a layer.
struct Drawing {
    /// Sides of a cell and of a tile, in pixels.
    cell: Decimal,
    tile: Decimal,
    pivot: (f64, f64),
    derived: bool,
}

impl Drawing {
    /// The corner of a tile's picture, from the corner of its cell.
    ///
    /// `LDtk` 1.5 puts the pivot of the picture on that of the cell, and mirrors the picture there.
    /// A flipped picture moves by another cell. In both directions it takes the cell's x pivot. The
    /// pictures of rules have their pivot in the corner.
    fn corner(&self, flip: Flip) -> Spot {
        let part = |length: Decimal, of: f64| Decimal::from_f64(length.to_f64() * of);
        let along = |flipped: bool, cell: f64, own: f64| {
            let (at, own) = (part(self.cell, cell), part(self.tile, own));
            if flipped { self.cell + at + own - self.tile } else { at - own }
        };
        let (x, y) = self.pivot;
        if self.derived {
            (along(flip.horizontal, x, 0.0), along(flip.vertical, y, 0.0))
        } else {
            (along(flip.horizontal, x, x), along(flip.vertical, x, y))
        }
    }
}

/// Tiles can lie over each other. There are as many layers as the highest pile has tiles.
pub(super) fn read(
    layer: &raw::Layer,
    set: Set,
    (definition, most): (Option<&raw::LayerDefinition>, u64),
    palette: &mut Palette,
    notes: &mut Vec<String>,
) -> Vec<Layer> {
    let derived = !layer.auto.is_empty();
    let tiles = if derived { &layer.auto } else { &layer.tiles };
    let (width, height, side) = (layer.width.0 as u32, layer.height.0 as u32, layer.tile.0 as i32);
    let most = (most / (u64::from(width) * u64::from(height)).max(1)).min(MOST_PILED) as usize;
    let pivot = definition.map_or((0.0, 0.0), |of| (of.pivot_x, of.pivot_y));
    let (cell, tile) = (Decimal::whole(side.into()), Decimal::whole(set.side.into()));
    let drawing = Drawing { cell, tile, pivot, derived };
    let (mut piles, mut lost): (Vec<Tiles>, BTreeMap<(i32, i32), usize>) = (Vec::new(), BTreeMap::new());
    let room = cell - tile;
    let documented = [pivot.0, pivot.1].map(|of| Decimal::from_f64(room.to_f64() * of));
    let mut elsewhere = 0;
    for placed in tiles {
        // Rules can draw tiles between the cells, and beyond the border, where LDtk cuts them off.
        let (Some(x), Some(y)) =
            (column(placed.px.0, side, width, set.side), column(placed.px.1, side, height, set.side))
        else {
            continue;
        };
        let cell = y as usize * width as usize + x as usize;
        let flip = Flip { diagonal: false, horizontal: placed.f & 1 != 0, vertical: placed.f & 2 != 0 };
        let corner = drawing.corner(flip);
        elsewhere += usize::from([corner.0, corner.1] != documented);
        let between = |px: i32, at: i32| Decimal::whole(i64::from(px) - i64::from(at) * i64::from(side));
        let moved = (corner.0 + between(placed.px.0, x), corner.1 + between(placed.px.1, y));
        let place = entry(palette, set.index, placed.t.unwrap_or_default(), flip, moved);
        match piles.iter().position(|pile| pile.cells[cell] == 0) {
            Some(pile) => piles[pile].cells[cell] = place,
            None if piles.len() < most => {
                let mut cells = vec![0; width as usize * height as usize];
                cells[cell] = place;
                piles.push(Tiles { tile: side as u16, at: (0, 0), width, height, cells, derived });
            }
            None => *lost.entry((x, y)).or_default() += 1,
        }
    }
    if elsewhere > 0 {
        notes.push(format!(
            "layer '{}': LDtk draws {elsewhere} of its tiles elsewhere than its tile pivot ({}, {}) says; what is solid \
             of them is solid where they are drawn",
            layer.name, pivot.0, pivot.1
        ));
    }
    if let Some((&(x, y), _)) = lost.first_key_value() {
        notes.push(format!(
            "layer '{}': {} tiles lie over {} others in their cells, and are not read; the first is in column {x}, row \
             {y}: remove what they hide",
            layer.name,
            lost.values().sum::<usize>(),
            piles.len()
        ));
    }
    let offset = (layer.x.into(), layer.y.into());
    piles.into_iter().map(|pile| Layer::plain(&layer.name, offset, Content::Tiles(pile))).collect()
}

/// The column, or the row, of a tile at this pixel: the nearest one of the layer. `None` if no part
/// of the tile is in the layer.
fn column(px: i32, side: i32, count: u32, tile: u32) -> Option<i32> {
    let (at, end) = (i64::from(px), i64::from(side) * i64::from(count));
    let seen = at + i64::from(tile) > 0 && at < end && count > 0;
    seen.then(|| px.div_euclid(side).clamp(0, count as i32 - 1))
}

/// The index of a tile in the palette.
fn entry(palette: &mut Palette, tileset: usize, id: u32, flip: Flip, moved: Spot) -> u32 {
    let next = palette.all.len() as u32;
    let key = (tileset, id, flip, (moved.0.raw(), moved.1.raw()));
    let place = *palette.tiles.entry(key).or_insert(next);
    if place == next {
        palette.all.push(Placed::Tile { tileset, id, flip, moved });
    }
    place
}
