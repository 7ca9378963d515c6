//! The layout of the bytes, and reading and writing them: little-endian, at any alignment, in constants too.
//!
//! | bytes | what |
//! |---|---|
//! | 32 | header |
//! | 24 a segment | segments |
//! | 2 a cell, and 2 | offsets into the references, row after row |
//! | 2 a reference | segment indices, ascending within a cell |
//! | 1 a cell | winding numbers of the reference points, signed |
//!
//! | header at | type | what |
//! |---|---|---|
//! | 0 | | `TSEG` |
//! | 4 | u8 | version, 1 |
//! | 5 | u8 | 0 |
//! | 6 | u16 | segments |
//! | 8, 12 | i32 | origin x, y |
//! | 16 | i32 | side of a cell |
//! | 20, 22 | u16 | columns, rows |
//! | 24 | u16 | references |
//! | 26 | u16 | 0 |
//! | 28 | u32 | checksum of everything, itself as zero |

pub(super) const MAGIC: u32 = u32::from_le_bytes(*b"TSEG");
pub(super) const VERSION: u8 = 1;
/// Bytes of the header.
pub(super) const HEADER: usize = 32;
/// Bytes of a segment.
pub(super) const SEGMENT: usize = 24;

/// Where the fields of the header are.
pub(super) mod at {
    pub(in crate::world::segment_map) const MAGIC: usize = 0;
    /// Version, a zero and the number of segments in one word.
    pub(in crate::world::segment_map) const VERSION: usize = 4;
    pub(in crate::world::segment_map) const SEGMENTS: usize = 6;
    pub(in crate::world::segment_map) const ORIGIN_X: usize = 8;
    pub(in crate::world::segment_map) const ORIGIN_Y: usize = 12;
    pub(in crate::world::segment_map) const CELL: usize = 16;
    pub(in crate::world::segment_map) const WIDTH: usize = 20;
    pub(in crate::world::segment_map) const HEIGHT: usize = 22;
    pub(in crate::world::segment_map) const REFS: usize = 24;
    pub(in crate::world::segment_map) const RESERVED: usize = 26;
    pub(in crate::world::segment_map) const CHECKSUM: usize = 28;
}

/// The bytes `from..to`; none where there are not so many.
pub(super) const fn part(data: &[u8], from: usize, to: usize) -> &[u8] {
    match data.split_at_checked(to) {
        Some((head, _)) => match head.split_at_checked(from) {
            Some((_, part)) => part,
            None => &[],
        },
        None => &[],
    }
}

/// 16 bits; 0 beyond the end. By a pattern, which no core needs a check of bounds for that could panic.
#[inline]
pub(super) const fn half(data: &[u8], at: usize) -> u16 {
    match data.split_at_checked(at) {
        Some((_, &[a, b, ..])) => u16::from_le_bytes([a, b]),
        _ => 0,
    }
}

/// 32 bits; 0 beyond the end.
#[inline]
pub(super) const fn word(data: &[u8], at: usize) -> u32 {
    match data.split_at_checked(at) {
        Some((_, &[a, b, c, d, ..])) => u32::from_le_bytes([a, b, c, d]),
        _ => 0,
    }
}

/// Writes 16 bits; nothing beyond the end.
pub(super) const fn set_half(data: &mut [u8], at: usize, value: u16) {
    if let Some((_, [a, b, ..])) = data.split_at_mut_checked(at) {
        [*a, *b] = value.to_le_bytes();
    }
}

/// Writes 32 bits; nothing beyond the end.
pub(super) const fn set_word(data: &mut [u8], at: usize, value: u32) {
    set_half(data, at, value as u16);
    set_half(data, at.wrapping_add(2), (value >> 16) as u16);
}

/// Writes a byte; nothing beyond the end.
#[expect(clippy::indexing_slicing, reason = "behind a comparison with the length")]
pub(super) const fn set_byte(data: &mut [u8], at: usize, value: u8) {
    if at < data.len() {
        data[at] = value;
    }
}

/// 32-bit FNV-1a with the checksum's own field as zero: each step is one-to-one in the state and in the byte, so that no change of a
/// single byte goes unseen.
#[expect(clippy::indexing_slicing, reason = "bounded by the loop")]
pub(super) const fn checksum(data: &[u8]) -> u32 {
    let (mut hash, mut i) = (0x811c_9dc5u32, 0);
    while i < data.len() {
        let byte = if i & !3 == at::CHECKSUM { 0 } else { data[i] };
        hash = (hash ^ byte as u32).wrapping_mul(0x0100_0193);
        i += 1;
    }
    hash
}
