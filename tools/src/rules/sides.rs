//! Tiles that name the sides from which they block: `collideUp`, `ge_collide_left`. All four are a
//! full tile, and one alone is a one-way tile.

use tilesat::TileShape;

use super::options::Options;
use super::words;
use crate::model::tileset::Tile;

/// The properties of a tile that name sides.
#[derive(Debug, Default)]
pub(super) struct Sides<'a> {
    /// The sides that block: top, right, bottom, left.
    blocks: [bool; 4],
    /// The properties that are true.
    pub(super) names: Vec<&'a str>,
}

impl<'a> Sides<'a> {
    /// `None` if no property names a side.
    pub(super) fn of(tile: &'a Tile, options: &Options) -> Option<Self> {
        let mut sides = Self::default();
        let mut any = false;
        for (name, value) in &tile.properties.0 {
            let Some(side) = words::blocked_side(name).filter(|_| !options.is_flag(name)) else { continue };
            any = true;
            if value.is_true() || value.is_one() {
                sides.blocks[side] = true;
                sides.names.push(name);
            }
        }
        any.then_some(sides)
    }

    /// The shape that blocks from these sides. `None` if the library has none.
    pub(super) fn shape(&self) -> Option<TileShape> {
        match self.blocks {
            [true, true, true, true] => Some(TileShape::Full),
            [true, false, false, false] => Some(TileShape::OneWayUp),
            [false, true, false, false] => Some(TileShape::OneWayRight),
            [false, false, true, false] => Some(TileShape::OneWayDown),
            [false, false, false, true] => Some(TileShape::OneWayLeft),
            _ => None,
        }
    }

    /// Whether it blocks from some sides, and no shape does that.
    pub(super) fn is_unclear(&self) -> bool {
        !self.names.is_empty() && self.shape().is_none()
    }

    /// Whether it blocks from no side, as its author says.
    pub(super) fn is_none(&self) -> bool {
        self.names.is_empty()
    }

    /// `the properties 'collideLeft', 'collideUp'`.
    pub(super) fn what(&self) -> String {
        let names: Vec<String> = self.names.iter().map(|name| format!("'{name}'")).collect();
        format!("{} {}", if names.len() == 1 { "property" } else { "properties" }, names.join(", "))
    }
}
