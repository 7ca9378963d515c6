//! The area that a placed tile fills: a shape of its cell, several cells, or paths that are not a
//! shape of the library.
#![allow(clippy::cast_precision_loss, reason = "raw coordinates are below 2^53")]

use tilesat::TileShape;

use super::kind::Kind;
use super::knots::{self, Knot};
use super::likeness::{self, Likeness};
use super::marked::senses;
use super::names;
use super::place::Unit;
use super::union::union;
use super::verdict::Solid;
use super::weld;
use super::{edges, form};
use crate::geometry::{Point, doubled_area};
use crate::model::decimal::Decimal;
use crate::model::flip::Flip;
use crate::model::map::{Map, Placed};
use crate::model::object::{Object, Spot, raw};
use crate::model::tileset::Tileset;

/// A cell relative to that of a tile, and columns and rows from it on.
pub(super) type Block = ((i32, i32), (i32, i32));

/// The area that a tile fills.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Piece {
    Shape(TileShape),
    /// This many columns and rows, from this cell relative to its own.
    Cells {
        at: (i32, i32),
        size: (i32, i32),
        /// What else the tile has, relative to the corner of its cell.
        beside: Vec<Path>,
    },
    /// Relative to the corner of its cell.
    Paths(Vec<Path>),
}

/// A polygon or a chain in pixels of the map.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Path {
    pub(super) kind: Kind,
    pub(super) closed: bool,
    pub(super) points: Vec<Spot>,
    /// In thousandths of a pixel; see [`form::Corners`].
    pub(super) error: u32,
    /// The corners that moved onto the border of the tile.
    pub(super) welded: u32,
    /// Whether it is a part of a drawn polygon that crosses itself.
    pub(super) torn: bool,
}

impl Path {
    /// The parts of a polygon that crosses itself.
    pub(super) fn parts(&self, parts: Vec<Vec<Point>>) -> Vec<Self> {
        let spots = |part: Vec<Point>| part.into_iter().map(weld::exact).collect();
        parts.into_iter().map(|part| Self { points: spots(part), torn: true, ..self.clone() }).collect()
    }
}

/// The drawing position of a tile, in pixels from the corner of its cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Frame {
    x: Decimal,
    y: Decimal,
    width: Decimal,
    height: Decimal,
    /// Numerators and denominators: its size over that of the picture, along x and y.
    scale: [(u32, u32); 2],
}

impl Frame {
    /// At the corner of the cell.
    pub(super) fn new(width: i64, height: i64) -> Self {
        let (width, height) = (Decimal::whole(width), Decimal::whole(height));
        Self { x: Decimal::ZERO, y: Decimal::ZERO, width, height, scale: [(1, 1); 2] }
    }

    /// Of a tile in a layer with cells of this side.
    fn of(map: &Map, set: &Tileset, id: u32, flip: Flip, side: i64) -> Self {
        let (w, h) = set.size_of(id);
        let (across, down) = if flip.diagonal { (h, w) } else { (w, h) };
        if w == 0 || h == 0 {
            return Self::new(side, side);
        }
        // LDtk draws tiles downward from the upper left corner of their cell.
        if map.values {
            return Self::new(across.into(), down.into());
        }
        // A cell of the file. Its tile is in the lower left one of the cells that it is here.
        let cell = (side as u32 * map.grid.0, side as u32 * map.grid.1);
        // The reader refuses turned tiles that fill a cell that is not square, if they are scaled.
        let fits = set.fits_grid && (cell.0 == cell.1 || !flip.diagonal);
        let whole = [(cell.0, across), (cell.1, down)];
        let tighter = usize::from(u64::from(cell.1) * u64::from(across) < u64::from(cell.0) * u64::from(down));
        let scale = match (fits, set.keeps_aspect) {
            (false, _) => [(1, 1); 2],
            (true, false) => whole,
            (true, true) => [whole[tighter]; 2],
        };
        let scaled = |length: i64, (to, from): (u32, u32)| Decimal::whole(length).scaled(to, from);
        let (width, height) = (scaled(across.into(), scale[0]), scaled(down.into(), scale[1]));
        // Tiled draws tiles upward from the lower left corner of their cell. A tile that is drawn
        // at another size scales its offset with it.
        let own = if flip.diagonal { [scale[1], scale[0]] } else { scale };
        let (x, y) = (scaled(set.offset.0.into(), own[0]), scaled(set.offset.1.into(), own[1]));
        // What is left of the cell is on both sides of the picture.
        let left = |cell: u32, length: Decimal| (Decimal::whole(cell.into()) - length).scaled(1, 2);
        let lower = Decimal::whole(side) - height;
        let (right, up) =
            if fits { (left(cell.0, width), lower - left(cell.1, height)) } else { (Decimal::ZERO, lower) };
        Self { x: x + right, y: y + up, width, height, scale }
    }

