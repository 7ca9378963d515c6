//! From bytes to a map: everything is checked once, so that no query has to.

use super::bytes::{HEADER, MAGIC, VERSION, at, checksum, half, word};
use super::seg::MOST;
use super::{SegmentFault, SegmentMap, SegmentMapError, Size};
use crate::num::{Fx, Vec2};
use crate::world::Grid;

impl<'a> SegmentMap<'a> {
    /// A view of a level in its byte form, as [`build_into`](Self::build_into) writes it.
    ///
    /// Nothing is copied: `include_bytes!` is enough, at any alignment. All that queries rely on is checked, so that no bytes can make them panic or
    /// loop: that the level is one that could have been built, with all that meets each cell, and every winding number. (Whether the polygons
    /// close is not.) Usable in constants, where a damaged file is a compile error and the program pays nothing.
    ///
    /// Cost: each byte for the checksum, each reference twice (to find it among those of its cell, and for the winding numbers).
    ///
    /// # Errors
    /// [`SegmentMapError`]: what is wrong and where. Any change of a single byte and any other length is refused.
    pub const fn from_bytes(data: &'a [u8]) -> Result<Self, SegmentMapError> {
        let size = match header(data) {
            Ok(size) => size,
            Err(e) => return Err(e),
        };
        let (stored, computed) = (word(data, at::CHECKSUM), checksum(data));
        if stored != computed {
            return Err(SegmentMapError::Checksum { stored, computed });
        }
        let map = size.view(data);
        match map.verify() {
            Ok(()) => Ok(map),
            Err(e) => Err(e),
        }
    }
}

/// The size of a level, if the header is right and the bytes are as many as it says.
const fn header(data: &[u8]) -> Result<Size, SegmentMapError> {
    if data.len() < HEADER {
        return Err(SegmentMapError::Length { needed: HEADER as u32, found: data.len() as u32 });
    }
    if word(data, at::MAGIC) != MAGIC {
        return Err(SegmentMapError::NotSegments);
    }
    let version = half(data, at::VERSION);
    if version as u8 != VERSION {
        return Err(SegmentMapError::Version(version as u8));
    }
    if version >> 8 != 0 || half(data, at::RESERVED) != 0 {
        return Err(SegmentMapError::Reserved);
    }
    let origin = Vec2::from_raw(word(data, at::ORIGIN_X) as i32, word(data, at::ORIGIN_Y) as i32);
    let cell = Fx::from_bits(word(data, at::CELL) as i32);
    let grid = match Grid::new(half(data, at::WIDTH), half(data, at::HEIGHT), cell, origin) {
        Ok(grid) => grid,
        Err(e) => return Err(SegmentMapError::Grid(e)),
    };
    if half(data, at::SEGMENTS) > MOST {
        return Err(SegmentMapError::Segment { index: MOST, fault: SegmentFault::TooMany });
    }
    let size = Size { grid, segments: half(data, at::SEGMENTS), refs: half(data, at::REFS) };
    if data.len() == size.bytes() {
        Ok(size)
    } else {
        Err(SegmentMapError::Length { needed: size.bytes() as u32, found: clamped(data.len()) })
    }
}

/// A number of bytes, saturating.
pub(super) const fn clamped(bytes: usize) -> u32 {
    if bytes > u32::MAX as usize { u32::MAX } else { bytes as u32 }
}
