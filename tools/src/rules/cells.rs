//! Merges the tile layers of a map: one grid of shapes and flags, and paths for shapes that fit no
//! cell.

use std::collections::HashMap;
use std::collections::hash_map::Entry;

use tilesat::{TileKind, TileShape};

use super::flags::Flags;
use super::kind::Kind;
use super::piece::{self, Path, Piece};
use super::place::Unit;
use crate::model::decimal::Decimal;
use crate::model::map::{Layer, Tiles};
use crate::model::object::raw;

/// The most edges. A segment map holds 32 768 segments.
const MAX_EDGES: usize = 1 << 19;
/// The most cells of the grid.
const MAX_CELLS: i64 = 1 << 24;

/// A first cell, and columns and rows.
type Block = ((i64, i64), (i32, i32));

/// The solid of a layer, for each palette entry that it uses.
pub(super) struct Sheet<'a> {
    pub(super) layer: &'a Layer,
    pub(super) tiles: &'a Tiles,
    /// The palette entries that it draws, and how often.
    pub(super) used: Vec<(u32, u64)>,
    pub(super) pieces: HashMap<u32, Piece>,
    /// The shapes of those that are not drawn in the collision editor.
    pub(super) shapes: HashMap<u32, TileShape>,
    pub(super) flags: HashMap<u32, Vec<String>>,
    /// The cells of the entries that have flags.
    pub(super) flagged: HashMap<u32, piece::Block>,
}

impl Sheet<'_> {
    /// Whether a tile of it is solid or has flags.
    fn counts(&self) -> bool {
        self.used.iter().any(|(entry, _)| self.pieces.contains_key(entry) || self.flags.contains_key(entry))
    }

    /// How many of its tiles are solid in whole cells.
    fn solids(&self) -> usize {
        let shapes = |cell: &&u32| matches!(self.pieces.get(cell), Some(Piece::Shape(_) | Piece::Cells { .. }));
        self.tiles.cells.iter().filter(shapes).count()
    }

    /// Whether its layer has no offset.
    fn stays(&self) -> bool {
        let raw = |offset: Decimal| Unit::new(None).raw(offset).0;
        (raw(self.layer.offset.0), raw(self.layer.offset.1)) == (0, 0)
    }
}

/// A grid in pixels of the map: the first corner of its cells, and their size.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) struct Lattice {
    tile: u16,
    /// In raw units, below a cell.
    phase: (i64, i64),
}

/// The cells, row by row, from the column and row `at` on.
#[derive(Debug, Default)]
pub(super) struct Cells {
    pub(super) tile: u16,
    /// The first corner of the first cell, in raw units of the map.
    pub(super) at: (i64, i64),
    pub(super) width: u32,
    pub(super) height: u32,
    /// `None` if no tile has a meaning.
    pub(super) kinds: Vec<TileKind>,
    pub(super) paths: Vec<Placed>,
    /// Layers whose flags lie between the cells.
    pub(super) lost: Vec<String>,
    /// Layers with flags beyond the cells that no polygon has, and how many tiles have one.
    pub(super) beyond: Vec<(String, usize)>,
}

/// A path of a tile at its position, in pixels of the map.
#[derive(Debug)]
pub(super) struct Placed {
    pub(super) path: Path,
    pub(super) flags: u8,
    pub(super) layer: String,
}

impl Lattice {
    pub(super) fn of(sheet: &Sheet<'_>) -> Self {
        let side = i64::from(sheet.tiles.tile) << 16;
        let phase = |offset: Decimal| Unit::new(None).raw(offset).0.rem_euclid(side);
        Self { tile: sheet.tiles.tile, phase: (phase(sheet.layer.offset.0), phase(sheet.layer.offset.1)) }
    }

    /// The same with cells of another size.
    fn resized(self, tile: u16) -> Self {
        let side = i64::from(tile) << 16;
        Self { tile, phase: (self.phase.0.rem_euclid(side), self.phase.1.rem_euclid(side)) }
    }

