//! Worlds larger than the coordinates of the library, in rooms. The borders do not affect bodies.
//!
//! A map is cut into equal rooms, which are windows of its tiles ([`tilesat::Rooms`]). The levels
//! of an `LDtk` project and the maps of a world of Tiled are rooms at their position in the world
//! ([`tilesat::Room`]). Each has an apron of its neighbours' tiles. Every room gets whole copies of
//! the polygons that reach it: cut polygons would have corners that nobody drew.

mod objects;
mod part;
mod segments;
mod source;

use tilesat::{AllShapes, Fx, Grid, Room, Rooms, TileKind, TileKinds, TileMap, TileMapError, Vec2};

use crate::bake::level::Ids;
use crate::fail::{Fail, Result};
use crate::model::map::Map;
use crate::rules::flags::Flags;
use crate::rules::ground::Drawn;
use crate::rules::options::{Options, listed, together};
use crate::rules::outline::LeftOut;
use part::Part;

/// How to cut a world, and for which body.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Cut {
    /// Columns and rows of a room, for a map. The levels of a project are already rooms.
    pub room: Option<(u16, u16)>,
    /// The longer side of the largest body. One cell by default.
    pub body: Option<Fx>,
    /// The longest motion per frame, with a walker's step and snap. One cell by default.
    pub motion: Option<Fx>,
}

/// A world in rooms, baked.
#[derive(Debug, Clone)]
pub struct World {
    /// Side of a cell in pixels.
    pub cell: u16,
    /// In cells.
    pub apron: u16,
    pub kinds: Vec<TileKind>,
    pub flags: Vec<String>,
    pub rooms: Vec<Baked>,
    /// What the rooms are windows of, where they are.
    pub whole: Option<Whole>,
    /// Drawings that are in no output.
    pub unused: Vec<String>,
    /// What the author probably did not intend: a line each.
    pub warnings: Vec<String>,
    pub notes: Vec<String>,
}

/// The tiles of a world of equal rooms.
#[derive(Debug, Clone)]
pub struct Whole {
    pub width: u16,
    pub height: u16,
    pub tiles: Vec<u8>,
    /// Columns and rows of a room.
    pub room: (u16, u16),
}

/// A room.
#[derive(Debug, Clone)]
pub struct Baked {
    pub name: String,
    /// The number of its world in a project, and its depth there.
    pub plane: (usize, i32),
    /// Its first cell in the world.
    pub first: (i32, i32),
    pub size: (u16, u16),
    /// With the apron, row by row. Empty if the room is a window.
    pub tiles: Vec<u8>,
    /// The bytes of its polygons.
    pub segments: Option<Vec<u8>>,
    /// Objects for the game, in coordinates of the room.
    pub objects: Vec<LeftOut>,
}

