//! One segment of a map, decoded.

use super::bytes::{SEGMENT, half, word};
use crate::num::{Axis, Raw};

/// What a segment is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::world) enum Kind {
    /// The boundary of a solid, which lies on the left of its direction.
    Solid,
    /// One face of a wall; another one runs the other way.
    Wall,
    /// Blocks what comes from its outward normal's side.
    OneWay,
}

/// A segment from `a` to `a + dir * len`; its outward normal is `(dir.y, -dir.x)`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::world) struct Seg {
    pub(in crate::world) a: Raw,
    /// Reduced.
    pub(in crate::world) dir: Axis,
    /// In multiples of `dir`, at least 1.
    pub(in crate::world) len: i32,
    /// The segment that leaves the convex vertex at the end; where there is none, there is no vertex.
    pub(in crate::world) next: Option<u16>,
    pub(in crate::world) kind: Kind,
    /// No vertex at the start: the boundary, or the one-way chain, goes on there.
    pub(in crate::world) start_joined: bool,
    /// The same at the end. Where it is not set and the segment is not one-way, `next` is there.
    pub(in crate::world) end_joined: bool,
    /// The user's flags.
    pub(in crate::world) flags: u8,
}

/// Segments are fewer than this: twice an index, and one for the vertex, is the index of a feature.
pub(super) const MOST: u16 = 1 << 15;

/// What `next` holds where there is no vertex.
pub(super) const NONE: u16 = u16::MAX;

/// The bits of the attribute byte.
pub(super) const KIND: u8 = 3;
pub(super) const START_JOINED: u8 = 4;
pub(super) const END_JOINED: u8 = 8;

/// Where the fields after the geometry are.
pub(super) const NEXT_AT: usize = 20;
pub(super) const ATTR_AT: usize = 22;

impl Seg {
    /// The end: inside the domain, so that nothing wraps.
    pub(in crate::world) const fn b(&self) -> Raw {
        Raw {
            x: self.a.x.wrapping_add(self.dir.x.wrapping_mul(self.len)),
            y: self.a.y.wrapping_add(self.dir.y.wrapping_mul(self.len)),
        }
    }

    /// Whether a point is on the closed segment. Distances inside the domain and directions are below 2^30: the product is below 2^61.
    pub(in crate::world) const fn holds(&self, p: Raw) -> bool {
        let (a, b) = (self.a, self.b());
        let beside = p.x < a.x && p.x < b.x || p.x > a.x && p.x > b.x;
        if beside || p.y < a.y && p.y < b.y || p.y > a.y && p.y > b.y {
            return false;
        }
        Raw { x: self.dir.x, y: self.dir.y }.cross(p.sub(a)) == 0
    }

    /// Segment `index` of a table; zeros beyond its end.
    #[inline]
    pub(super) const fn read(table: &[u8], index: u16) -> Self {
        let at = index as usize * SEGMENT;
        let next = half(table, at + NEXT_AT);
        let attr = half(table, at + ATTR_AT);
        Self {
            a: Raw { x: word(table, at) as i32, y: word(table, at + 4) as i32 },
            dir: Axis { x: word(table, at + 8) as i32, y: word(table, at + 12) as i32 },
            len: word(table, at + 16) as i32,
            next: if next == NONE { None } else { Some(next) },
            kind: match attr as u8 & KIND {
                0 => Kind::Solid,
                1 => Kind::Wall,
                _ => Kind::OneWay,
            },
            start_joined: attr as u8 & START_JOINED != 0,
            end_joined: attr as u8 & END_JOINED != 0,
            flags: (attr >> 8) as u8,
        }
    }
}
