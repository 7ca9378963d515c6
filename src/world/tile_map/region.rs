//! Which tiles lie in a region, and which flags a shape touches: for coins, ladders and spikes. All
//! tiles count, solid or not.

use super::{ShapeSet, Store, TileMap};
use crate::error::{RangeError, Truncated};
use crate::num::{DOMAIN, MOTION, Raw, Vec2, check_coordinate, check_motion};
use crate::shape::Aabb;
use crate::world::cell::{Cell, Range};
use crate::world::probes::Probe;
use crate::world::tile_map::kind::TileKind;
use crate::world::trail::Trail;
use heapless::VecView;

/// A tile of a map and its cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TileAt {
    /// The cell that it is in.
    pub cell: Cell,
    /// Its id.
    pub id: u8,
    /// Its kind in the map's table.
    pub kind: TileKind,
}

/// The tiles of a region, row after row; see [`TileMap::tiles_in`].
#[derive(Clone, Debug)]
#[must_use = "cursors do nothing unless advanced"]
pub struct Tiles<'w, S: ShapeSet, T: Store> {
    pub(crate) map: &'w TileMap<'w, S, T>,
    range: Range,
    x: i32,
    y: i32,
}

impl<S: ShapeSet, T: Store> Iterator for Tiles<'_, S, T> {
    type Item = TileAt;

    fn next(&mut self) -> Option<TileAt> {
        let (x, y) = (self.x, self.y);
        if y > self.range.y1 || self.range.x0 > self.range.x1 {
            return None;
        }
        if x < self.range.x1 {
            self.x = x.wrapping_add(1);
        } else {
            (self.x, self.y) = (self.range.x0, y.wrapping_add(1));
        }
        let id = self.map.id(x, y);
        Some(TileAt { cell: Cell::of(x, y), id, kind: self.map.kinds.get(id) })
    }
}