    /// How much larger than its picture it is drawn, along the axis where that is more.
    fn zoom(&self) -> f64 {
        let along = |(to, from): (u32, u32)| f64::from(to) / f64::from(from.max(1));
        along(self.scale[0]).max(along(self.scale[1]))
    }

    fn moved(self, by: Spot) -> Self {
        Self { x: self.x + by.0, y: self.y + by.1, ..self }
    }

    fn corners(&self) -> (Spot, Spot) {
        ((self.x, self.y), (self.x + self.width, self.y + self.height))
    }

    /// The first cell and the number of cells, if it fills whole ones of this side.
    fn cells(&self, side: i64) -> Option<Block> {
        let whole = |v: Decimal| Some(v.raw() >> 16).filter(|pixels| Decimal::whole(*pixels) == v);
        let all = [whole(self.x)?, whole(self.y)?, whole(self.width)?, whole(self.height)?];
        let [x, y, width, height] = all.map(|v| (v / side) as i32);
        all.iter().all(|v| v % side == 0).then_some(((x, y), (width, height)))
    }
}

/// The cells that a tile is drawn on, relative to its own: the first one, columns and rows. Those
/// whose middle it covers, and at least one.
pub(super) fn drawn_on(map: &Map, placed: &Placed, tile: u16) -> Block {
    let side = i64::from(tile);
    let &Placed::Tile { tileset, id, flip, moved } = placed else { return ((0, 0), (1, 1)) };
    let (from, to) = Frame::of(map, &map.tilesets[tileset], id, flip, side).moved(moved).corners();
    let side = side.max(1) << 16;
    let along = |from: Decimal, to: Decimal| {
        let middle = |v: Decimal| (v.raw() + side / 2 - 1).div_euclid(side);
        let (first, end) = (middle(from), middle(to));
        if first < end { (first as i32, (end - first) as i32) } else { (0, 1) }
    };
    let (columns, rows) = (along(from.0, to.0), along(from.1, to.1));
    ((columns.0, rows.0), (columns.1, rows.1))
}

/// Whether the picture of a tile is larger than a cell of the file.
pub(super) fn is_large(map: &Map, placed: &Placed, tile: u16) -> bool {
    let &Placed::Tile { tileset, id, flip, .. } = placed else { return false };
    let frame = Frame::of(map, &map.tilesets[tileset], id, flip, i64::from(tile));
    let along = |cells: u32| Decimal::whole(i64::from(tile) * i64::from(cells));
    !map.values && (frame.width > along(map.grid.0) || frame.height > along(map.grid.1))
}

/// The cells that a cell of the file is, relative to the one with its tile: the lower left one.
pub(super) fn own_cells(map: &Map) -> Block {
    let (columns, rows) = (map.grid.0 as i32, map.grid.1 as i32);
    ((0, 1 - rows), (columns, rows))
}

/// A shape of a tile in its cell of the file, however large its picture is.
pub(super) fn in_cell(map: &Map, shape: TileShape, tile: u16) -> Piece {
    let (at, size) = own_cells(map);
    if size == (1, 1) {
        return Piece::Shape(shape);
    }
    if shape == TileShape::Full {
        return Piece::Cells { at, size, beside: Vec::new() };
    }
    let pixels = |cells: i32| i64::from(cells) * i64::from(tile);
    let frame = Frame { y: Decimal::whole(pixels(at.1)), ..Frame::new(pixels(size.0), pixels(size.1)) };
    Piece::Paths(stretched(shape, frame))
}

