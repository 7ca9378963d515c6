//! The surface of a level, derived from its tiles when asked.

use super::range::Range;
use super::{Cell, Feature, Geometry, Set, Store, TileMap, TileShape};
use crate::num::{Axis, Raw};
use crate::shape::Aabb;

impl<S: Set, T: Store> TileMap<'_, S, T> {
    /// The faces and vertices of the surface that have a point in the closed region, row after row.
    ///
    /// A face of a full cell exists where the cell across it is not full; a vertex where two faces of one cell meet, so at convex
    /// corners only (two diagonal cells have one each). A one-way tile has its upper face alone, unless the tile above is full.
    /// What is [`Outside`](super::Outside) counts: in a closed room the solid cells around the map have faces inward.
    /// Where the border is repeated, its faces reach to the end of the domain.
    ///
    /// ```text
    ///   7          4
    ///    +---0-->-+       0..=3 faces, 4..=7 vertices: a Feature's index
    ///    ^  full  |       full beside full: faces 1 and 3 between them
    ///    3        1       do not exist, nor do vertices on a flat line
    ///    |        v
    ///    +-<--2---+
    ///   6          5
    /// ```
    ///
    /// Cost: the cells of the region once each, with 4 neighbours of each full one. It cannot fail.
    ///
    /// ```
    /// use tilesat::{Aabb, Axis, Geometry, TileKind, TileKinds, TileMap, Vec2};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
    /// let map = TileMap::from_ascii("...\n###", &KINDS)?;
    /// // Across the floor's top near the seam between its first two tiles: two flat faces, no corner.
    /// let region = Aabb::new(Vec2::from_ints(10, 10), Vec2::from_ints(20, 20)).unwrap();
    /// let faces: Vec<_> = map.features(&region).map(|f| f.geometry).collect();
    /// let len = 16 << 16;
    /// assert_eq!(faces, [
    ///     Geometry::Face { a: Vec2::from_ints(0, 16), dir: Axis::X, len, joined: [false, true] },
    ///     Geometry::Face { a: Vec2::from_ints(16, 16), dir: Axis::X, len, joined: [true, true] },
    /// ]);
    /// # Ok::<(), tilesat::TileMapError>(())
    /// ```
    pub const fn features(&self, region: &Aabb) -> Features<'_, S, T> {
        let (lo, hi) = (region.lo(), region.hi());
        let range = self.solid_range(self.closed_range(lo, hi));
        Features {
            map: self,
            region: (lo, hi),
            range,
            x: range.x0,
            y: range.y0,
            cell: Cell::new(0, 0),
            solid: (lo, lo),
            left: 0,
            all: 0,
            flags: 0,
        }
    }
}

/// The cursor of [`TileMap::features`]: holds no features, derives the next one from the tiles.
#[derive(Clone, Debug)]
#[must_use = "cursors do nothing unless advanced"]
pub struct Features<'w, S: Set, T: Store> {
    map: &'w TileMap<'w, S, T>,
    region: (Raw, Raw),
    range: Range,
    /// The next cell.
    x: i32,
    y: i32,
    /// The cell whose features are handed out, the corners of its solid, its tile's flags, all its features as a mask of indices, and
    /// those left to give.
    cell: Cell,
    solid: (Raw, Raw),
    flags: u8,
    all: Surface,
    left: Surface,
}

/// Bits 0..=3: faces by index; 4..=7: vertices; 8: a one-way face with index 0, then bits 4 and 7 mean that it is not joined.
type Surface = u16;

const ONE_WAY: Surface = 1 << 8;

/// Face k runs from corner k to corner k + 1: corners are counted from the one nearest the origin, turning with the faces.
const DIRECTIONS: [Axis; 4] = [Axis::X, Axis::Y, Axis::NEG_X, Axis::NEG_Y];

impl<S: Set, T: Store> Iterator for Features<'_, S, T> {
    type Item = Feature;

    fn next(&mut self) -> Option<Feature> {
        while self.left == 0 {
            if !self.load() {
                return None;
            }
        }
        let mut index = 0;
        while index < 7 && self.left >> index & 1 == 0 {
            index += 1;
        }
        self.left &= !(1 << index);
        Some(self.feature(index))
    }
}

