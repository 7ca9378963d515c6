//! A level of a world: its position, its tiles, and its rooms.

use super::{Baked, Whole};
use crate::bake::level::{Ids, Level};
use crate::bake::segments;
use crate::fail::{Fail, Result};
use crate::model::map::{Map, Place};
use crate::rules::flags::Flags;
use crate::rules::ground::Drawn;
use crate::rules::options::Options;
use crate::rules::outline::{LeftOut, Outline};

/// The library's domain in pixels (contract C1).
const DOMAIN: i64 = 8192;
/// The most tiles of a world, a byte each.
const MAX_TILES: u64 = 1 << 26;
const MAX_ROOMS: usize = 1 << 16;

/// Cells: the first ones, columns and rows.
type Rectangle = (i64, i64, i64, i64);

pub(super) struct Part {
    pub name: String,
    /// In pixels.
    pub cell: u16,
    /// Only levels of one plane are neighbours.
    pub plane: (usize, i32),
    pub is_solid: bool,
    /// Whether it has a position among others.
    pub placed: bool,
    /// The room, in cells of the world.
    room: Rectangle,
    /// The cells that its tiles cover, which can differ.
    covered: Rectangle,
    tiles: Vec<u8>,
    /// Whether its objects have ids of their own, as in a map of Tiled.
    pub own_ids: bool,
    /// In raw units of the world.
    pub outlines: Vec<Outline>,
    /// Objects for the game, in raw units of the world.
    pub objects: Vec<LeftOut>,
    /// What no output has.
    pub unused: Vec<String>,
    /// What its author probably did not intend.
    pub warnings: Vec<String>,
    pub notes: Vec<String>,
}

impl Part {
    pub(super) fn of(
        map: &Map,
        drawn: Drawn<'_>,
        options: &Options,
        (flags, ids): (&mut Flags, &mut Ids),
    ) -> Result<Self> {
        let mut ground = drawn.ground(flags)?;
        let repeated = segments::once(&mut ground.outlines);
        ground.notes.extend(repeated);
        segments::refuse_crossed(&ground.outlines)?;
        let warnings = ground.warnings();
        ground.left_out.retain(|object| !object.suspicious);
        let level = Level::with(&ground, &flags.names, ids)?;
        // In a linear world, LDtk puts all levels at (-1, -1).
        let place = map.place.filter(|place| !map.values || (place.x, place.y) != (-1, -1));
        let place = place.map(|place| scaled(place, options, ground.tile)).transpose()?;
        // Moves the ground until its first cell is at the origin.
        let shift = (i64::from(-ground.shift.0), i64::from(-ground.shift.1));
        let at =
            place.map_or((0, 0), |room| (room.0 + cells(shift.0, ground.tile), room.1 + cells(shift.1, ground.tile)));
        // The part of the offset of its cells that is less than a pixel.
        let rest = level.as_ref().map_or((0, 0), |_| (i64::from(ground.origin.0), i64::from(ground.origin.1)));
        let between = |pixels: i64, rest: i64| pixels % i64::from(ground.tile) != 0 || rest != 0;
        if place.is_some() && (between(shift.0, rest.0) || between(shift.1, rest.1)) {
            return Err(Fail::new(
                "its tiles are drawn between the cells of the world: remove the offset of its layers",
            ));
        }
        let size = level.as_ref().map_or((0, 0), |level| (i64::from(level.width), i64::from(level.height)));
        let covered = (at.0, at.1, size.0, size.1);
        let side = i64::from(ground.tile) << 16;
        // Rooms begin with a cell, and polygons and objects follow it.
        let by = (at.0 * side - rest.0, at.1 * side - rest.1);
        for point in ground.outlines.iter_mut().flat_map(|outline| &mut outline.points) {
            *point = (point.0 + by.0, point.1 + by.1);
        }
        ground.left_out.iter_mut().for_each(|object| object.shift(by));
        if place.is_none() && (shift, rest) != ((0, 0), (0, 0)) {
            let of_map = options.scale.map_or(1.0, |(n, d)| f64::from(d) / f64::from(n));
            let (x, y) = (pixels(shift.0, rest.0, of_map), pixels(shift.1, rest.1, of_map));
            ground.notes.push(format!("room (0, 0) begins at ({x}, {y}) of the map, with its first cell"));
        }
        // For a map without tiles, the map gives the size.
        let drawn = if level.is_some() { (0, 0) } else { (map.size.0.into(), map.size.1.into()) };
        let extent = extent(&ground.outlines, side, drawn);
        Ok(Self {
            is_solid: ground.is_solid(),
            name: ground.name,
            cell: ground.tile,
            plane: map.place.map_or((0, 0), |place| place.plane),
            placed: place.is_some(),
            room: place.unwrap_or((0, 0, size.0.max(extent.0), size.1.max(extent.1))),
            covered,
            own_ids: !map.values,
            tiles: level.map_or_else(Vec::new, |level| level.tiles),
            outlines: ground.outlines,
            objects: ground.left_out,
            unused: ground.unused,
            warnings,
            notes: ground.notes,
        })
    }

