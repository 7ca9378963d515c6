//! Segments from paths: counted, and written as far as there is room.

use super::bytes::{HEADER, SEGMENT, set_byte, set_half, set_word};
use super::cancel::{Place, left_from};
use super::orient::{Edge, edges, point, reversed};
use super::raster::Rows;
use super::seg::{ATTR_AT, MOST, NEXT_AT, NONE};
use super::{Kind, Path, PathKind, SegmentMapError};
use crate::num::{Axis, Raw};
use crate::world::Grid;

/// Takes segments: the first pass gives no room, so that both passes are the same code.
#[derive(Debug)]
pub(super) struct Sink<'o> {
    pub(super) grid: Grid,
    pub(super) out: &'o mut [u8],
    pub(super) segments: u16,
    pub(super) refs: u16,
}

impl Sink<'_> {
    /// The segments of all paths, in the order of the paths and their points; of a cancelled edge what is left.
    #[expect(clippy::indexing_slicing, reason = "bounded by the loop")]
    pub(super) const fn take(&mut self, paths: &[Path<'_>]) -> Result<(), SegmentMapError> {
        let mut i = 0;
        while i < paths.len() {
            let path = &paths[i];
            let (against, count) = (reversed(path), edges(path));
            let mut k = 0;
            while k < count {
                let (a, b) = (point(path, k), point(path, k + 1));
                let edge = if against { Edge::between(b, a) } else { Edge::between(a, b) };
                let place = Place { path: i, point: k };
                let taken = match path.kind {
                    PathKind::Solid | PathKind::Hole => self.left(paths, place, &edge),
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
    #[expect(clippy::indexing_slicing, reason = "a path that is being looked at exists")]
    const fn left(&mut self, paths: &[Path<'_>], place: Place, edge: &Edge) -> Result<(), SegmentMapError> {
        let flags = paths[place.path].flags;
        let (mut t, mut from) = (0, -1);
        while t < edge.len {
            let (until, left) = left_from(paths, place, edge, t);
            if left && from < 0 {
                from = t;
            }
            if from >= 0 && (!left || until >= edge.len) {
                let to = if left { until } else { t };
                let piece = Edge { a: edge.at(from), dir: edge.dir, len: to.wrapping_sub(from) };
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
    const fn both(&mut self, place: Place, edge: &Edge, flags: u8) -> Result<(), SegmentMapError> {
        let back = Edge { a: edge.at(edge.len), dir: edge.dir.reversed(), len: edge.len };
        match self.put(place, edge, Kind::Wall, flags) {
            Ok(()) => self.put(place, &back, Kind::Wall, flags),
            Err(e) => Err(e),
        }
    }

    const fn put(&mut self, place: Place, edge: &Edge, kind: Kind, flags: u8) -> Result<(), SegmentMapError> {
        let (path, point) = (place.path as u32, place.point as u32);
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
