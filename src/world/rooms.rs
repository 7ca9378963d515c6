//! Worlds larger than the coordinates allow: rooms with separate coordinates, and the change from
//! one to the next.

use super::cell::Cell;
use super::error::TileMapError;
use super::grid::Grid;
use super::tile_map::kind::TileKinds;
use super::tile_map::{AllShapes, Outside, ShapeSet, TileMap};
use crate::num::{DOMAIN, Fx, Raw, Vec2};

/// A part of a world, as a level with its own coordinates: its tiles, and around them an apron of
/// its neighbours' tiles.
///
/// ```text
///      apron
///    +---------------------+
///    |  +---------------+  |     (0, 0) is the room's first corner;
///    |  |(0,0)          |  |     the apron left of it and above it has negative coordinates.
///    |  |     room    []|[]|     A body that has left the room is still in its map. In the next
///    |  |               |  |     room it is at the same place, by other coordinates.
///    |  +---------------+  |
///    +---------------------+
/// ```
///
/// The border affects no body. If the apron is [wide enough](Self::apron_for), a motion in the
/// room's map gives the same bits as in a map of the whole world. A body may move to the next room
/// in any frame in which the apron still holds it.
///
/// The rooms of a [`Rooms`] are equal, and are made on demand. Rooms of any rectangles are a slice:
///
/// ```
/// use tilesat::{AllShapes, Fx, Grid, Room, TileKind, TileKinds, TileMap, TileMapError, Vec2};
/// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
/// // A hall of 4 x 2 cells, and to its right a chamber of 1 x 2, each with an apron of one cell.
/// let map = |rows, width| {
///     let grid = Grid::new(width, 4, Fx::from_num(16), Vec2::ZERO)?;
///     TileMap::<AllShapes>::of(rows, grid, &KINDS)
/// };
/// let rooms = [
///     Room::new(map(b"#######....##.....######", 6)?, 0, 0, 1)?,
///     Room::new(map(b"###..#..####", 3)?, 4, 0, 1)?,
/// ];
/// let place = Vec2::from_ints(66, 20); // beyond the hall, in its apron
/// let (next, by) = rooms[0].next_of(&rooms, place).unwrap();
/// assert_eq!((next.first(), place + by), ((4, 0), Vec2::from_ints(2, 20)));
/// # Ok::<(), TileMapError>(())
/// ```
#[derive(Clone, Copy, Debug)]
#[doc(alias("chunk", "screen"))]
pub struct Room<'a, S: ShapeSet = AllShapes> {
    map: TileMap<'a, S>,
    /// The cell of the world that is the room's first.
    x: i32,
    y: i32,
    width: u16,
    height: u16,
}

impl<'a, S: ShapeSet> Room<'a, S> {
    /// A room of a map with an apron of `apron` cells on each side.
    ///
    /// Its first cell is the cell (`x`, `y`) of a world. The origin of the map is ignored. At the
    /// end of the world, [`Outside`] fills the apron.
    ///
    /// # Errors
    /// [`TileMapError::EmptyMap`] if the apron leaves nothing, [`TileMapError::OutOfDomain`] if the
    /// map is too large.
    pub const fn new(map: TileMap<'a, S>, x: i32, y: i32, apron: u16) -> Result<Self, TileMapError> {
        let twice = 2 * apron as u32;
        if map.width() as u32 <= twice || map.height() as u32 <= twice {
            return Err(TileMapError::EmptyMap);
        }
        let (width, height) = (map.width() - twice as u16, map.height() - twice as u16);
        // Within the sides of the map, which are below 2^30.
        let before = -(apron as i32).wrapping_mul(map.grid.cell);
        match map.with_origin(Vec2::from_raw(before, before)) {
            Ok(map) => Ok(Self { map, x, y, width, height }),
            Err(e) => Err(e),
        }
    }