    /// Lines about the levels, each with the name of its level if there are several.
    pub(super) fn told(all: &[Self], lines: impl Fn(&Self) -> &[String]) -> Vec<String> {
        let titled = |part: &Self, line: &String| match all {
            [_] => line.clone(),
            _ => format!("level '{}': {line}", part.name),
        };
        all.iter().flat_map(|part| lines(part).iter().map(move |line| titled(part, line))).collect()
    }

    /// All tiles, for windows of them.
    pub(super) fn whole(&self, room: (u16, u16)) -> Result<Whole> {
        let (.., width, height) = self.room;
        let count = |cells: i64| {
            u16::try_from(cells).map_err(|_| {
                Fail::new(format!("{cells} cells on a side; a world has at most {}: bake its levels apart", u16::MAX))
            })
        };
        let (width, height) = (count(width)?, count(height)?);
        if u64::from(width) * u64::from(height) > MAX_TILES {
            return Err(Fail::new(format!(
                "{width}x{height} cells are more than {MAX_TILES}: no flash has room for them"
            )));
        }
        Ok(Whole { width, height, tiles: self.within((0, 0, width.into(), height.into())).collect(), room })
    }

    /// Its rooms of one size, row after row, without tiles.
    ///
    /// # Errors
    ///
    /// If there are too many.
    pub(super) fn equal(&self, (width, height): (u16, u16)) -> Result<Vec<Baked>> {
        let (.., columns, rows) = self.room;
        let count = (columns as usize).div_ceil(step(width)) * (rows as usize).div_ceil(step(height));
        if count > MAX_ROOMS {
            return Err(Fail::new(format!("{count} rooms of {width}x{height} cells are too many: use larger ones")));
        }
        let mut rooms = Vec::new();
        for (row, y) in (0..rows).step_by(step(height)).enumerate() {
            for (column, x) in (0..columns).step_by(step(width)).enumerate() {
                rooms.push(Baked {
                    name: format!("{column} {row}"),
                    plane: self.plane,
                    // A world has at most 65 535 cells per side.
                    first: (x as i32, y as i32),
                    size: ((columns - x).min(width.into()) as u16, (rows - y).min(height.into()) as u16),
                    tiles: Vec::new(),
                    segments: None,
                    objects: Vec::new(),
                });
            }
        }
        Ok(rooms)
    }

    /// The cells that two levels of one plane have in common, if they overlap.
    fn common(&self, other: &Self) -> Option<(i64, i64)> {
        let (a, b) = (self.room, other.room);
        let length = |(from, to): (i64, i64)| to - from;
        let size = (length(common((a.0, a.2), (b.0, b.2))), length(common((a.1, a.3), (b.1, b.3))));
        (self.placed && other.placed && self.plane == other.plane && size.0 > 0 && size.1 > 0).then_some(size)
    }

    /// Refuses levels over each other: a body there would be in two rooms.
    pub(super) fn apart(all: &[Self]) -> Result<()> {
        for (i, part) in all.iter().enumerate() {
            for other in &all[..i] {
                if let Some((width, height)) = part.common(other) {
                    return Err(Fail::new(format!(
                        "level '{}' and level '{}' share {width}x{height} cells: move one of them, give it another \
                         depth (worldDepth, in LDtk), or skip it with --ignore-level",
                        other.name, part.name
                    )));
                }
            }
        }
        Ok(())
    }

