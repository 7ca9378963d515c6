//! Paths, their bytes, and the bytes read by the documented table.

use tilesat::{Fx, Grid, Path, PathKind, SegmentMap, SegmentMapError, Vec2};

pub type Point = (i64, i64);

/// A path that owns its points, raw.
#[derive(Clone, Debug)]
pub struct Shape {
    pub kind: PathKind,
    pub points: Vec<Point>,
    pub flags: u8,
}

pub fn shape(kind: PathKind, points: &[Point]) -> Shape {
    Shape { kind, points: points.to_vec(), flags: 0 }
}

/// The same with all coordinates times `scale`, then moved.
pub fn placed(shapes: &[Shape], scale: i64, by: Point) -> Vec<Shape> {
    let place = |&(x, y): &Point| (x * scale + by.0, y * scale + by.1);
    shapes.iter().map(|s| Shape { points: s.points.iter().map(place).collect(), ..s.clone() }).collect()
}

pub fn with_paths<R>(shapes: &[Shape], f: impl FnOnce(&[Path<'_>]) -> R) -> R {
    let raw = |&(x, y): &Point| Vec2::from_raw(x as i32, y as i32);
    let points: Vec<Vec<Vec2>> = shapes.iter().map(|s| s.points.iter().map(raw).collect()).collect();
    let paths: Vec<Path<'_>> =
        shapes.iter().zip(&points).map(|(s, p)| Path::new(s.kind, p).with_flags(s.flags)).collect();
    f(&paths)
}

/// The bytes, in a buffer that is larger and not cleared.
pub fn bytes(shapes: &[Shape], cell: i64) -> Result<Vec<u8>, SegmentMapError> {
    with_paths(shapes, |paths| {
        let cell = Fx::from_bits(cell as i32);
        let size = SegmentMap::measure(paths, cell)?;
        let mut out = vec![0xa5; size.bytes() + 3];
        let used = SegmentMap::build_into(paths, cell, &mut out)?;
        assert_eq!((used, &out[used..]), (size.bytes(), &[0xa5; 3][..]));
        out.truncate(used);
        Ok(out)
    })
}

pub fn bytes_on(shapes: &[Shape], grid: Grid) -> Result<Vec<u8>, SegmentMapError> {
    with_paths(shapes, |paths| {
        let mut out = vec![0; SegmentMap::measure_on(paths, grid)?.bytes()];
        SegmentMap::build_on(paths, grid, &mut out)?;
        Ok(out)
    })
}

/// Built, read back as valid, and decoded.
pub fn level(shapes: &[Shape], cell: i64) -> Level {
    let bytes = bytes(shapes, cell).unwrap_or_else(|e| panic!("{e}: {shapes:?}"));
    SegmentMap::from_bytes(&bytes).unwrap_or_else(|e| panic!("{e}: {shapes:?}"));
    decode(&bytes)
}

pub const SOLID: u8 = 0;
pub const WALL: u8 = 1;
pub const ONE_WAY: u8 = 2;
pub const NONE: u16 = u16::MAX;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Seg {
    pub a: Point,
    pub dir: Point,
    pub len: i64,
    pub next: u16,
    pub kind: u8,
    pub start_joined: bool,
    pub end_joined: bool,
    pub flags: u8,
}

impl Seg {
    pub fn at(&self, t: i64) -> Point {
        (self.a.0 + t * self.dir.0, self.a.1 + t * self.dir.1)
    }

    pub fn b(&self) -> Point {
        self.at(self.len)
    }
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Level {
    pub origin: Point,
    pub cell: i64,
    pub width: i64,
    pub height: i64,
    pub segs: Vec<Seg>,
    /// Row after row.
    pub refs: Vec<Vec<u16>>,
    pub winding: Vec<i8>,
}

impl Level {
    /// The corner of a cell with the smaller coordinates.
    pub fn corner(&self, index: usize) -> Point {
        let (x, y) = (index as i64 % self.width, index as i64 / self.width);
        (self.origin.0 + x * self.cell, self.origin.1 + y * self.cell)
    }
}

pub fn decode(bytes: &[u8]) -> Level {
    let half = |at: usize| u16::from_le_bytes([bytes[at], bytes[at + 1]]);
    let word = |at: usize| i64::from(i32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()));
    assert_eq!(&bytes[..6], b"TSEG\x01\0");
    let (width, height) = (i64::from(half(20)), i64::from(half(22)));
    let (count, cells) = (usize::from(half(6)), (width * height) as usize);
    let seg = |i: usize| {
        let at = 32 + 24 * i;
        Seg {
            a: (word(at), word(at + 4)),
            dir: (word(at + 8), word(at + 12)),
            len: word(at + 16),
            next: half(at + 20),
            kind: bytes[at + 22] & 3,
            start_joined: bytes[at + 22] & 4 != 0,
            end_joined: bytes[at + 22] & 8 != 0,
            flags: bytes[at + 23],
        }
    };
    let offsets = 32 + 24 * count;
    let first = offsets + 2 * (cells + 1);
    let last = first + 2 * usize::from(half(24));
    let offset = |i: usize| usize::from(half(offsets + 2 * i));
    assert_eq!(bytes.len(), last + cells);
    Level {
        origin: (word(8), word(12)),
        cell: word(16),
        width,
        height,
        segs: (0..count).map(seg).collect(),
        refs: (0..cells).map(|i| (offset(i)..offset(i + 1)).map(|r| half(first + 2 * r)).collect()).collect(),
        winding: bytes[last..].iter().map(|&b| b as i8).collect(),
    }
}

/// Writes the checksum that the bytes should have.
pub fn repair(bytes: &mut [u8]) {
    if bytes.len() >= 32 {
        bytes[28..32].fill(0);
        let hash = bytes.iter().fold(0x811c_9dc5u32, |h, &b| (h ^ u32::from(b)).wrapping_mul(16_777_619));
        bytes[28..32].copy_from_slice(&hash.to_le_bytes());
    }
}