impl<S: ShapeSet, T: Store> TileMap<'_, S, T> {
    /// The tiles whose inside meets the region. A region that is exactly one tile gives only that
    /// tile. For a body that is no box pass its bounding box, such as `&ball.aabb()`.
    ///
    /// Every tile of the map counts, solid or not; cells outside the map are not reported. A region
    /// without width on a line between two columns gives both, and likewise for rows. So it misses
    /// no tile that a point touches.
    ///
    /// Cost: one look-up per tile. It cannot fail.
    ///
    /// ```
    /// use tilesat::{Aabb, Cell, TileKind, TileKinds, TileMap, Vec2};
    /// const COIN: u8 = 1;
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'$', TileKind::EMPTY.with_flags(COIN));
    /// let map = TileMap::from_ascii("..$\n$..", &KINDS)?;
    /// let player = Aabb::new(Vec2::from_ints(20, 0), Vec2::from_ints(36, 16)).unwrap();
    /// let coins: Vec<_> = map.tiles_in(&player).filter(|t| t.kind.flag(COIN)).map(|t| t.cell).collect();
    /// assert_eq!(coins, [Cell::new(2, 0)]);
    /// # Ok::<(), tilesat::TileMapError>(())
    /// ```
    #[doc(alias("queryRect", "Area2D"))]
    pub const fn tiles_in(&self, region: &Aabb) -> Tiles<'_, S, T> {
        let (lo, hi) = (region.lo(), region.hi());
        let (mut range, closed) = (self.open_range(lo, hi), self.closed_range(lo, hi));
        if lo.x == hi.x {
            (range.x0, range.x1) = (closed.x0, closed.x1);
        }
        if lo.y == hi.y {
            (range.y0, range.y1) = (closed.y0, closed.y1);
        }
        let range = self.inside(range);
        Tiles { map: self, range, x: range.x0, y: range.y0 }
    }

    /// Writes the tiles of [`tiles_in`](Self::tiles_in) to `out`, which is cleared first.
    ///
    /// ```
    /// use tilesat::{Aabb, TileKind, TileKinds, TileMap, Vec2};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
    /// let map = TileMap::from_ascii("..#\n#..", &KINDS)?;
    /// let mut tiles = heapless::Vec::<_, 4>::new();
    /// map.collect_tiles(&Aabb::new(Vec2::ZERO, Vec2::from_ints(32, 32))?, &mut tiles)?;
    /// assert_eq!(tiles.iter().filter(|tile| tile.kind == TileKind::FULL).count(), 1);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`Truncated`] if they do not fit. `out` then holds the first ones, and the error has the
    /// total number.
    pub fn collect_tiles(&self, region: &Aabb, out: &mut VecView<TileAt>) -> Result<(), Truncated> {
        out.clear();
        let (mut seen, mut kept) = (0u32, 0);
        for tile in self.tiles_in(region) {
            seen = seen.wrapping_add(1);
            if out.push(tile).is_ok() {
                kept = seen;
            }
        }
        if kept == seen { Ok(()) } else { Err(Truncated { seen, kept }) }
    }

    /// The flags, or-ed, of all tiles that a box, circle or point touches, solid or not.
    ///
    /// Borders count: a body that stands exactly beside a deadly tile touches it. For tiles that
    /// must be entered use [`tiles_in`](Self::tiles_in). Cells outside the map have no flags.
    /// Exact. Cost: as [`touches`](Self::touches), but it always looks at every cell.
    ///
    /// ```
    /// use tilesat::{Circle, Fx, TileKind, TileKinds, TileMap, Vec2};
    /// const DEADLY: u8 = 1;
    /// const LADDER: u8 = 2;
    /// static KINDS: TileKinds = TileKinds::EMPTY
    ///     .with(b'^', TileKind::FULL.with_flags(DEADLY))
    ///     .with(b'H', TileKind::EMPTY.with_flags(LADDER));
    /// let map = TileMap::from_ascii(".H.\n..^", &KINDS)?;
    /// let ball = Circle::new(Vec2::from_ints(16, 16), Fx::from_num(8)).unwrap();
    /// assert_eq!(map.flags_touched(&ball), LADDER);
    /// assert_eq!(map.flags_touched(&Vec2::from_ints(32, 16)), DEADLY | LADDER);
    /// # Ok::<(), tilesat::TileMapError>(())
    /// ```
    #[must_use]
    pub fn flags_touched<B: Probe>(&self, shape: &B) -> u8 {
        let (lo, hi) = shape.bounds();
        self.flags_of(lo, hi, |cell| shape.reaches(cell))
    }

    /// The flags, or-ed, of all tiles that a box, circle or point touches anywhere on a straight
    /// motion. So it does not miss coins and spikes that a fast body passes over in one frame.
    /// Borders count, as in [`flags_touched`](Self::flags_touched). Exact.
    ///
    /// The path of a body that slid is bent. Its first piece ends at the first hit, and with at
    /// most one hit the rest is straight, too:
    ///
    /// ```
    /// use tilesat::{Aabb, Axis, Mover, TileKind, TileKinds, TileMap, Vec2};
    /// const COIN: u8 = 1;
    /// static KINDS: TileKinds =
    ///     TileKinds::EMPTY.with(b'#', TileKind::FULL).with(b'o', TileKind::EMPTY.with_flags(COIN));
    /// let map = TileMap::from_ascii("......\n...o..\n######", &KINDS)?;
    /// let body = Aabb::new(Vec2::from_ints(2, 2), Vec2::from_ints(8, 8))?;
    /// let velocity = Vec2::from_ints(80, 60); // down to the floor at two fifths of the motion, and along it
    /// let moved = Mover::platformer(Axis::NEG_Y).move_and_slide(&map, &body, velocity)?;
    ///
    /// let first = moved.hits.first().map_or(moved.position() - body.min(), |hit| hit.toi.of(velocity));
    /// let corner = body.translated(first)?;
    /// let flags = map.flags_swept(&body, first)? | map.flags_swept(&corner, moved.position() - corner.min())?;
    /// assert_eq!((flags, map.flags_touched(&moved.body)), (COIN, 0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// Cost: one look-up for each cell of the bounding box of the motion, and a few exact tests for
    /// each cell with a new flag.
    ///
    /// # Errors
    /// [`RangeError`] if a component of the motion is not below 2^28 raw, or it leads out of the
    /// [domain](crate::num::DOMAIN).
    pub fn flags_swept<B: Probe>(&self, shape: &B, motion: Vec2) -> Result<u8, RangeError> {
        let (d, (lo, hi)) = (Raw::of(motion), bounds_of_way(shape, motion)?);
        Ok(self.flags_of(lo, hi, |cell| shape.passes(d, cell)))
    }

    /// The tiles that a box, circle or point touches anywhere on a straight motion, each once: all
    /// coins that a fast body takes.
    ///
    /// The tiles are those of [`flags_swept`](Self::flags_swept), solid or not. They come row after
    /// row, not in the order of the motion. Exact. Cost: one look-up and one exact test for each
    /// cell of the bounding box of the motion.
    ///
    /// ```
    /// use tilesat::{Cell, Circle, Fx, TileKind, TileKinds, TileMap, Vec2};
    /// const COIN: u8 = 1;
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'o', TileKind::EMPTY.with_flags(COIN));
    /// let map = TileMap::from_ascii("o..o\n....\n.o.o", &KINDS)?;
    /// let bullet = Circle::new(Vec2::from_ints(4, 4), Fx::from_num(2))?;
    /// let taken = map.tiles_swept(&bullet, Vec2::from_ints(56, 40))?.filter(|tile| tile.kind.flag(COIN));
    /// assert_eq!(taken.map(|tile| tile.cell).collect::<Vec<_>>(), [Cell::new(0, 0), Cell::new(3, 2)]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`flags_swept`](Self::flags_swept).
    #[doc(alias = "cross")]
    pub fn tiles_swept<B: Probe>(&self, shape: &B, motion: Vec2) -> Result<impl Iterator<Item = TileAt>, RangeError> {
        let (d, (lo, hi)) = (Raw::of(motion), bounds_of_way(shape, motion)?);
        let range = self.inside(self.closed_range(lo, hi));
        let near = Tiles { map: self, range, x: range.x0, y: range.y0 };
        Ok(near.filter(move |tile| shape.passes(d, self.grid.corners(tile.cell.x.into(), tile.cell.y.into()))))
    }

    /// The tiles that a box, circle or point touches anywhere on the path of a mover, each once.
    ///
    /// `shape` is the body before the call that wrote the trail. It is
    /// [`tiles_swept`](Self::tiles_swept) for a path of several parts.
    /// [`Mover::move_along`](crate::Mover::move_along) has an example. Cost: one look-up for each
    /// cell of the bounding box of the path, and one exact test for each part.
    ///
    /// ```
    /// use tilesat::{Cell, Circle, Mover, Response, TileKind, TileKinds, TileMap, Vec2, fx, world::Trail};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL).with(b'o', TileKind::EMPTY.with_flags(1));
    /// let level = TileMap::from_ascii("..o.#\n.o.o.", &KINDS)?; // coins, and a wall at x = 64
    /// let (ball, mut trail) = (Circle::new(Vec2::from_ints(8, 8), fx!(4))?, Trail::default());
    /// let bouncing = Mover::new().with_response(Response::Bounce);
    /// let moved = bouncing.move_along(&level, &ball, Vec2::from_ints(80, 0), &mut trail)?;
    /// assert_eq!(moved.position(), Vec2::from_ints(32, 8)); // it passed a coin twice
    /// let coins = level.tiles_on(&ball, &trail)?.filter(|tile| tile.kind.flag(1));
    /// assert!(coins.map(|tile| tile.cell).eq([Cell::new(2, 0)]));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`flags_swept`](Self::flags_swept).
    #[doc(alias = "cross")]
    pub fn tiles_on<B: Probe>(&self, shape: &B, trail: &Trail) -> Result<impl Iterator<Item = TileAt>, RangeError> {
        let (legs, whole) = (trail.legs(), bounds_of_trail(shape, trail)?);
        let range = self.inside(self.closed_range(whole.0, whole.1));
        let near = Tiles { map: self, range, x: range.x0, y: range.y0 };
        Ok(near.filter(move |tile| {
            let (lo, hi) = self.grid.corners(tile.cell.x.into(), tile.cell.y.into());
            legs.clone().any(|leg| shape.passes_on(leg, (lo, hi)))
        }))
    }

    /// The flags of the tiles near a region that a test accepts.
    fn flags_of(&self, lo: Raw, hi: Raw, reaches: impl Fn((Raw, Raw)) -> bool) -> u8 {
        let range = self.inside(self.closed_range(lo, hi));
        let (mut flags, mut y) = (0, range.y0);
        while y <= range.y1 {
            let mut x = range.x0;
            while x <= range.x1 {
                let kind = self.kinds.get(self.id(x, y));
                // In this order, most tiles cost no geometry.
                if kind.flags & !flags != 0 && reaches(self.grid.corners(x, y)) {
                    flags |= kind.flags;
                }
                x = x.wrapping_add(1);
            }
            y = y.wrapping_add(1);
        }
        flags
    }
}