/// The area that a tile of a layer with cells of `tile` pixels fills. Welds drawn corners by up to
/// `weld` raw units.
pub(super) fn of(
    map: &Map,
    placed: &Placed,
    solid: Solid,
    tile: u16,
    likeness: &Likeness,
    (unit, weld): (Unit, i64),
) -> Piece {
    let side = i64::from(tile);
    let cell = Frame::new(side, side).corners();
    let &Placed::Tile { tileset, id, flip, moved } = placed else {
        return if let Solid::Shape(shape) = solid { Piece::Shape(shape) } else { Piece::Paths(Vec::new()) };
    };
    let set = &map.tilesets[tileset];
    let frame = Frame::of(map, set, id, flip, side).moved(moved);
    match solid {
        Solid::Shape(shape) if frame.corners() == cell => Piece::Shape(shape),
        Solid::Shape(shape) => match frame.cells(side).filter(|_| shape == TileShape::Full) {
            Some((at, size)) => Piece::Cells { at, size, beside: Vec::new() },
            None => Piece::Paths(stretched(shape, frame)),
        },
        Solid::Drawn | Solid::Edges(_) => {
            let shapes = set.tiles.get(&id).map(|tile| tile.shapes.as_slice()).unwrap_or_default();
            // A tile that is drawn as large as a cell scales its shapes with it.
            let (w, h) = set.size_of(id);
            let size = if w == 0 || h == 0 { (side, side) } else { (i64::from(w), i64::from(h)) };
            let mut paths: Vec<Path> = shapes
                .iter()
                .filter(|shape| form::has_extent(shape))
                .flat_map(|shape| drawn(shape, size, flip, frame, unit.zoom() * frame.zoom()))
                .collect();
            if let Solid::Edges(side) = solid {
                paths = one_way(paths, side);
            }
            onto_border(&mut paths, frame, weld);
            // A small crossing does not make a polygon unlike a shape of the library.
            match if frame.corners() == cell { recognised(paths, side, likeness) } else { Piece::Paths(paths) } {
                Piece::Paths(paths) => Piece::Paths(untied(paths, frame, weld)),
                Piece::Cells { at, size, beside } => Piece::Cells { at, size, beside: untied(beside, frame, weld) },
                shape @ Piece::Shape(_) => shape,
            }
        }
    }
}

fn onto_border(paths: &mut [Path], frame: Frame, weld: i64) {
    for path in paths.iter_mut().filter(|path| path.error == 0) {
        path.welded += weld::onto_border(&mut path.points, path.closed, frame.corners(), weld);
    }
}

/// Takes polygons that cross themselves apart.
fn untied(paths: Vec<Path>, frame: Frame, weld: i64) -> Vec<Path> {
    let apart = |path: Path| match knots::of(&raw(&path.points)) {
        Knot::Parts(parts) if path.closed && path.kind.has_area() => {
            let mut parts = path.parts(parts);
            onto_border(&mut parts, frame, weld);
            parts
        }
        _ => vec![path],
    };
    paths.into_iter().flat_map(apart).collect()
}

/// A shape of the library as a path.
pub(super) fn as_path(shape: TileShape, tile: u16) -> Vec<Path> {
    stretched(shape, Frame::new(tile.into(), tile.into()))
}

/// So many full columns and rows as a path, from this cell on.
pub(super) fn block(at: (i32, i32), size: (i32, i32), tile: u16) -> Vec<Path> {
    let pixels = |cells: i32| i64::from(cells) * i64::from(tile);
    let (x, y) = (Decimal::whole(pixels(at.0)), Decimal::whole(pixels(at.1)));
    stretched(TileShape::Full, Frame { x, y, ..Frame::new(pixels(size.0), pixels(size.1)) })
}