    /// The least apron in cells for bodies whose width and height are at most `body` and whose
    /// motion per frame is at most `motion` long.
    ///
    /// Add the step and the snap of a [`Walker`](crate::Walker) to its motion. In a frame, a body
    /// reads the tiles that the closed box around its whole motion touches, or a box less than a
    /// unit larger. The position of a body in the room is its first corner, or any other point of
    /// it. So `apron * cell > body + motion + 1`. With one cell less, the border affects some
    /// bodies. A ray needs an apron as long as itself.
    ///
    /// ```
    /// use tilesat::{AllShapes, Fx, Room};
    /// let apron = Room::<AllShapes>::apron_for(Fx::from_num(16), Fx::from_num(20), Fx::from_num(12));
    /// assert_eq!(apron, 3); // 33 units reach into the third cell
    /// ```
    #[must_use]
    pub const fn apron_for(cell: Fx, body: Fx, motion: Fx) -> u16 {
        let reach = body.to_bits() as i64 + motion.to_bits() as i64 + Fx::ONE.to_bits() as i64;
        match reach.checked_div(cell.to_bits() as i64) {
            Some(cells) if 0 <= cells && cells < i16::MAX as i64 => cells as u16 + 1,
            _ => u16::MAX,
        }
    }

    /// The tiles of the room and of its apron.
    #[must_use]
    pub const fn map(&self) -> &TileMap<'a, S> {
        &self.map
    }

    /// Its first cell in the world.
    #[must_use]
    pub const fn first(&self) -> (i32, i32) {
        (self.x, self.y)
    }

    /// Columns, without the apron.
    #[must_use]
    pub const fn width(&self) -> u16 {
        self.width
    }

    /// Rows, without the apron.
    #[must_use]
    pub const fn height(&self) -> u16 {
        self.height
    }

    /// Whether a point is in the room, not in its apron.
    ///
    /// Left and upper borders belong to the room, right and lower ones to the next.
    #[must_use]
    pub const fn holds(&self, place: Vec2) -> bool {
        let (p, cell) = (Raw::of(place), self.map.grid.cell);
        // The sides are a part of the map's, which are below 2^30.
        let (width, height) = ((self.width as i32).wrapping_mul(cell), (self.height as i32).wrapping_mul(cell));
        0 <= p.x && p.x < width && 0 <= p.y && p.y < height
    }

    /// The cell of the world for a cell of the room's [map](Self::map), such as that of a hit.
    ///
    /// ```
    /// use tilesat::{AllShapes, Cell, Grid, Room, TileKind, TileKinds, TileMap, Vec2, fx};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
    /// let map = TileMap::<AllShapes>::of(b"###..####", Grid::new(3, 3, fx!(16), Vec2::ZERO)?, &KINDS)?;
    /// let room = Room::new(map, 40, 7, 1)?; // one cell with an apron of one
    /// assert_eq!(room.in_world(Cell::new(1, 1)), (40, 7));
    /// assert!(room.holds(Vec2::from_ints(0, 15)) && !room.holds(Vec2::from_ints(16, 0)));
    /// # Ok::<(), tilesat::TileMapError>(())
    /// ```
    #[must_use]
    pub const fn in_world(&self, cell: Cell) -> (i32, i32) {
        let (left, above) = self.apron_before();
        (self.x.wrapping_add(cell.x as i32 - left), self.y.wrapping_add(cell.y as i32 - above))
    }

    /// The columns and rows of the apron before the first cell.
    const fn apron_before(&self) -> (i32, i32) {
        // The origin is not above 0 and not below the domain.
        let Raw { x, y } = Raw::of(self.map.origin());
        let grid = &self.map.grid;
        (grid.quotient(x.unsigned_abs()) as i32, grid.quotient(y.unsigned_abs()) as i32)
    }

    /// The room of a slice that holds a point of this room.
    ///
    /// Also returns the vector to add to all positions of the body that changes rooms. If no room
    /// holds the point, the nearest one is returned (by the sum of the distances along x and y). So
    /// a hero may jump over the top of one room into the next. `None` if that is this room. Do not
    /// call it while [`holds`](Self::holds) is true: several rooms may hold the point.
    ///
    /// Cost: two products and some comparisons per room of the slice; no division.
    #[must_use]
    pub fn next_of<'r>(&self, rooms: &'r [Self], place: Vec2) -> Option<(&'r Self, Vec2)> {
        let all = rooms.iter().filter_map(|room| Some((room, self.way_to((room.x, room.y))?)));
        let nearest = all.min_by_key(|(room, by)| room.apart_from(place + *by))?;
        (nearest.0.first() != self.first()).then_some(nearest)
    }

    /// How far a point is from the room, along x and y together; 0 if the room holds it.
    fn apart_from(&self, place: Vec2) -> u64 {
        let (p, cell) = (Raw::of(place), self.map.grid.cell);
        let beyond = |at: i32, count: u16| {
            let last = i32::from(count).wrapping_mul(cell).wrapping_sub(1);
            u64::from(at.abs_diff(at.clamp(0, last)))
        };
        beyond(p.x, self.width).wrapping_add(beyond(p.y, self.height))
    }

    /// The vector to add to a point of this room to have it in one with this first cell. `None` if
    /// no coordinate can be that far.
    const fn way_to(&self, first: (i32, i32)) -> Option<Vec2> {
        match (apart(self.x, first.0, self.map.grid.cell), apart(self.y, first.1, self.map.grid.cell)) {
            (Some(x), Some(y)) => Some(Vec2::from_raw(x, y)),
            _ => None,
        }
    }
}

