//! The cells of a tile layer.

use super::data::{self, Form, MAX_CELLS};
use super::{Reader, Result, raw};
use crate::model::map::{Map, Placed, Tiles};

/// Columns and rows are at most this far from the origin: their pixels stay below 2^30.
const FARTHEST: i64 = (1 << 30) / Map::MAX_TILE as i64;

impl Reader<'_> {
    /// The tiles, moved by so many cells of the file.
    pub(super) fn placed(&self, tiles: Tiles, by: (i32, i32)) -> Result<Tiles> {
        let along = |at: i32, by: i32, count: u32, grid: u32| {
            let start = i64::from(at) + i64::from(by) * i64::from(grid);
            let inside = start >= -FARTHEST && start + i64::from(count) <= FARTHEST;
            i32::try_from(start).ok().filter(|_| inside)
        };
        let (x, y) =
            (along(tiles.at.0, by.0, tiles.width, self.grid.0), along(tiles.at.1, by.1, tiles.height, self.grid.1));
        let Some(at) = x.zip(y) else {
            let own = |at: i32, by: i32, grid: u32| i64::from(at) / i64::from(grid) + i64::from(by);
            let (x, y) = (own(tiles.at.0, by.0, self.grid.0), own(tiles.at.1, by.1, self.grid.1));
            return Err(format!(
                "it begins in column {x}, row {y}: move it nearer, columns and rows stay below {}",
                FARTHEST / i64::from(self.grid.0.max(self.grid.1))
            ));
        };
        Ok(Tiles { at, ..tiles })
    }

    fn warn(&mut self, layer: &str, what: impl Into<String>) {
        self.warnings.push((format!("layer '{layer}'"), what.into()));
    }

    /// The tiles of a layer of this name.
    pub(super) fn tiles(
        &mut self,
        name: &str,
        (data, chunks): (Option<raw::Data>, Vec<raw::Chunk>),
        form: &Form<'_>,
    ) -> Result<Tiles> {
        let data = data.filter(|data| !data.is_empty());
        let mut tiles = match data {
            // As Tiled reads JSON: chunks count only without data.
            Some(data) if self.is_json || !self.infinite && chunks.is_empty() => {
                if !chunks.is_empty() {
                    self.warn(name, "it has data and chunks: as in Tiled, its data counts");
                }
                self.count(form.width, form.height)?;
                let cells = self.places(name, data, form)?;
                Tiles { tile: self.tile, at: (0, 0), width: form.width, height: form.height, cells, derived: false }
            }
            None if chunks.is_empty() => {
                if !self.infinite {
                    self.warn(name, "it has no data, so it is empty, as in Tiled");
                }
                return Ok(Tiles { tile: self.tile, ..Tiles::default() });
            }
            Some(_) if chunks.is_empty() => {
                self.warn(
                    name,
                    "its tiles are dropped, as in Tiled: the map is infinite, and they are in no chunk; set infinite to 0",
                );
                return Ok(Tiles { tile: self.tile, ..Tiles::default() });
            }
            _ => self.chunks(name, chunks, form)?,
        };
        self.beyond(name, &tiles);
        if self.grid != (1, 1) {
            spread(&mut tiles, self.grid);
        }
        Ok(tiles)
    }

    /// Warns about tiles that their tileset does not have. Tiled keeps them.
    fn beyond(&mut self, name: &str, tiles: &Tiles) {
        if !self.sets.beyond {
            return;
        }
        let is_beyond = |cell: u32| match &self.sets.palette[cell as usize] {
            Placed::Tile { tileset, id, .. } => {
                Some((*tileset, *id)).filter(|(tileset, id)| !self.sets.all[*tileset].has(*id))
            }
            _ => None,
        };
        let mut all = tiles.drawn().filter_map(|(x, y, cell)| Some((x, y, is_beyond(cell)?)));
        if let Some((x, y, (tileset, id))) = all.next() {
            let (count, set) = (1 + all.count(), &self.sets.all[tileset].name);
            let what = format!(
                "{count} of its tiles are in no tileset, the first in column {x}, row {y}: '{set}' has no tile {id}; \
                 they have neither a class nor properties"
            );
            self.warn(name, what);
        }
    }

    fn chunks(&mut self, name: &str, chunks: Vec<raw::Chunk>, form: &Form<'_>) -> Result<Tiles> {
        // Chunks can overlap, and each one is unpacked.
        let all = chunks
            .iter()
            .fold(0, |all: u64, chunk| all.saturating_add(u64::from(chunk.width) * u64::from(chunk.height)));
        if all > MAX_CELLS {
            return Err(format!("its chunks have more than {MAX_CELLS} tiles"));
        }
        let sides = |chunk: &raw::Chunk| {
            (i64::from(chunk.x) + i64::from(chunk.width), i64::from(chunk.y) + i64::from(chunk.height))
        };
        let (left, top) = chunks.iter().fold((i32::MAX, i32::MAX), |at, chunk| (at.0.min(chunk.x), at.1.min(chunk.y)));
        let (right, bottom) =
            chunks.iter().map(sides).fold((i64::MIN, i64::MIN), |at, end| (at.0.max(end.0), at.1.max(end.1)));
        let side = |from: i32, to: i64| u32::try_from(to - i64::from(from)).unwrap_or(u32::MAX);
        let (width, height) = (side(left, right), side(top, bottom));
        self.count(width, height)?;
        let mut cells = vec![0; width as usize * height as usize];
        for chunk in chunks {
            let form = Form { width: chunk.width, height: chunk.height, ..*form };
            let of_chunk = |why: String| format!("the chunk at ({}, {}): {why}", chunk.x, chunk.y);
            let data = chunk.data.ok_or_else(|| of_chunk("it has no data: save the map again in Tiled".to_owned()))?;
            let places = self.places(name, data, &form).map_err(of_chunk)?;
            let (x, y) = ((chunk.x - left) as usize, (chunk.y - top) as usize);
            for (row, line) in places.chunks(chunk.width.max(1) as usize).enumerate() {
                let from = (y + row) * width as usize + x;
                cells[from..from + line.len()].copy_from_slice(line);
            }
        }
        Ok(Tiles { tile: self.tile, at: (left, top), width, height, cells, derived: false })
    }

    /// Refuses more cells than a map may have.
    fn count(&mut self, width: u32, height: u32) -> Result<()> {
        let cells = u128::from(width) * u128::from(height) * u128::from(self.grid.0) * u128::from(self.grid.1);
        self.cells = self.cells.saturating_add(u64::try_from(cells).unwrap_or(u64::MAX));
        if self.cells > MAX_CELLS {
            return Err(format!("with it the layers have more than {MAX_CELLS} tiles"));
        }
        Ok(())
    }

    fn places(&mut self, name: &str, mut data: raw::Data, form: &Form<'_>) -> Result<Vec<u32>> {
        if let (Some("xml"), raw::Data::List(gids)) = (form.encoding, &mut data) {
            let (known, cells) = (gids.len(), form.width as usize * form.height as usize);
            if known < cells {
                gids.resize(cells, 0);
                self.warn(
                    name,
                    format!("its tiles are {known}, fewer than its width and height: the rest is empty, as in Tiled"),
                );
            }
        }
        let mut cells = data::gids(data, form)?;
        let mut last = (0, 0);
        for (i, cell) in cells.iter_mut().enumerate() {
            if *cell != last.0 {
                let (column, row) = (i as u32 % form.width.max(1), i as u32 / form.width.max(1));
                let of_cell = |why: String| format!("column {column}, row {row}: {why}");
                last = (*cell, self.sets.place(*cell).map_err(of_cell)?);
            }
            *cell = last.1;
        }
        Ok(cells)
    }
}

/// Cells of the file become so many square ones each. Tiled draws a tile from the lower left corner
/// of its cell, so the tile is there.
fn spread(tiles: &mut Tiles, (across, down): (u32, u32)) {
    if tiles.cells.is_empty() {
        return;
    }
    let (width, height) = (tiles.width * across, tiles.height * down);
    let mut cells = vec![0; width as usize * height as usize];
    for (i, &cell) in tiles.cells.iter().enumerate() {
        let (x, y) = (i as u32 % tiles.width, i as u32 / tiles.width);
        cells[((y + 1) * down - 1) as usize * width as usize + (x * across) as usize] = cell;
    }
    // The count of cells is limited, and so is each side.
    tiles.at = (tiles.at.0.saturating_mul(across as i32), tiles.at.1.saturating_mul(down as i32));
    (tiles.width, tiles.height, tiles.cells) = (width, height, cells);
}