/// A shape of the library in a box. Arcs become chords.
fn stretched(shape: TileShape, frame: Frame) -> Vec<Path> {
    // Exact for all corners, which are at halves of a cell.
    const SIDE: u16 = 64;
    let lines = likeness::outline(shape, SIDE);
    let place = |(x, y): (f64, f64)| {
        let along =
            |v: f64, from: Decimal, length: Decimal| from + Decimal::from_f64(v * length.to_f64() / f64::from(SIDE));
        (along(x, frame.x, frame.width), along(y, frame.y, frame.height))
    };
    // The library promises no order of faces. Each begins where another one ends.
    let mut rest = lines;
    let Some(first) = rest.pop() else { return Vec::new() };
    let (mut points, mut end) = (vec![first.0], first.1);
    while let Some(next) = rest.iter().position(|line| near(line.0, end) || near(line.1, end)) {
        let line = rest.swap_remove(next);
        points.push(end);
        end = if near(line.0, end) { line.1 } else { line.0 };
    }
    let closed = !names::is_one_way(shape);
    if !closed {
        points.push(end);
    }
    let kind = if closed { Kind::Solid } else { Kind::OneWay };
    vec![Path { kind, closed, points: points.into_iter().map(place).collect(), error: 0, welded: 0, torn: false }]
}

fn near(a: (f64, f64), b: (f64, f64)) -> bool {
    (a.0 - b.0).abs() + (a.1 - b.1).abs() < 1e-6
}

/// A shape of the collision editor, drawn on a tile of this size, relative to the tile. A one-way
/// shape is each chain of its edges that face up. In the output it is this many times larger.
pub(super) fn drawn(object: &Object, (w, h): (i64, i64), flip: Flip, frame: Frame, zoom: f64) -> Vec<Path> {
    let corners = form::enlarged(object, zoom).filter(|_| !senses(&object.class, &object.properties));
    let Some(form::Corners { mut points, closed, error }) = corners else { return Vec::new() };
    let own = [object.class.as_str(), object.name.as_str()].into_iter().chain(object.properties.marks());
    let kinds: Vec<Kind> = own.filter_map(Kind::from_name).collect();
    let one_way = kinds.iter().copied().find(|kind| *kind == Kind::OneWay);
    let kind = match one_way.or(kinds.first().copied()) {
        Some(Kind::OneWay) => Kind::OneWay,
        Some(Kind::Hole) if closed => Kind::Hole,
        // A wall's own area is solid, if it has an inside.
        _ if closed => Kind::Solid,
        _ => Kind::Wall,
    };
    let chains = match kind {
        Kind::OneWay if closed => edges::facing(&points, TileShape::OneWayUp),
        Kind::OneWay => {
            edges::upward(&mut points);
            vec![points]
        }
        _ => vec![points],
    };
    let closed = closed && kind != Kind::OneWay;
    let (across, down) = if flip.diagonal { (h, w) } else { (w, h) };
    let place = |(x, y): Spot| {
        let (x, y) = if flip.diagonal { (y, x) } else { (x, y) };
        let x = if flip.horizontal { Decimal::whole(across) - x } else { x };
        let y = if flip.vertical { Decimal::whole(down) - y } else { y };
        let [across, down] = frame.scale;
        (frame.x + x.scaled(across.0, across.1), frame.y + y.scaled(down.0, down.1))
    };
    let placed = |chain: Vec<Spot>| {
        let mut points: Vec<Spot> = chain.into_iter().map(place).collect();
        // A mirrored chain would block from its other side.
        if flip.diagonal ^ flip.horizontal ^ flip.vertical {
            points.reverse();
        }
        Path { kind, closed, points, error, welded: 0, torn: false }
    };
    chains.into_iter().map(placed).collect()
}

/// One-way edges in place of solids: those that face a side.
pub(super) fn one_way(paths: Vec<Path>, side: TileShape) -> Vec<Path> {
    let edges = |path: Path| {
        let chains = match path.kind {
            Kind::OneWay => return vec![path],
            Kind::Hole => Vec::new(),
            Kind::Solid | Kind::Wall if path.closed => edges::facing(&path.points, side),
            Kind::Solid | Kind::Wall => {
                let mut points = path.points.clone();
                edges::upward(&mut points);
                vec![points]
            }
        };
        let chain = |points| Path { kind: Kind::OneWay, closed: false, points, ..path.clone() };
        chains.into_iter().map(chain).collect()
    };
    paths.into_iter().flat_map(edges).collect()
}

/// A tile with more corners is not a shape of the library.
const MOST_CORNERS: usize = 128;