/// From one cell back to another, in raw, if that is less than the domain is long.
const fn apart(from: i32, to: i32, cell: i32) -> Option<i32> {
    // Below 2^33 and 2^24.
    let raw = (from as i64 - to as i64) * cell as i64;
    if -2 * (DOMAIN as i64) < raw && raw < 2 * DOMAIN as i64 { Some(raw as i32) } else { None }
}

/// A world of tiles, cut into equal rooms: one array of tiles, row after row, of up to 65 535
/// columns and rows.
///
/// A [`Room`] is a window of that array: its apron costs no flash and no memory. Outside of the
/// world, a room has the same [`Outside`] as a map of the whole.
///
/// ```
/// use tilesat::{Aabb, Axis, Blocks, Fx, Mover, Room, Rooms, TileKind, TileKinds, Vec2};
/// static KINDS: TileKinds = TileKinds::EMPTY.with(1, TileKind::FULL);
/// // 40 000 x 48 units: a floor of 2500 cells. A room is a screen of 320 units.
/// static TILES: [u8; 7500] = {
///     let mut tiles = [0; 7500];
///     let mut x = 5000;
///     while x < 7500 {
///         tiles[x] = 1;
///         x += 1;
///     }
///     tiles
/// };
/// const CELL: Fx = Fx::lit("16");
/// // For bodies of up to 16 units that move by up to 30 units per frame.
/// const APRON: u16 = Room::<Blocks>::apron_for(CELL, CELL, Fx::lit("30"));
/// let world = Rooms::<Blocks>::of(&TILES, (2500, 3), CELL, &KINDS, (20, 3), APRON)?;
/// assert_eq!((world.columns(), world.rows()), (125, 1));
///
/// let mover = Mover::platformer(Axis::NEG_Y);
/// let mut room = world.room(0, 0).unwrap();
/// let mut body = Aabb::new(Vec2::from_ints(2, 20), Vec2::from_ints(12, 32))?;
/// for _ in 0..1332 {
///     body = mover.move_and_slide(room.map(), &body, Vec2::from_ints(30, 1))?.body;
///     if let Some((next, by)) = world.next(&room, body.min()) {
///         (room, body) = (next, body.translated(by)?);
///     }
/// }
/// assert_eq!((room.first(), body.min()), ((2480, 0), Vec2::from_ints(282, 20))); // 39 962 units from the start
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
#[doc(alias("chunks", "streaming"))]
pub struct Rooms<'a, S: ShapeSet = AllShapes> {
    /// The map of each room, except for its grid.
    pattern: TileMap<'a, S>,
    world: (u16, u16),
    room: (u16, u16),
    apron: u16,
}

