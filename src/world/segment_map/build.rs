//! From paths to bytes: measured, then written.

use super::bytes::{HEADER, MAGIC, SEGMENT, VERSION, at, checksum, half, set_byte, set_half, set_word};
use super::emit::Sink;
use super::parse::clamped;
use super::raster::Rows;
use super::seg::{ATTR_AT, END_JOINED, NEXT_AT, NONE, START_JOINED};
use super::{Path, SegmentMap, SegmentMapError, Size, check};
use crate::num::Fx;
use crate::world::{Cell, Grid};
use heapless::VecView;

impl<'a> SegmentMap<'a> {
    /// What the level of these paths takes, on cells of side `cell` that cover them.
    ///
    /// The first cell starts at the smallest coordinates of any point; where the last one would leave the domain, all are moved.
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
    /// [`SegmentMapError`]: which point of which path is wrong, or that there is too much.
    pub const fn measure(paths: &[Path<'_>], cell: Fx) -> Result<Size, SegmentMapError> {
        match check::bounds(paths) {
            Ok((lo, hi)) => match check::grid(lo, hi, cell) {
                Ok(grid) => count(paths, grid),
                Err(e) => Err(e),
            },
            Err(e) => Err(e),
        }
    }

    /// The same on a given grid, which may be larger than the paths.
    ///
    /// # Errors
    /// As [`measure`](Self::measure), and [`SegmentMapError::OutsideGrid`].
    pub const fn measure_on(paths: &[Path<'_>], grid: Grid) -> Result<Size, SegmentMapError> {
        if let Err(e) = check::bounds(paths) {
            return Err(e);
        }
        match check::on_grid(paths, &grid) {
            Ok(()) => count(paths, grid),
            Err(e) => Err(e),
        }
    }

    /// Writes the level of these paths to the start of `out`, and says how many bytes it is: what [`from_bytes`](Self::from_bytes) takes.
    ///
    /// Cost: [`measure`](Self::measure) and as much again. Each edge of a polygon is compared with all others, each end of a segment with the
    /// segments of its cell.
    ///
    /// # Errors
    /// As [`measure`](Self::measure), and [`SegmentMapError::TooSmall`]: `out` is unchanged then. [`SegmentMapError::TooDeep`]: `out` holds
    /// nothing then.
    pub const fn build_into(paths: &[Path<'_>], cell: Fx, out: &mut [u8]) -> Result<usize, SegmentMapError> {
        match Self::measure(paths, cell) {
            Ok(size) => build(paths, &size, out),
            Err(e) => Err(e),
        }
    }

    /// The same on a given grid.
    ///
    /// # Errors
    /// As [`build_into`](Self::build_into), and [`SegmentMapError::OutsideGrid`].
    pub const fn build_on(paths: &[Path<'_>], grid: Grid, out: &mut [u8]) -> Result<usize, SegmentMapError> {
        match Self::measure_on(paths, grid) {
            Ok(size) => build(paths, &size, out),
            Err(e) => Err(e),
        }
    }

    /// Writes the level of these paths to `out`, whose contents it replaces, and gives the view of it.
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
        // There is room, so that this cannot fail.
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
    // What is not finished is no level: this word is written last.
    set_word(out, at::MAGIC, 0);
    let mut sink = Sink { grid: size.grid, out, segments: 0, refs: 0 };
    if let Err(e) = sink.take(paths) {
        return Err(e);
    }
    refer(size, out);
    join(size, out);
    if let Err(e) = wind(size, out) {
        return Err(e);
    }
    head(size, out);
    Ok(needed)
}

/// The cells' references: counted, summed, and filled in from the last segment to the first, each cell from its end.
const fn refer(size: &Size, out: &mut [u8]) {
    let (offsets, refs) = (size.offsets_at(), size.refs_at());
    let mut at = offsets;
    while at < refs {
        set_half(out, at, 0);
        at += 2;
    }
    let mut index = 0;
    while index < size.segments {
        let mut rows = rows_of(size, out, index);
        while let Some(row) = rows.advance() {
            let (mut at, end) = (offset_at(size, row.x0, row.y), offset_at(size, row.x1, row.y));
            while at <= end {
                set_half(out, at, half(out, at).wrapping_add(1));
                at += 2;
            }
        }
        index += 1;
    }
    let mut sum = 0u16;
    at = offsets;
    while at < refs {
        sum = sum.wrapping_add(half(out, at));
        set_half(out, at, sum);
        at += 2;
    }
    while index > 0 {
        index -= 1;
        let mut rows = rows_of(size, out, index);
        while let Some(row) = rows.advance() {
            let (mut at, end) = (offset_at(size, row.x0, row.y), offset_at(size, row.x1, row.y));
            while at <= end {
                let place = half(out, at).wrapping_sub(1);
                set_half(out, at, place);
                set_half(out, refs.wrapping_add((place as usize) << 1), index);
                at += 2;
            }
        }
    }
}

const fn rows_of(size: &Size, out: &[u8], index: u16) -> Rows {
    let seg = size.view(out).segment(index);
    Rows::new(&size.grid, seg.a, seg.b(), seg.dir)
}

const fn offset_at(size: &Size, x: i32, y: i32) -> usize {
    let cell = (y as usize).wrapping_mul(size.grid.x.count as usize).wrapping_add(x as usize);
    size.offsets_at().wrapping_add(cell << 1)
}

/// Vertices and joints; needs the references.
const fn join(size: &Size, out: &mut [u8]) {
    let mut index = 0;
    while index < size.segments {
        let map = size.view(out);
        let (kind, joints) = (map.segment(index).kind, map.joints(index));
        let attr = kind as u8
            | if joints.start_joined { START_JOINED } else { 0 }
            | if joints.end_joined { END_JOINED } else { 0 };
        let next = match joints.next {
            Some(next) => next,
            None => NONE,
        };
        let at = HEADER.wrapping_add((index as usize).wrapping_mul(SEGMENT));
        set_half(out, at.wrapping_add(NEXT_AT), next);
        set_byte(out, at.wrapping_add(ATTR_AT), attr);
        index += 1;
    }
}

/// Winding numbers; needs the references.
const fn wind(size: &Size, out: &mut [u8]) -> Result<(), SegmentMapError> {
    let (width, height) = (size.grid.x.count as i32, size.grid.y.count as i32);
    let (mut y, mut at) = (0, size.winding_at());
    while y < height {
        let (mut x, mut winding) = (0, 0);
        while x < width {
            winding = size.view(out).next_winding(x, y, winding);
            if winding as i8 as i32 != winding {
                return Err(SegmentMapError::TooDeep(Cell::of(x, y)));
            }
            set_byte(out, at, winding as u8);
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
    set_half(out, at::WIDTH, grid.x.count);
    set_half(out, at::HEIGHT, grid.y.count);
    set_half(out, at::REFS, size.refs);
    set_half(out, at::RESERVED, 0);
    set_word(out, at::MAGIC, MAGIC);
    set_word(out, at::CHECKSUM, checksum(out));
}
