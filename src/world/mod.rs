//! Levels: what is solid, its surface, and queries about both.
//!
//! A [`TileMap`] reads a level from the bytes that it is stored as, usually in flash. It answers:
//!
//! | question | call | answer |
//! |---|---|---|
//! | does this shape overlap the solid? | [`overlaps`](TileMap::overlaps) | strict, exact |
//! | does it touch the solid? | [`touches`](TileMap::touches) | closed, exact |
//! | which tiles are here? | [`tiles_in`](TileMap::tiles_in) | strict; every tile of the map, solid or not |
//! | which flags does this shape touch? | [`flags_touched`](TileMap::flags_touched) | closed; every tile of the map, solid or not; also of other levels and [pairs](Joined::flags_touched) |
//! | which surface does this body run into? | [`cast_shape`](TileMap::cast_shape) | the start of an overlap; exact |
//! | what does this ray hit? | [`cast_ray`](TileMap::cast_ray), [`cast_ray_all`](TileMap::cast_ray_all) | solids are closed; one-way edges by an option |
//! | does this point see that one? | [`line_of_sight`](TileMap::line_of_sight) | solids are closed |
//! | which parts of the surface does this body overlap, how deep, and which push leads out? | [`contacts`](TileMap::contacts) | nearest first, each once |
//! | which point of the surface is nearest? | [`closest_point`](TileMap::closest_point) | exact order; inside or outside |
//! | which faces, arcs and vertices are near? | [`features`](TileMap::features) | the surface of the solid, and one-way edges |
//!
//! A [`SegmentMap`] reads a level of free line segments, polygons and chains, also from bytes. It
//! answers the same questions, except those about tiles. A [`Joined`] pair of levels, of either
//! kind, is one level without a seam. Moving platforms and doors are [`Solids`], or
//! [`ConvexSolids`] if they are not boxes; you join them to a level. A level that moves is
//! [`Placed`]. Rays hit these, too, and [`Solids::key_of`] returns the key of the solid that was
//! hit.
//!
//! # Shapes and levels
//!
//! Every level answers for these shapes. "none" says that the verb does not exist, and why:
//!
//! | shape | `overlaps`, `touches` | `contacts`, `escape`, `turn` | `cast_shape`, movers | `ride`, `ride_convex` |
//! |---|---|---|---|---|
//! | `Aabb`, `Circle` | yes | yes | yes | yes |
//! | `Capsule` | yes | yes | upright or level; a slanted one as an `AnyShape` | as casts |
//! | `OrientedBox`, `ConvexPolygon` | yes | yes | yes | yes |
//! | `AnyShape` | yes | yes | yes, if it has area or a radius | as casts |
//! | `Compound` | its bounding box first, then its parts | the deepest part for each feature | the earliest part | yes |
//! | `Segment` | none: as an `AnyShape` | none: it has no inside that could be pushed out | none: [`line_of_sight`](TileMap::line_of_sight) tests the whole segment | none: nothing to carry |
//! | a point (`Vec2`) | a box without size | none: as a segment | `cast_ray` | none: as a segment |
//!
//! `distance` and `manifold` exist only for two shapes. The nearest point of a level is
//! [`closest_point`](TileMap::closest_point), and two points of contact are two contacts.
//!
//! A world that is larger than the coordinates allow is cut into [`Rooms`], whose borders affect no
//! body.
//!
//! Movers use a level only through [`World`].

mod cell;
mod closest;
mod contacts;
mod convex;
mod convex_bodies;
mod error;
mod grid;
mod joined;
mod level;
mod lines;
mod measure;
mod methods;
mod placed;
mod probes;
mod ray;
mod rooms;
mod segment_map;
mod solids;
mod tangent;
#[cfg(test)]
mod tests;
mod tile_map;
mod trail;

pub use cell::Cell;
pub(crate) use cell::{Block, Cells, Way};
pub use closest::{Near, OneWay};
pub(crate) use contacts::contacts as contacts_of;
pub use contacts::{Pushable, WorldContact};
pub(crate) use convex::ConvexBody;
pub use error::{SegmentFault, SegmentMapError, TileMapError};
pub use grid::Grid;
pub use joined::ray::JoinedRayHits;
pub use joined::{Joined, JoinedFeatures};
pub(crate) use level::{ANY_BODY, MotionPiece, Seen, corners_of, ends, normal, sealed};
pub use level::{Feature, Geometry, World};
pub(crate) use lines::BlockHit;
pub use placed::{Placed, PlacedFeatures, PlacedRayHits};
pub use probes::Probe;
pub(crate) use probes::probe;
pub use ray::world::RayWorld;
pub use ray::{Inside, RayHit, RayRules};
pub use rooms::{Room, Rooms};
pub use segment_map::{Path, PathKind, SegmentFeatures, SegmentMap, SegmentRayHits, Size};
pub use solids::Solids;
pub use solids::convex::{ConvexFeatures, ConvexSolids};
pub use solids::convex_ray::ConvexRayHits;
pub use solids::convex_solid::{ConvexSolid, SolidShape};
pub use solids::features::SolidFeatures;
pub use solids::ray::SolidRayHits;
pub use solids::solid::{Side, Solid};
pub(crate) use tangent::Tangent;
pub use tile_map::features::Features;
pub(crate) use tile_map::kind::Fill;
pub use tile_map::kind::{TileKind, TileKinds, TileShape};
pub use tile_map::ray::RayHits;
pub use tile_map::region::{TileAt, Tiles};
pub use tile_map::{AllShapes, Bits, Blocks, Bytes, Occupied, Outside, ShapeSet, Slopes, Store, TileMap};
pub(crate) use trail::Traced;
pub use trail::Trail;