/// The bounds of a shape on a trail.
pub(in crate::world) fn bounds_of_trail<B: Probe>(shape: &B, trail: &Trail) -> Result<(Raw, Raw), RangeError> {
    let (lo, hi) = shape.bounds();
    let (mut least, mut most) = (lo, hi);
    for (from, by) in trail.legs() {
        let (from, to) = (Raw::of(from), Raw::of(from.saturating_add(by)));
        for at in [from, to] {
            check_motion(at.vec2(), 2 * DOMAIN)?;
            let (a, b) = (lo.add(at), hi.add(at));
            check_coordinate(a.vec2())?;
            check_coordinate(b.vec2())?;
            least = Raw { x: least.x.min(a.x), y: least.y.min(a.y) };
            most = Raw { x: most.x.max(b.x), y: most.y.max(b.y) };
        }
    }
    Ok((least, most))
}

/// The bounds of a shape on a whole motion.
pub(in crate::world) fn bounds_of_way<B: Probe>(shape: &B, motion: Vec2) -> Result<(Raw, Raw), RangeError> {
    check_motion(motion, MOTION)?;
    let (d, (lo, hi)) = (Raw::of(motion), shape.bounds());
    check_coordinate(lo.add(d).vec2())?;
    check_coordinate(hi.add(d).vec2())?;
    let least = Raw { x: d.x.min(0), y: d.y.min(0) };
    let most = Raw { x: d.x.max(0), y: d.y.max(0) };
    Ok((lo.add(least), hi.add(most)))
}
