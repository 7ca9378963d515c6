//! From paths to bytes: segments counted, then written, with their references and joints.

use super::cancel::{EdgeBlock, EdgeIndex, Shared, left_from};
use super::join::join;
use super::parse::{Tables, clamped};
use super::path::{PathEdge, edges, point, reversed};
use super::raster::Rows;
use super::{
    ATTR_AT, HEADER, Kind, MAGIC, MOST, NEXT_AT, NONE, Path, PathKind, SEGMENT, Seg, SegmentMap, Size, VERSION, at,
    checksum, half, path, set_byte, set_half, set_word,
};
use crate::num::{Axis, Fx, Raw};
use crate::world::{cell::Cell, error::SegmentMapError, grid::Grid};
use heapless::VecView;

impl<'a> SegmentMap<'a> {
    /// The size of the level of these paths, in cells of side `cell` that cover them.
    ///
    /// The first cell starts at the smallest coordinates of any point; if the last one would leave
    /// the domain, all are moved.
    ///
    /// ```
    /// use tilesat::{Fx, Path, PathKind, SegmentMap, SegmentMapError, Vec2};
    /// let slope = [Vec2::from_ints(0, 0), Vec2::from_ints(32, 16), Vec2::from_ints(0, 16)];
    /// let size = SegmentMap::measure(&[Path::new(PathKind::Solid, &slope)], Fx::from_num(16))?;
    /// assert_eq!((size.segments(), size.grid().width(), size.grid().height()), (3, 2, 1));
    /// assert_eq!(size.bytes(), 34 + 24 * 3 + 2 * usize::from(size.refs()) + 3 * 2);
    ///
    /// let line = [Vec2::from_ints(0, 0), Vec2::from_ints(8, 8), Vec2::from_ints(8, 8)];
    /// let error = SegmentMap::measure(&[Path::new(PathKind::Wall, &line)], Fx::from_num(16)).unwrap_err();
    /// assert_eq!(error, SegmentMapError::ZeroLength { path: 0, point: 1 });
    /// # Ok::<(), SegmentMapError>(())
    /// ```
    ///
    /// # Errors
    /// [`SegmentMapError`] says which point of which path is wrong, or which limit is exceeded.
    pub const fn measure(paths: &[Path<'_>], cell: Fx) -> Result<Size, SegmentMapError> {
        match path::bounds(paths) {
            Ok((lo, hi)) => match path::grid(lo, hi, cell) {
                Ok(grid) => count(paths, grid),
                Err(e) => Err(e),
            },
            Err(e) => Err(e),
        }
    }

    /// Measures on a given grid, which may be larger than the paths.
    ///
    /// # Errors
    /// As [`measure`](Self::measure), and [`SegmentMapError::OutsideGrid`].
    pub const fn measure_on(paths: &[Path<'_>], grid: Grid) -> Result<Size, SegmentMapError> {
        if let Err(e) = path::bounds(paths) {
            return Err(e);
        }
        match path::on_grid(paths, &grid) {
            Ok(()) => count(paths, grid),
            Err(e) => Err(e),
        }
    }

    /// Writes the level of these paths to the start of `out`, and returns its number of bytes.
    ///
    /// [`from_bytes`](Self::from_bytes) reads them.
    ///
    /// Cost: twice that of [`measure`](Self::measure). Each edge of a polygon is compared with
    /// those of the runs near it. Each end of a segment is compared with the segments of its cell.
    ///
    /// # Errors
    /// As [`measure`](Self::measure), and [`SegmentMapError::TooSmall`]; `out` is then unchanged.
    /// After [`SegmentMapError::TooDeep`], `out` holds no level.
    pub const fn build_into(paths: &[Path<'_>], cell: Fx, out: &mut [u8]) -> Result<usize, SegmentMapError> {
        match Self::measure(paths, cell) {
            Ok(size) => build(paths, &size, out),
            Err(e) => Err(e),
        }
    }

    /// Builds on a given grid.
    ///
    /// # Errors
    /// As [`build_into`](Self::build_into), and [`SegmentMapError::OutsideGrid`].
    pub const fn build_on(paths: &[Path<'_>], grid: Grid, out: &mut [u8]) -> Result<usize, SegmentMapError> {
        match Self::measure_on(paths, grid) {
            Ok(size) => build(paths, &size, out),
            Err(e) => Err(e),
        }
    }

    /// Replaces the contents of `out` by the level of these paths, and returns a view of it.
    ///
    /// ```
    /// use heapless::Vec;
    /// use tilesat::{Fx, Path, PathKind, SegmentMap, Vec2};
    /// let wall = [Vec2::from_ints(0, 0), Vec2::from_ints(32, 16)];
    /// let mut room: Vec<u8, 256> = Vec::new();
    /// let level = SegmentMap::build_vec(&[Path::new(PathKind::Wall, &wall)], Fx::from_num(16), &mut room)?;
    /// assert_eq!(level.count(), 2); // its two faces
    /// # Ok::<(), tilesat::SegmentMapError>(())
    /// ```
    ///
    /// # Errors
    /// As [`build_into`](Self::build_into).
    pub fn build_vec(paths: &[Path<'_>], cell: Fx, out: &'a mut VecView<u8>) -> Result<Self, SegmentMapError> {
        let size = Self::measure(paths, cell)?;
        if size.bytes() > out.capacity() {
            return Err(SegmentMapError::TooSmall { needed: clamped(size.bytes()), found: clamped(out.capacity()) });
        }
        out.clear();
        // There is room, so this cannot fail.
        let _ = out.resize(size.bytes(), 0);
        let out = out.as_mut_slice();
        build(paths, &size, out)?;
        Ok(size.view(out))
    }
}

/// Segments and references.
const fn count(paths: &[Path<'_>], grid: Grid) -> Result<Size, SegmentMapError> {
    let mut sink = Sink { grid, out: &mut [], segments: 0, refs: 0 };
    match sink.take(paths) {
        Ok(()) => Ok(Size { grid, segments: sink.segments, refs: sink.refs }),
        Err(e) => Err(e),
    }
}

/// Writes a level whose size is known.
pub(super) const fn build(paths: &[Path<'_>], size: &Size, out: &mut [u8]) -> Result<usize, SegmentMapError> {
    let (needed, found) = (size.bytes(), out.len());
    let Some((out, _)) = out.split_at_mut_checked(needed) else {
        return Err(SegmentMapError::TooSmall { needed: clamped(needed), found: clamped(found) });
    };
    if let Err(e) = place(paths, size, out) {
        return Err(e);
    }
    join(size, out);
    match finish(size, out) {
        Ok(()) => Ok(needed),
        Err(e) => Err(e),
    }
}

/// The first half of the work: the segments, and the references of the cells.
const fn place(paths: &[Path<'_>], size: &Size, out: &mut [u8]) -> Result<(), SegmentMapError> {
    // An unfinished buffer is not a level: this word is written last.
    set_word(out, at::MAGIC, 0);
    let mut sink = Sink { grid: size.grid, out, segments: 0, refs: 0 };
    if let Err(e) = sink.take(paths) {
        return Err(e);
    }
    refer(size, out);
    Ok(())
}

/// The second half, after the joints: what needs the references.
const fn finish(size: &Size, out: &mut [u8]) -> Result<(), SegmentMapError> {
    if let Err(e) = wind(size, out) {
        return Err(e);
    }
    head(size, out);
    Ok(())
}

/// The cells' references: counted, summed, and filled in from the last segment to the first, each
/// cell from its end.
const fn refer(size: &Size, out: &mut [u8]) {
    let Tables { segments, offsets, refs, .. } = size.tables(out);
    let mut at = 0;
    while at < offsets.len() {
        set_half(offsets, at, 0);
        at += 2;
    }
    let mut index = 0;
    while index < size.segments {
        let mut rows = rows_of(&size.grid, segments, index);
        while let Some(row) = rows.advance() {
            let (mut at, end) = (offset_at(size, row.x0, row.y), offset_at(size, row.x1, row.y));
            while at <= end {
                set_half(offsets, at, half(offsets, at).wrapping_add(1));
                at += 2;
            }
        }
        index += 1;
    }
    let mut sum = 0u16;
    at = 0;
    while at < offsets.len() {
        sum = sum.wrapping_add(half(offsets, at));
        set_half(offsets, at, sum);
        at += 2;
    }
    while index > 0 {
        index -= 1;
        let mut rows = rows_of(&size.grid, segments, index);
        while let Some(row) = rows.advance() {
            let (mut at, end) = (offset_at(size, row.x0, row.y), offset_at(size, row.x1, row.y));
            while at <= end {
                let place = half(offsets, at).wrapping_sub(1);
                set_half(offsets, at, place);
                set_half(refs, (place as usize) << 1, index);
                at += 2;
            }
        }
    }
}

const fn rows_of(grid: &Grid, segments: &[u8], index: u16) -> Rows {
    let seg = Seg::read(segments, index);
    Rows::new(grid, seg.a, seg.b(), seg.dir)
}

const fn offset_at(size: &Size, x: i32, y: i32) -> usize {
    (y as usize).wrapping_mul(size.grid.x.count as usize).wrapping_add(x as usize) << 1
}

/// Winding numbers; needs the references.
const fn wind(size: &Size, out: &mut [u8]) -> Result<(), SegmentMapError> {
    let (width, height) = (size.grid.x.count as i32, size.grid.y.count as i32);
    let Tables { segments, offsets, refs, winding: numbers } = size.tables(out);
    let map = SegmentMap { grid: size.grid, segments, offsets, refs, winding: &[] };
    let (mut y, mut at) = (0, 0);
    while y < height {
        let (mut x, mut winding) = (0, 0);
        while x < width {
            winding = map.next_winding(x, y, winding);
            if winding as i8 as i32 != winding {
                return Err(SegmentMapError::TooDeep(Cell::of(x, y)));
            }
            set_byte(numbers, at, winding as u8);
            at += 1;
            x += 1;
        }
        y += 1;
    }
    Ok(())
}

const fn head(size: &Size, out: &mut [u8]) {
    let grid = &size.grid;
    set_half(out, at::VERSION, VERSION as u16);
    set_half(out, at::SEGMENTS, size.segments);
    set_word(out, at::ORIGIN_X, grid.x.origin as u32);
    set_word(out, at::ORIGIN_Y, grid.y.origin as u32);
    set_word(out, at::CELL, grid.cell as u32);
    set_half(out, at::WIDTH, grid.width());
    set_half(out, at::HEIGHT, grid.height());
    set_half(out, at::REFS, size.refs);
    set_half(out, at::RESERVED, 0);
    set_word(out, at::MAGIC, MAGIC);
    set_word(out, at::CHECKSUM, checksum(out));
}

/// Takes segments. The first pass gives it no room, so both passes are the same code.
#[derive(Debug)]
pub(super) struct Sink<'o> {
    pub(super) grid: Grid,
    pub(super) out: &'o mut [u8],
    pub(super) segments: u16,
    pub(super) refs: u16,
}

impl Sink<'_> {
    /// The segments of all paths, in the order of the paths and their points. A cancelled edge
    /// gives only its rest.
    #[expect(clippy::indexing_slicing, reason = "bounded by the loop")]
    pub(super) const fn take(&mut self, paths: &[Path<'_>]) -> Result<(), SegmentMapError> {
        let (mut i, mut block) = (0, EdgeBlock::EMPTY);
        while i < paths.len() {
            let path = &paths[i];
            let (against, count) = (reversed(path), edges(path));
            let mut k = 0;
            while k < count {
                let (a, b) = (point(path, k), point(path, k + 1));
                let edge = if against { PathEdge::between(b, a) } else { PathEdge::between(a, b) };
                let place = EdgeIndex { path: i as u32, point: k as u32 };
                let taken = match path.kind {
                    PathKind::Solid | PathKind::Hole => {
                        self.left(paths, block.shared(paths, place), place, &edge, path.flags)
                    }
                    PathKind::Wall => self.both(place, &edge, path.flags),
                    PathKind::OneWay => self.put(place, &edge, Kind::OneWay, path.flags),
                };
                if taken.is_err() {
                    return taken;
                }
                k += 1;
            }
            i += 1;
        }
        Ok(())
    }

    /// The pieces of a polygon's edge that are not cancelled, each as long as can be.
    const fn left(
        &mut self,
        paths: &[Path<'_>],
        shared: Shared,
        place: EdgeIndex,
        edge: &PathEdge,
        flags: u8,
    ) -> Result<(), SegmentMapError> {
        let (mut t, mut from) = (0, -1);
        while t < edge.len {
            let (until, left) = left_from(paths, shared, place, edge, t);
            if left && from < 0 {
                from = t;
            }
            if from >= 0 && (!left || until >= edge.len) {
                let to = if left { until } else { t };
                let piece = PathEdge { a: edge.at(from), dir: edge.dir, len: to.wrapping_sub(from) };
                if let Err(e) = self.put(place, &piece, Kind::Solid, flags) {
                    return Err(e);
                }
                from = -1;
            }
            t = until;
        }
        Ok(())
    }

    /// Both faces of a wall's edge.
    const fn both(&mut self, place: EdgeIndex, edge: &PathEdge, flags: u8) -> Result<(), SegmentMapError> {
        let back = PathEdge { a: edge.at(edge.len), dir: edge.dir.reversed(), len: edge.len };
        match self.put(place, edge, Kind::Wall, flags) {
            Ok(()) => self.put(place, &back, Kind::Wall, flags),
            Err(e) => Err(e),
        }
    }

    const fn put(&mut self, place: EdgeIndex, edge: &PathEdge, kind: Kind, flags: u8) -> Result<(), SegmentMapError> {
        let EdgeIndex { path, point } = place;
        if self.segments == MOST {
            return Err(SegmentMapError::TooManySegments { path, point });
        }
        let mut rows = Rows::new(&self.grid, edge.a, edge.at(edge.len), edge.dir);
        while let Some(row) = rows.advance() {
            // Fewer than 2^15 columns.
            let met = row.x1.wrapping_sub(row.x0).wrapping_add(1) as u16;
            match self.refs.checked_add(met) {
                Some(refs) => self.refs = refs,
                None => return Err(SegmentMapError::TooManyRefs { path, point }),
            }
        }
        let at = HEADER.wrapping_add((self.segments as usize).wrapping_mul(SEGMENT));
        set_raw(self.out, at, edge.a);
        let Axis { x, y } = edge.dir;
        set_raw(self.out, at.wrapping_add(8), Raw { x, y });
        set_word(self.out, at.wrapping_add(16), edge.len as u32);
        set_half(self.out, at.wrapping_add(NEXT_AT), NONE);
        set_byte(self.out, at.wrapping_add(ATTR_AT), kind as u8);
        set_byte(self.out, at.wrapping_add(ATTR_AT + 1), flags);
        self.segments += 1;
        Ok(())
    }
}

const fn set_raw(out: &mut [u8], at: usize, p: Raw) {
    set_word(out, at, p.x as u32);
    set_word(out, at.wrapping_add(4), p.y as u32);
}

/// A level of line segments as a `static`, built and checked by the compiler.
///
/// It takes no work at run time, and no memory except the bytes in flash. It takes an array of
/// [`Path`](crate::Path)s and the side of a cell, both constant. A refused path is a compile error
/// that says which path is wrong, and why.
///
/// ```
/// use tilesat::{Path, PathKind, Vec2, fx, segment_map};
/// const HILL: [Vec2; 3] = [Vec2::from_ints(0, 64), Vec2::from_ints(64, 32), Vec2::from_ints(128, 64)];
/// segment_map!(static LEVEL: [Path::new(PathKind::Solid, &HILL)], fx!(32));
/// assert_eq!((LEVEL.count(), LEVEL.width(), LEVEL.height()), (3, 4, 1));
/// ```
///
/// ```compile_fail
/// # use tilesat::{Path, PathKind, Vec2, fx, segment_map};
/// // path 0: point 1 is the same as the next: remove one of them
/// const LINE: [Vec2; 3] = [Vec2::from_ints(0, 64), Vec2::from_ints(64, 32), Vec2::from_ints(64, 32)];
/// segment_map!(static LEVEL: [Path::new(PathKind::Wall, &LINE)], fx!(32));
/// # assert_eq!(LEVEL.count(), 4);
/// ```
#[macro_export]
macro_rules! segment_map {
    ($(#[$attr:meta])* $vis:vis static $name:ident: $paths:expr, $cell:expr) => {
        $(#[$attr])*
        $vis static $name: $crate::SegmentMap<'static> = {
            const __PATHS: &[$crate::Path<'static>] = &$paths;
            $(#[$attr])*
            const __SIZE: $crate::world::Size = match $crate::SegmentMap::measure(__PATHS, $cell) {
                Ok(size) => size,
                Err(e) => panic!("{}", e.__text().as_str()),
            };
            // In three constants: the compiler limits the work in each.
            $(#[$attr])*
            const __PLACED: [u8; __SIZE.bytes()] = match __SIZE.__place(__PATHS) {
                Ok(bytes) => bytes,
                Err(e) => panic!("{}", e.__text().as_str()),
            };
            $(#[$attr])*
            const __JOINED: [u8; __SIZE.bytes()] = __SIZE.__join(__PLACED);
            $(#[$attr])*
            static __BYTES: [u8; __SIZE.bytes()] = match __SIZE.__finish(__JOINED) {
                Ok(bytes) => bytes,
                Err(e) => panic!("{}", e.__text().as_str()),
            };
            __SIZE.__view(&__BYTES)
        };
    };
}

impl Size {
    /// Only for [`segment_map!`], which passes the number of bytes that the paths need.
    #[doc(hidden)]
    pub const fn __place<const N: usize>(&self, paths: &[Path<'_>]) -> Result<[u8; N], SegmentMapError> {
        let mut out = [0; N];
        match place(paths, self, &mut out) {
            Ok(()) => Ok(out),
            Err(e) => Err(e),
        }
    }

    /// Only for [`segment_map!`], with the placed bytes.
    #[doc(hidden)]
    #[must_use]
    pub const fn __join<const N: usize>(&self, mut out: [u8; N]) -> [u8; N] {
        join(self, &mut out);
        out
    }

    /// Only for [`segment_map!`], with the joined bytes.
    #[doc(hidden)]
    pub const fn __finish<const N: usize>(&self, mut out: [u8; N]) -> Result<[u8; N], SegmentMapError> {
        match finish(self, &mut out) {
            Ok(()) => Ok(out),
            Err(e) => Err(e),
        }
    }

    /// Only for [`segment_map!`]: the bytes are those that were built.
    #[doc(hidden)]
    #[must_use]
    pub const fn __view<'a>(&self, bytes: &'a [u8]) -> SegmentMap<'a> {
        self.view(bytes)
    }
}
