//! Hashes the library's values: every field, in the order of its declaration.
//!
//! Counters of work are an exception: they are not part of an answer. They have separate families
//! (`work`), so that a search that takes another way to the same answers changes only those.

use tilesat::broad::{BroadError, BroadHit, Handle, Nearest, Pair, QueryError};
use tilesat::motion::{BodyHit, MoveError, Moved, Ridden, Walked, Work};
use tilesat::world::{Cell, Feature, Geometry, Near, RayHit, TileAt, WorldContact};
use tilesat::{
    Aabb, Axis, Capsule, CastHit, Circle, Contact, Fx, Hit, OrientedBox, Quantity, RangeError, Ratio, Toi, UnitVec2,
    Vec2,
    error::Truncated,
    motion::{Ride, Speed, Stuck, Support},
    query::MovingHit,
};

use super::hash::{Encode, Hash};

/// What the cast of a body finds.
pub(crate) type BodyFound<B> = Result<Option<BodyHit<B>>, RangeError>;

/// A type by an expression for each of its fields.
macro_rules! fields {
    ($(|$value:ident: $type:ty| $($field:expr),+;)+) => {
        $(impl Encode for $type {
            #[inline]
            fn encode(self, hash: &mut Hash) {
                let $value = self;
                $($field.encode(hash);)+
            }
        })+
    };
}

fields! {
    |v: Fx| v.to_bits();
    |v: Vec2| v.raw().0, v.raw().1;
    |a: Axis| a.x, a.y;
    |u: UnitVec2| u.raw().0, u.raw().1;
    |t: Toi| t.raw();
    |r: Ratio| r.raw();
    |s: Speed| s.squared();
    |b: Aabb| b.min(), b.max();
    |c: Circle| c.centre(), c.radius();
    |c: Capsule| c.a(), c.b(), c.radius();
    |b: OrientedBox| b.centre(), b.along(), b.across(), b.radius();
    |e: RangeError| quantity(e.what), e.value;
    |t: Truncated| t.seen, t.kept;
    |h: CastHit| h.toi, h.axis, h.displacement, h.inside;
    |h: MovingHit| h.toi, h.axis, h.displacement, h.displacement_b, h.inside;
    |c: Contact| c.axis(), c.normal(), c.depth(), c.point_on_a(), c.point_on_b(), c.is_degenerate();
    |c: Cell| c.x, c.y;
    |f: Feature| f.geometry, f.cell, f.index, f.flags, f.one_way, f.source;
    |n: Near| n.point, n.distance, n.axis, n.inside, n.feature;
    |c: WorldContact| c.feature(), c.axis(), c.depth(), c.is_degenerate(), c.push_out(), c.point();
    |h: RayHit| h.toi, h.point, h.axis, h.cell, h.index, h.flags, h.one_way, h.source, h.inside;
    |t: TileAt| t.cell, t.id, t.kind.shape as u8, t.kind.flags;
    |h: Hit| h.toi, h.axis, h.cell, h.index, h.flags, h.one_way, h.source;
    |s: Support| s.axis, s.cell, s.index, s.flags, s.one_way, s.source;
    |w: Work| w.iterations, w.features, w.checks;
    |s: Stuck| s.at;
    |h: Handle| h.slot(), h.generation();
    |p: Pair| p.a, p.b;
    |n: Nearest| n.handle, n.distance;
    |h: BroadHit| h.handle, h.toi;
}

impl Encode for Geometry {
    fn encode(self, hash: &mut Hash) {
        match self {
            Self::Face { a, dir, len, joined } => {
                0u32.encode(hash);
                a.encode(hash);
                dir.encode(hash);
                len.encode(hash);
                joined.encode(hash);
            }
            Self::Vertex { p, e_in, e_out } => {
                1u32.encode(hash);
                p.encode(hash);
                [e_in, e_out].encode(hash);
            }
            Self::Arc { centre, radius, quadrant, convex } => {
                2u32.encode(hash);
                centre.encode(hash);
                radius.encode(hash);
                quadrant.encode(hash);
                convex.encode(hash);
            }
            _ => 3u32.encode(hash),
        }
    }
}

/// By name: a release does not promise the order of the declaration.
fn quantity(what: Quantity) -> u32 {
    match what {
        Quantity::X => 1,
        Quantity::Y => 2,
        Quantity::Radius => 3,
        Quantity::HalfExtent => 4,
        Quantity::Width => 5,
        Quantity::Height => 6,
        Quantity::MotionX => 7,
        Quantity::MotionY => 8,
        Quantity::BodySize => 9,
        Quantity::Snap => 10,
        Quantity::Follow => 11,
        Quantity::Length => 12,
        Quantity::StepHeight => 13,
        Quantity::Assist => 15,
        Quantity::Capsule => 16,
        Quantity::Area => 17,
        Quantity::EndX => 18,
        Quantity::EndY => 19,
        _ => 0,
    }
}

impl Encode for MoveError {
    fn encode(self, hash: &mut Hash) {
        match self {
            Self::Range(error) => (1u32, error).encode(hash),
            Self::Stuck(stuck) => (2u32, stuck).encode(hash),
            _ => 3u32.encode(hash),
        }
    }
}

impl Encode for QueryError {
    fn encode(self, hash: &mut Hash) {
        match self {
            Self::Range(error) => (1u32, error).encode(hash),
            Self::Truncated(cut) => (2u32, cut).encode(hash),
            _ => 3u32.encode(hash),
        }
    }
}

impl Encode for BroadError {
    fn encode(self, hash: &mut Hash) {
        match self {
            Self::Full { capacity } => (1u32, capacity).encode(hash),
            Self::Stale(handle) => (2u32, handle).encode(hash),
            Self::TooLarge { size, limit } => (3u32, (size, limit)).encode(hash),
            Self::OutOfWorld { x, y } => (4u32, (x, y)).encode(hash),
            _ => 5u32.encode(hash),
        }
    }
}

impl Encode for Ride {
    fn encode(self, hash: &mut Hash) {
        match self {
            Self::Free => 1u32.encode(hash),
            Self::Carried => 2u32.encode(hash),
            Self::Pushed { by, normal } => (3u32, (by, normal)).encode(hash),
            Self::Squashed { by, normal } => (4u32, (by, normal)).encode(hash),
        }
    }
}

impl<B: Encode> Encode for BodyHit<B> {
    fn encode(self, hash: &mut Hash) {
        self.hit.encode(hash);
        self.body.encode(hash);
        self.inside.encode(hash);
    }
}

impl<B: Encode> Encode for Moved<B> {
    fn encode(self, hash: &mut Hash) {
        self.body.encode(hash);
        [self.velocity, self.remaining].encode(hash);
        self.hits.len().encode(hash);
        for hit in &self.hits {
            hit.encode(hash);
        }
        [self.floor, self.wall, self.ceiling].encode(hash);
        self.flags.encode(hash);
    }
}

impl<B: Encode> Encode for Walked<B> {
    fn encode(self, hash: &mut Hash) {
        self.moved.encode(hash);
        self.floor.encode(hash);
        [self.stepped, self.snapped].encode(hash);
    }
}

impl<B: Encode> Encode for Ridden<B> {
    fn encode(self, hash: &mut Hash) {
        self.body.encode(hash);
        self.ride.encode(hash);
        self.motion.encode(hash);
        self.floor.encode(hash);
        self.carry.encode(hash);
    }
}