impl<S: Set, T: Store> Features<'_, S, T> {
    /// Goes to the next cell; false where there is none.
    fn load(&mut self) -> bool {
        let (x, y) = (self.x, self.y);
        if y > self.range.y1 || self.range.x0 > self.range.x1 {
            return false;
        }
        if x < self.range.x1 {
            self.x = x.wrapping_add(1);
        } else {
            (self.x, self.y) = (self.range.x0, y.wrapping_add(1));
        }
        let kind = self.map.kind_at(x, y);
        self.all = match kind.shape {
            TileShape::Empty => return true,
            TileShape::Full => self.map.surface(x, y),
            TileShape::OneWayUp => self.map.one_way_surface(x, y),
        };
        if self.all != 0 {
            self.solid = self.map.extent(x, y);
            if self.all & ONE_WAY != 0 {
                // Above and below the map a one-way edge is not repeated: the band's corners are not its own.
                self.solid.0.y = self.map.grid.line_y(y);
            }
            self.left = self.all & self.reached();
            self.flags = kind.flags;
            self.cell = Cell::of(x, y);
        }
        true
    }

    /// The indices whose place is in the region; that the cell is is known. Of a one-way cell, its face alone: the marks of its ends are
    /// not features.
    fn reached(&self) -> Surface {
        let ((lo, hi), region) = (self.solid, self.region);
        let mut out = if self.all & ONE_WAY != 0 { !1 } else { 0 };
        if lo.y < region.0.y || lo.y > region.1.y {
            out |= 0b1001_0001;
        }
        if hi.x > region.1.x {
            out |= 0b0011_0010;
        }
        if hi.y > region.1.y {
            out |= 0b0110_0100;
        }
        if lo.x < region.0.x {
            out |= 0b1100_1000;
        }
        !out & 0xff
    }

    fn feature(&self, index: u8) -> Feature {
        let (lo, hi) = self.solid;
        let k = index & 3;
        let dir = direction(k);
        let geometry = if index < 4 {
            let a = corner(lo, hi, k);
            let len = if k & 1 == 0 { hi.x.wrapping_sub(lo.x) } else { hi.y.wrapping_sub(lo.y) };
            let (start, end) = (4 + (k.wrapping_sub(1) & 3), 4 + k);
            let joined = [self.all >> start & 1 == 0, self.all >> end & 1 == 0];
            Geometry::Face { a: a.vec2(), dir, len, joined }
        } else {
            let next = k.wrapping_add(1) & 3;
            Geometry::Vertex { p: corner(lo, hi, next).vec2(), e_in: dir, e_out: direction(next) }
        };
        Feature { geometry, cell: self.cell, index, flags: self.flags, one_way: self.all & ONE_WAY != 0 }
    }
}

#[expect(clippy::indexing_slicing, reason = "masked to the table's length")]
const fn direction(k: u8) -> Axis {
    DIRECTIONS[(k & 3) as usize]
}

/// Where face k starts.
const fn corner(lo: Raw, hi: Raw, k: u8) -> Raw {
    Raw { x: if k == 1 || k == 2 { hi.x } else { lo.x }, y: if k >= 2 { hi.y } else { lo.y } }
}

impl<S: Set, T: Store> TileMap<'_, S, T> {
    /// The faces and vertices of a full cell.
    const fn surface(&self, x: i32, y: i32) -> Surface {
        let up = !self.full(x, y.wrapping_sub(1)) as Surface;
        let right = !self.full(x.wrapping_add(1), y) as Surface;
        let down = !self.full(x, y.wrapping_add(1)) as Surface;
        let left = !self.full(x.wrapping_sub(1), y) as Surface;
        let faces = up | right << 1 | down << 2 | left << 3;
        // Vertex k is where face k ends and the next one starts.
        faces | (faces & (faces >> 1 | faces << 3) & 0xf) << 4
    }

    /// The face of a one-way cell: not there below a full one.
    const fn one_way_surface(&self, x: i32, y: i32) -> Surface {
        if self.full(x, y.wrapping_sub(1)) {
            return 0;
        }
        let end = !self.goes_on(x.wrapping_add(1), y) as Surface;
        let start = !self.goes_on(x.wrapping_sub(1), y) as Surface;
        ONE_WAY | 1 | end << 4 | start << 7
    }

    /// Whether something that blocks from above lies beside a one-way face: a full cell, or a one-way one that has its face.
    const fn goes_on(&self, x: i32, y: i32) -> bool {
        let kind = self.kind_at(x, y);
        kind.is_full() || (kind.is_one_way() && !self.full(x, y.wrapping_sub(1)))
    }
}
