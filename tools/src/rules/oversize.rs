//! Tiles whose pictures are larger than their cells, and that are solid without a collision shape.
//!
//! Engines differ: Phaser takes the picture, Excalibur and Grid Engine take the cell. The drawing
//! decides. Where solid tiles are drawn as if each filled its cell, their pictures lie over each
//! other: walls in perspective. Where pictures lie side by side, each is a block as large as drawn.

use tilesat::TileShape;

use super::cells::Sheet;
use super::layers::Layers;
use super::piece::{self, Block, Piece};
use super::words;

/// The most cells of a picture along x and y that count.
const MOST: i32 = 16;

/// One tile of so many may lie over another one by mistake.
const SLIPS: usize = 16;

impl Layers<'_> {
    /// Makes only the cells of large pictures solid, where the pictures lie over each other.
    pub(super) fn oversize(&mut self, sheets: &mut [Sheet<'_>]) {
        for sheet in sheets {
            let tile = sheet.tiles.tile;
            let is_solid = |entry: &u32| sheet.shapes.get(entry).is_some_and(|shape| *shape != TileShape::Empty);
            let large =
                |entry: &u32| is_solid(entry) && piece::is_large(self.map, &self.map.palette[*entry as usize], tile);
            let all: Vec<u32> = sheet.used.iter().map(|(entry, _)| *entry).filter(large).collect();
            if all.is_empty() {
                continue;
            }
            let drawn: Vec<(u32, Block)> = all
                .iter()
                .map(|&entry| (entry, piece::drawn_on(self.map, &self.map.palette[entry as usize], tile)))
                .collect();
            let (count, over, beside) = self.laid(sheet, &drawn);
            let what = format!("{} of layer '{}'", words::several(count, "tile"), sheet.layer.name);
            let are = if count == 1 { "is" } else { "are" };
            if over > 1 && (over > beside || over * SLIPS >= count) {
                let own = piece::own_cells(self.map);
                for entry in all {
                    sheet.pieces.insert(entry, piece::in_cell(self.map, sheet.shapes[&entry], tile));
                    if let Some(cells) = sheet.flagged.get_mut(&entry) {
                        *cells = own;
                    }
                }
                self.note(format!(
                    "GUESS: {what}, larger than cells, lie over each other, so only their cells \
                     are solid; collision shapes in Tiled settle it"
                ));
            } else if beside * 2 < count {
                self.note(format!(
                    "GUESS: {what}, larger than cells, {are} solid as drawn; collision shapes in \
                     Tiled settle it"
                ));
            }
        }
    }

    /// How many of these tiles there are, how many pictures lie over the cell of another solid
    /// tile, and how many end where the next one begins.
    fn laid(&self, sheet: &Sheet<'_>, drawn: &[(u32, Block)]) -> (usize, usize, usize) {
        let (tiles, own) = (sheet.tiles, self.map.grid);
        let solid = |x: i32, y: i32| {
            let piece = tiles.entry((x.into(), y.into())).and_then(|entry| sheet.pieces.get(&entry));
            piece.is_some_and(|piece| *piece != Piece::Shape(TileShape::Empty))
        };
        let (mut count, mut over, mut beside) = (0, 0, 0);
        for (x, y, entry) in tiles.drawn() {
            let Ok(index) = drawn.binary_search_by_key(&entry, |(entry, _)| *entry) else { continue };
            let ((left, top), (columns, rows)) = drawn[index].1;
            count += 1;
            let rows_near = (0..rows).rev().take(MOST as usize);
            let covers = rows_near
                .flat_map(|j| (0..columns.min(MOST)).map(move |i| (left + i, top + j)))
                .any(|at| at != (0, 0) && solid(x + at.0, y + at.1));
            let across = columns > own.0 as i32 && (solid(x + columns, y) || solid(x - columns, y));
            let down = rows > own.1 as i32 && (solid(x, y + rows) || solid(x, y - rows));
            over += usize::from(covers);
            beside += usize::from(!covers && (across || down));
        }
        (count, over, beside)
    }
}