impl<'a, S: ShapeSet> Rooms<'a, S> {
    /// A world from its size and that of a room, both in columns and rows of cells.
    ///
    /// The last room of a row and of a column may be smaller.
    ///
    /// # Errors
    /// [`TileMapError`] if there are no cells, not enough tiles, or a cell or a shape that a map
    /// cannot have. Also if a room with its apron does not fit the [domain](crate::num::DOMAIN).
    pub const fn of(
        tiles: &'a [u8],
        world: (u16, u16),
        cell: Fx,
        kinds: &'a TileKinds,
        room: (u16, u16),
        apron: u16,
    ) -> Result<Self, TileMapError> {
        if world.0 == 0 || world.1 == 0 || room.0 == 0 || room.1 == 0 {
            return Err(TileMapError::EmptyMap);
        }
        let needed = world.0 as u32 * world.1 as u32;
        if (tiles.len() as u64) < needed as u64 {
            return Err(TileMapError::TooShort { needed, found: tiles.len() as u32 });
        }
        // The largest map that a room may have.
        let (width, height) = (with_apron(room.0, apron), with_apron(room.1, apron));
        if let Err(e) = Grid::new(width, height, cell, Vec2::ZERO) {
            return Err(e);
        }
        let pattern = match Grid::new(1, 1, cell, Vec2::ZERO) {
            Ok(one) => TileMap::build(tiles, one, world.0, kinds),
            Err(e) => Err(e),
        };
        match pattern {
            Ok(pattern) => Ok(Self { pattern, world, room, apron }),
            Err(e) => Err(e),
        }
    }

    /// Sets the outside of the world, which is empty at first.
    #[must_use]
    pub const fn with_outside(self, outside: Outside) -> Self {
        Self { pattern: self.pattern.with_outside(outside), ..self }
    }

    /// Rooms in a row.
    #[must_use]
    pub const fn columns(&self) -> u16 {
        quotient(self.world.0 - 1, self.room.0) + 1
    }

    /// Rows of rooms.
    #[must_use]
    pub const fn rows(&self) -> u16 {
        quotient(self.world.1 - 1, self.room.1) + 1
    }