/// The union of the shapes of a tile.
fn recognised(paths: Vec<Path>, side: i64, likeness: &Likeness) -> Piece {
    if paths.iter().map(|path| path.points.len()).sum::<usize>() > MOST_CORNERS {
        return Piece::Paths(paths);
    }
    let pixels = |points: &[Spot]| points.iter().map(|(x, y)| (x.to_f64(), y.to_f64())).collect::<Vec<_>>();
    let solid = |path: &Path| path.kind == Kind::Solid && path.closed;
    let full = |path: &Path| solid(path) && likeness.solid(&pixels(&path.points)) == Some(TileShape::Full);
    // A hole takes a part of the cell away.
    if paths.iter().any(full) && !paths.iter().any(|path| path.kind == Kind::Hole) {
        let beside: Vec<Path> = paths.into_iter().filter(|path| !full(path) && !is_within(path, side)).collect();
        if beside.is_empty() {
            return Piece::Shape(TileShape::Full);
        }
        return Piece::Cells { at: (0, 0), size: (1, 1), beside };
    }
    if let [path] = &paths[..] {
        let shape = if solid(path) {
            likeness.solid(&pixels(&path.points))
        } else if path.kind == Kind::OneWay && !path.closed {
            likeness.one_way(&pixels(&path.points)).filter(|shape| runs_along(&path.points, *shape))
        } else {
            None
        };
        return shape.map_or(Piece::Paths(paths), Piece::Shape);
    }
    if !paths.is_empty() && paths.iter().all(solid) {
        let all: Vec<Vec<(i64, i64)>> = paths.iter().map(|path| raw(&path.points)).collect();
        let parts = boxes(&all).unwrap_or(all);
        if let [only] = &union(&parts)[..] {
            let points: Vec<(f64, f64)> =
                only.points.iter().map(|p| (p.0 as f64 / 65536.0, p.1 as f64 / 65536.0)).collect();
            if let Some(shape) = likeness.solid(&points) {
                return Piece::Shape(shape);
            }
        }
    }
    Piece::Paths(paths)
}

/// Whether all of a path is in the cell.
fn is_within(path: &Path, side: i64) -> bool {
    let cell = Decimal::ZERO..=Decimal::whole(side);
    path.points.iter().all(|(x, y)| cell.contains(x) && cell.contains(y))
}

/// Whether a chain on an edge of the cell is drawn in the direction that blocks from outside.
fn runs_along(points: &[Spot], shape: TileShape) -> bool {
    let (Some(first), Some(last)) = (points.first(), points.last()) else { return false };
    let (x, y) = (last.0 - first.0, last.1 - first.1);
    match shape {
        TileShape::OneWayUp => x > Decimal::ZERO,
        TileShape::OneWayRight => y > Decimal::ZERO,
        TileShape::OneWayDown => x < Decimal::ZERO,
        _ => y < Decimal::ZERO,
    }
}

/// Splits rectangles that can overlap into disjoint ones. `None` if one is not a rectangle.
fn boxes(polygons: &[Vec<(i64, i64)>]) -> Option<Vec<Vec<(i64, i64)>>> {
    let span = |points: &[(i64, i64)], of: fn(&(i64, i64)) -> i64| {
        Some((points.iter().map(of).min()?, points.iter().map(of).max()?))
    };
    let mut all = Vec::new();
    for points in polygons {
        let ((left, right), (top, bottom)) = (span(points, |p| p.0)?, span(points, |p| p.1)?);
        let area = i128::from(right - left) * i128::from(bottom - top);
        if points.len() != 4 || doubled_area(points).abs() != 2 * area {
            return None;
        }
        all.push((left, right, top, bottom));
    }
    let sorted = |of: fn(&(i64, i64, i64, i64)) -> [i64; 2]| {
        let mut values: Vec<i64> = all.iter().flat_map(of).collect();
        values.sort_unstable();
        values.dedup();
        values
    };
    let (columns, rows) = (sorted(|b| [b.0, b.1]), sorted(|b| [b.2, b.3]));
    let mut parts = Vec::new();
    for y in rows.windows(2) {
        for x in columns.windows(2) {
            if all.iter().any(|b| b.0 <= x[0] && x[1] <= b.1 && b.2 <= y[0] && y[1] <= b.3) {
                parts.push(vec![(x[0], y[0]), (x[1], y[0]), (x[1], y[1]), (x[0], y[1])]);
            }
        }
    }
    Some(parts)
}
