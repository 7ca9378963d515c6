//! Tiles as whole numbers, as the data of a level has them.

use crate::Scalar;
use crate::shape::Vector;
use crate::tile::{Polygon, Tile};

/// The kind of tile and the number of corners. Then five corners and five normals of a polygon, or
/// the centre of an arc and its direction. In raw units.
pub type RawTile = [i32; 22];

pub const EMPTY: i32 = 0;
pub const FULL: i32 = 1;
pub const POLYGON: i32 = 2;
pub const DISC: i32 = 3;
pub const HOLLOW: i32 = 4;

/// A tile in a number format.
///
/// # Panics
/// If there is no such tile.
pub fn tile<S: Scalar>(raw: &RawTile) -> Tile<S> {
    let vector = |i: usize| Vector::of_raw(raw[i], raw[i + 1]);
    let five = |from: usize| core::array::from_fn(|i| vector(from + 2 * i));
    let (centre, toward) = (vector(2), vector(4));
    match raw[0] {
        EMPTY => Tile::Empty,
        FULL => Tile::Full,
        POLYGON => Tile::Polygon(Polygon { corners: five(2), normals: five(12), count: raw[1] as usize }),
        DISC => Tile::Disc { centre, toward },
        HOLLOW => Tile::Hollow { centre, toward },
        kind => panic!("no tile is of the kind {kind}"),
    }
}