    /// Its room, with an apron of its neighbours' tiles.
    pub(super) fn alone(&self, all: &[Self], apron: u16) -> Result<Baked> {
        let of_level = |why: &str| Fail::new(format!("level '{}' {why}", self.name));
        if !self.placed {
            return Err(of_level("has no position: in a linear world levels have no neighbours, so bake them instead"));
        }
        let (x, y, width, height) = self.room;
        let apron = i64::from(apron);
        let side = (width.max(height) + 2 * apron) * i64::from(self.cell);
        if side >= DOMAIN || apron * i64::from(self.cell) >= DOMAIN {
            let why = format!("and an apron of {apron} cells are {side} pixels; a room has less than {DOMAIN}");
            return Err(of_level(&why));
        }
        let window = (x - apron, y - apron, width + 2 * apron, height + 2 * apron);
        let mut tiles: Vec<u8> = vec![0; (window.2 * window.3) as usize];
        for part in all.iter().filter(|part| part.plane == self.plane) {
            part.copy_into(&mut tiles, window);
        }
        let coordinate = |cells: i64| i32::try_from(cells).map_err(|_| of_level("lies too far away"));
        let count = |cells: i64| {
            u16::try_from(cells).ok().filter(|&count| count > 0).ok_or_else(|| of_level("is too large, or empty"))
        };
        Ok(Baked {
            name: self.name.clone(),
            plane: self.plane,
            first: (coordinate(x)?, coordinate(y)?),
            size: (count(width)?, count(height)?),
            tiles,
            segments: None,
            objects: Vec::new(),
        })
    }

    /// Its tiles in a window. Empty where it has none.
    fn within(&self, (x, y, width, height): Rectangle) -> impl Iterator<Item = u8> + '_ {
        let (x0, y0, columns, rows) = self.covered;
        let tile = move |x: i64, y: i64| {
            let (x, y) = (x - x0, y - y0);
            let inside = (0..columns).contains(&x) && (0..rows).contains(&y);
            if inside { self.tiles[(y * columns + x) as usize] } else { 0 }
        };
        (y..y + height).flat_map(move |y| (x..x + width).map(move |x| tile(x, y)))
    }

    /// Puts its tiles into a window, those of its room.
    fn copy_into(&self, tiles: &mut [u8], window: Rectangle) {
        let (from_x, to_x) = common((window.0, window.2), (self.room.0, self.room.2));
        let (from_y, to_y) = common((window.1, window.3), (self.room.1, self.room.3));
        // In rows that both have, a level far to the side begins behind the window.
        if from_x >= to_x {
            return;
        }
        for y in from_y..to_y {
            let row = self.within((from_x, y, to_x - from_x, 1));
            let place = ((y - window.1) * window.2 + from_x - window.0) as usize;
            row.zip(&mut tiles[place..]).for_each(|(tile, into)| *into = tile);
        }
    }
}

/// A step is not 0.
fn step(cells: u16) -> usize {
    usize::from(cells.max(1))
}

/// The common part of two ranges, each a start and a length.
fn common(a: (i64, i64), b: (i64, i64)) -> (i64, i64) {
    (a.0.max(b.0), (a.0 + a.1).min(b.0 + b.1))
}

/// Pixels times a factor, to a thousandth.
#[allow(clippy::cast_precision_loss, reason = "pixels of a map are below 2^24")]
fn pixels(whole: i64, rest: i64, factor: f64) -> f64 {
    ((whole as f64 + rest as f64 / 65536.0) * factor * 1000.0).round() / 1000.0
}

fn cells(pixels: i64, tile: u16) -> i64 {
    pixels.div_euclid(tile.into())
}

/// The cells up to the last point, or this many.
fn extent(outlines: &[Outline], side: i64, least: (i64, i64)) -> (i64, i64) {
    let cells = |raw: i64| (raw + side - 1).div_euclid(side);
    let points = outlines.iter().flat_map(|outline| &outline.points);
    points.fold(least, |most, p| (most.0.max(cells(p.0)), most.1.max(cells(p.1))))
}

/// A position in cells.
fn scaled(place: Place, options: &Options, tile: u16) -> Result<Rectangle> {
    let (n, d) = options.scale.unwrap_or((1, 1));
    let whole = |pixels: i64| {
        let (pixels, side) = (pixels * i64::from(n), i64::from(d) * i64::from(tile));
        let why = || {
            Fail::new(format!(
                "it begins or ends at {pixels} pixels, between cells of {side}: no body can pass there; move it in the editor"
            ))
        };
        if pixels % side == 0 { Ok(pixels / side) } else { Err(why()) }
    };
    Ok((whole(place.x.into())?, whole(place.y.into())?, whole(place.width.into())?, whole(place.height.into())?))
}