    /// A room by its index among the rooms; `None` beyond the world.
    ///
    /// Cost: that of [`Grid::new`]. Keep the room while the body is in it. It takes 72 bytes on a
    /// 32-bit core.
    #[must_use]
    pub const fn room(&self, column: u16, row: u16) -> Option<Room<'a, S>> {
        let x = RoomAxis::of(column, self.room.0, self.world.0, self.apron);
        let y = RoomAxis::of(row, self.room.1, self.world.1, self.apron);
        let (Some(x), Some(y)) = (x, y) else { return None };
        let cell = self.pattern.grid.cell;
        // At most as far from 0 as the largest map is long.
        let origin = Raw { x: -x.before.wrapping_mul(cell), y: -y.before.wrapping_mul(cell) };
        let first = (y.first - y.before) as u32 * self.world.0 as u32 + (x.first - x.before) as u32;
        match (
            Grid::new(x.cells, y.cells, self.pattern.grid.cell(), origin.vec2()),
            self.pattern.data.split_at_checked(first as usize),
        ) {
            (Ok(grid), Some((_, data))) => {
                let map = TileMap { data, grid, ..self.pattern };
                Some(Room { map, x: x.first, y: y.first, width: x.own, height: y.own })
            }
            _ => None,
        }
    }

    /// The room that holds a cell of the world, and that cell in the room's map.
    ///
    /// Use it for a spawn or a door of the world. `None` beyond the world. Points of a world are
    /// cells, because a coordinate ends at 8192 units, and a world may not. [`Grid::bounds_of`]
    /// gives the cell's box in the room's coordinates. [`Room::in_world`] is the inverse.
    ///
    /// Cost: two 32-bit divisions and a [`room`](Self::room).
    ///
    /// ```
    /// use tilesat::{Blocks, Cell, Rooms, TileKinds, Vec2, fx};
    /// static KINDS: TileKinds = TileKinds::EMPTY;
    /// let tiles = [0; 4800]; // 40 000 units of cells, in rooms of 320 with an apron of two cells
    /// let world = Rooms::<Blocks>::of(&tiles, (2400, 2), fx!(16), &KINDS, (20, 2), 2)?;
    /// let (room, cell) = world.at((2007, 1)).unwrap();
    /// assert_eq!((room.first(), room.in_world(cell)), ((2000, 0), (2007, 1)));
    /// let spawn = room.map().grid().bounds_of(cell).unwrap();
    /// assert_eq!(spawn.min(), Vec2::from_ints(7 * 16, 16));
    /// assert!(world.at((2400, 0)).is_none());
    /// # Ok::<(), tilesat::TileMapError>(())
    /// ```
    #[must_use]
    pub const fn at(&self, cell: (i32, i32)) -> Option<(Room<'a, S>, Cell)> {
        let (x, y) = cell;
        if x < 0 || y < 0 || x >= self.world.0 as i32 || y >= self.world.1 as i32 {
            return None;
        }
        match self.room(quotient(x as u16, self.room.0), quotient(y as u16, self.room.1)) {
            Some(room) => {
                let (left, above) = room.apron_before();
                let cell = Cell::of(x.wrapping_sub(room.x) + left, y.wrapping_sub(room.y) + above);
                Some((room, cell))
            }
            None => None,
        }
    }

    /// The room that holds a point which has left the given room.
    ///
    /// Also returns the vector to add to all positions of the body that changes rooms. `None` while
    /// the point is still in the room. A point beyond an end of the world counts as one at that
    /// end. So a hero may run on top of the uppermost tiles, from room to room.
    ///
    /// Cost: four comparisons if it is still in the room. Otherwise four 32-bit divisions and a
    /// [`room`](Self::room), independent of the size of the world.
    #[must_use]
    pub const fn next(&self, room: &Room<'_, S>, place: Vec2) -> Option<(Room<'a, S>, Vec2)> {
        if room.holds(place) {
            return None;
        }
        let (p, cell) = (Raw::of(place), self.pattern.grid.cell);
        let column = index(room.x, p.x, cell, self.world.0, self.room.0);
        let row = index(room.y, p.y, cell, self.world.1, self.room.1);
        match self.room(column, row) {
            Some(next) if next.x == room.x && next.y == room.y => None,
            Some(next) => match room.way_to((next.x, next.y)) {
                Some(by) => Some((next, by)),
                None => None,
            },
            None => None,
        }
    }
}

/// One axis of a room's map, in cells of the world.
struct RoomAxis {
    /// In the room.
    first: i32,
    own: u16,
    /// In the apron before it.
    before: i32,
    /// In the map.
    cells: u16,
}

impl RoomAxis {
    const fn of(index: u16, room: u16, world: u16, apron: u16) -> Option<Self> {
        // Below 2^31: a room has at most 32 767 cells.
        let (first, world) = (index as i32 * room as i32, world as i32);
        if first >= world {
            return None;
        }
        let end = least(first + room as i32, world);
        let before = least(first, apron as i32);
        let cells = least(end + apron as i32, world) - (first - before);
        Some(Self { first, own: (end - first) as u16, before, cells: cells as u16 })
    }
}

const fn least(a: i32, b: i32) -> i32 {
    if a < b { a } else { b }
}

/// The width with both aprons. It saturates at a width that no map accepts.
const fn with_apron(room: u16, apron: u16) -> u16 {
    room.saturating_add(apron).saturating_add(apron)
}

/// Which room of an axis holds a coordinate of a room with this first cell, or is nearest to it.
const fn index(first: i32, at: i32, cell: i32, world: u16, room: u16) -> u16 {
    // A cell has a length, and a world has a cell.
    let cells = match at.checked_div_euclid(cell) {
        Some(cells) => cells,
        None => 0,
    };
    let (cell, last) = (first.saturating_add(cells), world.saturating_sub(1));
    quotient(if cell < 0 { 0 } else { least(cell, last as i32) as u16 }, room)
}

/// How many whole rooms fit in these cells: the index of the room of the cell after them. A divisor
/// is never 0.
const fn quotient(cells: u16, room: u16) -> u16 {
    match cells.checked_div(room) {
        Some(quotient) => quotient,
        None => 0,
    }
}