    /// How many cells a cell of the layer is along x and y, if it is some of them exactly.
    fn parts(self, sheet: &Sheet<'_>) -> Option<u16> {
        let fits = sheet.tiles.tile.is_multiple_of(self.tile) && Self::of(sheet).resized(self.tile) == self;
        fits.then(|| sheet.tiles.tile / self.tile)
    }

    /// The column and row of the first cell of a layer whose cells are so many of this lattice.
    fn start(self, sheet: &Sheet<'_>, parts: u16) -> (i64, i64) {
        let side = i64::from(self.tile) << 16;
        let along = |offset: Decimal, phase: i64, at: i32| {
            (Unit::new(None).raw(offset).0 - phase) / side + i64::from(at) * i64::from(parts)
        };
        let (offset, at) = (sheet.layer.offset, sheet.tiles.at);
        (along(offset.0, self.phase.0, at.0), along(offset.1, self.phase.1, at.1))
    }
}

/// Merges the sheets, the lowest first. All levels of a project can have cells of one side.
pub(super) fn merge(sheets: &[Sheet<'_>], side: Option<u16>, flags: &mut Flags) -> Result<Cells, String> {
    let Some(lattice) = best(sheets, side) else { return Ok(Cells { tile: side.unwrap_or(0), ..Cells::default() }) };
    let mut cells = Cells { tile: lattice.tile, ..Cells::default() };
    let fitting = sheets.iter().filter(|sheet| !sheet.tiles.cells.is_empty());
    let fitting: Vec<(&Sheet<'_>, u16)> = fitting.filter_map(|sheet| Some((sheet, lattice.parts(sheet)?))).collect();
    // Scenery that is moved, such as the tops of walls, adds no empty rows. Nor does that of layers
    // with other cells.
    let whole = |sheet: &Sheet<'_>, parts: u16| sheet.counts() || parts == 1 && sheet.stays();
    let mut on = fitting.clone();
    on.retain(|(sheet, parts)| whole(sheet, *parts));
    if on.is_empty() {
        on = fitting;
    }
    let starts = on.iter().map(|(sheet, parts)| lattice.start(sheet, *parts));
    // Without a layer on the cells there are none, and all solids are polygons.
    let least = starts.clone().reduce(|at, start| (at.0.min(start.0), at.1.min(start.1)));
    let (left, top) = least.unwrap_or((0, 0));
    let ends = on.iter().zip(starts).map(|((sheet, parts), at)| {
        let along = |count: u32| i64::from(count) * i64::from(*parts);
        (at.0 + along(sheet.tiles.width), at.1 + along(sheet.tiles.height))
    });
    let (right, bottom) = ends.fold((left, top), |at, end| (at.0.max(end.0), at.1.max(end.1)));
    let (width, height) = (right - left, bottom - top);
    if width.saturating_mul(height) > MAX_CELLS {
        return Err(format!("the tile layers cover {width}x{height} cells together; there can be {MAX_CELLS}"));
    }
    (cells.width, cells.height) = (width as u32, height as u32);
    let side = i64::from(lattice.tile) << 16;
    cells.at = (left * side + lattice.phase.0, top * side + lattice.phase.1);
    cells.kinds = vec![TileKind::EMPTY; (width * height) as usize];
    let mut edges = 0;
    for sheet in sheets {
        let from = lattice.parts(sheet).map(|parts| {
            let start = lattice.start(sheet, parts);
            ((start.0 - left, start.1 - top), parts)
        });
        cells.lay(sheet, from, flags, &mut edges).map_err(|why| format!("layer '{}': {why}", sheet.layer.name))?;
    }
    Ok(cells)
}

/// The side of the cells for several levels: that of the most solid tiles of all.
pub(super) fn side<'a>(sheets: impl Iterator<Item = &'a Sheet<'a>>) -> Option<u16> {
    most(sheets.map(|sheet| (sheet.tiles.tile, sheet.solids())))
}

/// The lattice with the most solid tiles, of this side if it is given.
fn best(sheets: &[Sheet<'_>], side: Option<u16>) -> Option<Lattice> {
    let all = || sheets.iter().map(|sheet| (Lattice::of(sheet), sheet.solids()));
    let of_side = most(all().filter(|(lattice, _)| side.is_none_or(|side| side == lattice.tile)));
    of_side.or_else(|| Some(most(all())?.resized(side?)))
}

/// The one with the highest sum. On a tie, the first one.
fn most<T: PartialEq>(counts: impl Iterator<Item = (T, usize)>) -> Option<T> {
    let mut sums: Vec<(T, usize)> = Vec::new();
    for (of, count) in counts {
        match sums.iter_mut().find(|(known, _)| *known == of) {
            Some((_, sum)) => *sum += count,
            None => sums.push((of, count)),
        }
    }
    // `max_by_key` keeps the last of equals.
    sums.into_iter().rev().max_by_key(|(_, sum)| *sum).map(|(of, _)| of)
}

impl Cells {
    /// Puts a sheet on top. `from` is its first cell on the lattice, if it lies on it, and how many
    /// cells each of its own is along x and y.
    fn lay(
        &mut self,
        sheet: &Sheet<'_>,
        from: Option<((i64, i64), u16)>,
        flags: &mut Flags,
        edges: &mut usize,
    ) -> Result<(), String> {
        let mut masks: HashMap<u32, u8> = HashMap::new();
        // Tiles of one kind are adjacent.
        let (mut last, mut mask, mut piece) = (0, 0, None);
        for (x, y, cell) in sheet.tiles.drawn() {
            if cell != last {
                mask = match masks.entry(cell) {
                    Entry::Occupied(known) => *known.get(),
                    Entry::Vacant(new) => {
                        let names = sheet.flags.get(&cell).map(Vec::as_slice).unwrap_or_default();
                        *new.insert(names.iter().fold(0, |all, name| all | flags.bit(name)))
                    }
                };
                (last, piece) = (cell, sheet.pieces.get(&cell));
            }
            let Some((from, parts)) = from else {
                if mask != 0 && !self.lost.contains(&sheet.layer.name) {
                    self.lost.push(sheet.layer.name.clone());
                }
                self.apart(sheet, (x, y), piece, mask, edges)?;
                continue;
            };
            let along = |cells: i32| i64::from(cells) * i64::from(parts);
            let at = (from.0 + along(x - sheet.tiles.at.0), from.1 + along(y - sheet.tiles.at.1));
            let block = |((dx, dy), size): piece::Block| {
                ((at.0 + along(dx), at.1 + along(dy)), (along(size.0) as i32, along(size.1) as i32))
            };
            if mask != 0 {
                let (first, size) = block(sheet.flagged.get(&cell).copied().unwrap_or(((0, 0), (1, 1))));
                let (within, beyond) = self.split(first, size);
                if piece.is_none() && !beyond.is_empty() {
                    self.loses(&sheet.layer.name);
                }
                for cell in within {
                    if let Some(kind) = self.kind(cell) {
                        *kind = TileKind::of(kind.shape).with_flags(kind.flags | mask);
                    }
                }
            }
            match piece {
                Some(Piece::Shape(TileShape::Full)) if parts > 1 => {
                    let (first, size) = block(((0, 0), (1, 1)));
                    for cell in self.split(first, size).0 {
                        self.put(cell, TileShape::Full);
                    }
                }
                // Several cells rarely have the shape together, so it stays one polygon.
                Some(Piece::Shape(shape)) if parts > 1 => {
                    self.paths(sheet, (x, y), &piece::as_path(*shape, sheet.tiles.tile), mask, edges)?;
                }
                Some(Piece::Shape(shape)) => {
                    if let Some(rest) = self.put(at, *shape) {
                        self.paths(sheet, (x, y), &piece::as_path(rest, self.tile), mask, edges)?;
                    }
                }
                Some(Piece::Cells { at: first, size, beside }) => {
                    self.paths(sheet, (x, y), beside, mask, edges)?;
                    let (first, size) = block((*first, *size));
                    let (within, beyond) = self.split(first, size);
                    for cell in within {
                        self.put(cell, TileShape::Full);
                    }
                    for (first, size) in beyond {
                        let first = ((first.0 - at.0) as i32, (first.1 - at.1) as i32);
                        self.paths(sheet, (x, y), &piece::block(first, size, self.tile), mask, edges)?;
                    }
                }
                Some(Piece::Paths(paths)) => self.paths(sheet, (x, y), paths, mask, edges)?,
                None => {}
            }
        }
        Ok(())
    }

    fn loses(&mut self, layer: &str) {
        match self.beyond.last_mut().filter(|(last, _)| last == layer) {
            Some((_, count)) => *count += 1,
            None => self.beyond.push((layer.to_owned(), 1)),
        }
    }

    fn kind(&mut self, (x, y): (i64, i64)) -> Option<&mut TileKind> {
        let inside = (0..i64::from(self.width)).contains(&x) && (0..i64::from(self.height)).contains(&y);
        if inside { self.kinds.get_mut((y * i64::from(self.width) + x) as usize) } else { None }
    }

    /// The cells of a block that the grid has, and the blocks of the others: no cell can hold them.
    fn split(&self, (x, y): (i64, i64), size: (i32, i32)) -> (Vec<(i64, i64)>, Vec<Block>) {
        let (right, bottom) = (x + i64::from(size.0), y + i64::from(size.1));
        let (width, height) = (i64::from(self.width), i64::from(self.height));
        let (left_in, right_in) = (x.clamp(0, width), right.clamp(0, width));
        let (top_in, bottom_in) = (y.clamp(0, height), bottom.clamp(0, height));
        let within = (top_in..bottom_in).flat_map(|row| (left_in..right_in).map(move |column| (column, row))).collect();
        let sides = [
            ((x, y), (right, bottom.min(0))),
            ((x, y.max(height)), (right, bottom)),
            ((x, top_in), (right.min(0), bottom_in)),
            ((x.max(width), top_in), (right, bottom_in)),
        ];
        let block = |(from, to): ((i64, i64), (i64, i64))| (from, ((to.0 - from.0) as i32, (to.1 - from.1) as i32));
        (within, sides.into_iter().map(block).filter(|(_, size)| size.0 > 0 && size.1 > 0).collect())
    }

    /// Puts a shape into a cell. Returns it if the cell has another shape and neither contains the
    /// other.
    fn put(&mut self, at: (i64, i64), shape: TileShape) -> Option<TileShape> {
        let kind = self.kind(at)?;
        let flags = kind.flags;
        match (kind.shape, shape) {
            (_, TileShape::Empty) => None,
            (a, b) if a == b || a == TileShape::Full => None,
            (TileShape::Empty, _) | (_, TileShape::Full) => {
                *kind = TileKind::of(shape).with_flags(flags);
                None
            }
            _ => Some(shape),
        }
    }

    /// A tile of a layer that lies between the cells.
    fn apart(
        &mut self,
        sheet: &Sheet<'_>,
        at: (i32, i32),
        piece: Option<&Piece>,
        mask: u8,
        edges: &mut usize,
    ) -> Result<(), String> {
        let tile = sheet.tiles.tile;
        match piece {
            Some(Piece::Shape(shape)) => self.paths(sheet, at, &piece::as_path(*shape, tile), mask, edges),
            Some(Piece::Cells { at: (dx, dy), size, beside }) => {
                self.paths(sheet, at, beside, mask, edges)?;
                let all = (0..size.1).flat_map(|j| (0..size.0).map(move |i| (i, j)));
                let full = piece::as_path(TileShape::Full, tile);
                all.into_iter()
                    .try_for_each(|(i, j)| self.paths(sheet, (at.0 + dx + i, at.1 + dy + j), &full, mask, edges))
            }
            Some(Piece::Paths(paths)) => self.paths(sheet, at, paths, mask, edges),
            None => Ok(()),
        }
    }

    fn paths(
        &mut self,
        sheet: &Sheet<'_>,
        (x, y): (i32, i32),
        paths: &[Path],
        flags: u8,
        edges: &mut usize,
    ) -> Result<(), String> {
        let corner =
            |offset: Decimal, index: i32| offset + Decimal::whole(i64::from(index) * i64::from(sheet.tiles.tile));
        let (dx, dy) = (corner(sheet.layer.offset.0, x), corner(sheet.layer.offset.1, y));
        // Decimals end there.
        let tile = i64::from(sheet.tiles.tile);
        let far = |index: i32| (i64::from(index) * tile).abs() >= 1_000_000 - tile.max(256);
        if !paths.is_empty() && (far(x) || far(y)) {
            return Err(format!(
                "its tile in column {x}, row {y} is no shape of the library, and a million pixels from the origin; \
                 --solid NAME makes tiles of a name full"
            ));
        }
        for path in paths {
            *edges += path.points.len();
            if *edges > MAX_EDGES {
                return Err(format!(
                    "more than {MAX_EDGES} edges of tiles that are no shape of the library; --solid NAME makes tiles of a name full"
                ));
            }
            let points = path.points.iter().map(|&(px, py)| (px + dx, py + dy)).collect();
            let path = Path { points, ..path.clone() };
            self.paths.push(Placed { path, flags, layer: sheet.layer.name.clone() });
        }
        Ok(())
    }

    /// The shapes of the cells that are at most `most` raw units from a point, and the corner of
    /// each cell.
    pub(super) fn shapes_near(
        &self,
        (x, y): (i64, i64),
        most: i64,
    ) -> impl Iterator<Item = ((i64, i64), TileShape)> + '_ {
        let side = i64::from(self.tile.max(1)) << 16;
        let range = |v: i64, at: i64, count: u32| {
            let (first, last) = ((v - most - at).div_euclid(side), (v + most - at).div_euclid(side));
            first.max(0)..(last + 1).min(i64::from(count))
        };
        let (columns, rows) = (range(x, self.at.0, self.width), range(y, self.at.1, self.height));
        rows.flat_map(move |row| columns.clone().map(move |column| (column, row))).map(move |(column, row)| {
            let kind = self.kinds[(row * i64::from(self.width) + column) as usize];
            ((self.at.0 + column * side, self.at.1 + row * side), kind.shape)
        })
    }

    /// Whether a polygon's box lies in one full cell, whose solid contains it.
    pub(super) fn hides(&self, path: &Path) -> bool {
        let side = i64::from(self.tile) << 16;
        let cell = |(x, y): (i64, i64)| ((x - self.at.0).div_euclid(side), (y - self.at.1).div_euclid(side));
        let raw = raw(&path.points);
        let lo = raw.iter().fold((i64::MAX, i64::MAX), |at, p| (at.0.min(p.0), at.1.min(p.1)));
        let hi = raw.iter().fold((i64::MIN, i64::MIN), |at, p| (at.0.max(p.0), at.1.max(p.1)));
        if raw.is_empty() || self.kinds.is_empty() || path.kind == Kind::Hole {
            return false;
        }
        let (first, last) = (cell(lo), cell((hi.0 - 1, hi.1 - 1)));
        let inside = (0..i64::from(self.width)).contains(&first.0) && (0..i64::from(self.height)).contains(&first.1);
        first == last
            && inside
            && self.kinds[(first.1 * i64::from(self.width) + first.0) as usize].shape == TileShape::Full
    }
}