/// Bakes maps as rooms of one world.
///
/// # Errors
///
/// One line that names the level or object that does not fit, and how to fix it.
pub fn bake(maps: &[Map], options: &Options, cut: &Cut) -> Result<World> {
    if cut.room.is_some() && maps.len() > 1 {
        return Err(Fail::new("--room is for one map: the levels of a project are rooms already"));
    }
    let options = Options { rooms: true, ..options.clone() };
    let all: Vec<&Map> = maps.iter().filter(|map| !listed(&options.ignored_levels, &map.name)).collect();
    let made = |options: &Options| {
        let mut flags = Flags::new(&options.flags).map_err(Fail::new)?;
        let mut ids = Ids::default();
        let of_level = |map: &Map, fail: Fail| fail.of_level(&map.name, true);
        let drawn = Drawn::all(&all, options, of_level)?;
        let part = |(map, drawn): (&&Map, Drawn<'_>)| {
            Part::of(map, drawn, options, (&mut flags, &mut ids)).map_err(|fail| of_level(map, fail))
        };
        let parts: Vec<Part> = all.iter().zip(drawn).map(part).collect::<Result<_>>()?;
        Ok((parts, flags, ids))
    };
    let is_solid = |(parts, ..): &(Vec<Part>, Flags, Ids)| parts.iter().any(|part| part.is_solid);
    let (mut parts, mut flags, ids) = together(all.len(), &options, made, is_solid)?;
    let Some(cell) = parts.first().map(|part| part.cell) else {
        return Err(Fail::new("every level is skipped: remove an --ignore-level"));
    };
    if let Some(other) = parts.iter().find(|part| part.cell != cell) {
        let why = "rooms of one world have cells of one size: give all maps the same Tile Width in Tiled, all layers \
                   with solids the same grid in LDtk, or --ignore-level skips one";
        return Err(Fail::new(format!(
            "level '{}' has cells of {} pixels, the first {cell}: {why}",
            other.name, other.cell
        )));
    }
    // The rooms into which a body can cross are neighbours in the table.
    parts.sort_by_key(|part| part.plane);
    let side = Fx::from_num(cell);
    let apron = Room::<AllShapes>::apron_for(side, cut.body.unwrap_or(side), cut.motion.unwrap_or(side));
    let (mut rooms, whole) = match (&parts[..], cut.room) {
        ([part], Some(room)) => {
            let whole = part.whole(room)?;
            (part.equal(room)?, Some(whole))
        }
        ([part], None) if !part.placed => {
            return Err(Fail::new("the size of a room is missing: add --room WxH, in cells"));
        }
        (parts, _) => {
            Part::apart(parts)?;
            (parts.iter().map(|part| part.alone(parts, apron)).collect::<Result<_>>()?, None)
        }
    };
    let unused = objects::share(&parts, &mut rooms, cell);
    let (warnings, notes) = (Part::told(&parts, |part| &part.warnings), Part::told(&parts, |part| &part.notes));
    let kinds = ids.kinds().to_vec();
    let mut world = World { cell, apron, kinds, flags: Vec::new(), rooms, whole, unused, warnings, notes };
    for room in &mut world.rooms {
        let of_room = |fail: Fail| Fail::new(format!("room '{}': {fail}", room.name));
        room.segments = segments::of(&parts, room, cell, apron, &mut flags).map_err(of_room)?;
    }
    world.warnings.extend(flags.warning());
    world.unused.extend(flags.dropped.iter().map(|name| format!("flag {name}")));
    world.flags = flags.names;
    world.check()?;
    Ok(world)
}

impl World {
    /// Reports the compiler's errors about the source early.
    fn check(&self) -> Result<()> {
        let kinds = self.kinds.iter().zip(0..).fold(TileKinds::EMPTY, |kinds, (kind, id)| kinds.with(id, *kind));
        let cell = Fx::from_num(self.cell);
        let said = |e: TileMapError| Fail::new(format!("a room with its apron of {} cells: {e}", self.apron));
        if let Some(Whole { width, height, tiles, room }) = &self.whole {
            Rooms::<AllShapes>::of(tiles, (*width, *height), cell, &kinds, *room, self.apron).map_err(said)?;
        }
        for room in self.rooms.iter().filter(|_| self.whole.is_none()) {
            let side = |cells: u16| cells.saturating_add(self.apron).saturating_add(self.apron);
            let grid = Grid::new(side(room.size.0), side(room.size.1), cell, Vec2::ZERO).map_err(said)?;
            let map = TileMap::<AllShapes>::of(&room.tiles, grid, &kinds).map_err(said)?;
            Room::new(map, room.first.0, room.first.1, self.apron).map_err(said)?;
        }
        Ok(())
    }

    /// Rust source: the static `ROOMS`, the table of kinds for all rooms, and their polygons.
    pub fn source(&self) -> String {
        source::source(self)
    }

    /// Its cost, line by line.
    pub fn report(&self) -> Vec<String> {
        let tiles = self.whole.as_ref().map_or(0, |whole| whole.tiles.len());
        let tiles = tiles + self.rooms.iter().map(|room| room.tiles.len()).sum::<usize>();
        let with = self.rooms.iter().filter_map(|room| room.segments.as_ref());
        let (count, bytes) = with.fold((0, 0), |(count, bytes), of_room| (count + 1, bytes + of_room.len()));
        let mut lines = vec![
            format!("rooms   {} of cells of {} px, with an apron of {} cells", self.rooms.len(), self.cell, self.apron),
            format!("flash   {tiles} bytes of tiles, {} of kinds", size_of::<tilesat::TileKinds>()),
        ];
        if count > 0 {
            lines.push(format!("objects in {count} rooms, {bytes} bytes"));
        }
        let listed: usize = self.rooms.iter().map(|room| room.objects.len()).sum();
        if listed > 0 {
            lines.push(format!("OBJECTS {listed} for the game"));
        }
        lines.extend(self.unused.iter().map(|what| format!("ignored {what}")));
        lines
    }
}
