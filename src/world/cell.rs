//! Cells of a grid.

/// A cell of a [`TileMap`](super::TileMap): column and row, counted from the map's origin.
///
/// ```text
///            x = 0   1   2        columns and rows -1, width and height
///  row -1  .   .   .   .   .      stand for everything beyond the map
///  row  0  . +---+---+---+ .
///  row  1  . |   | * |   | .      * is Cell { x: 1, y: 1 }
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Cell {
    /// Column; -1 and the map's width stand for everything left and right of it. Of a [solid](super::Solids) its key, in a row that no map has:
    /// see [`Solids::key_of`](super::Solids::key_of).
    pub x: i16,
    /// Row; -1 and the map's height stand for everything beyond the first and the last row.
    pub y: i16,
}

impl Cell {
    /// A cell from its column and row.
    #[must_use]
    pub const fn new(x: i16, y: i16) -> Self {
        Self { x, y }
    }

    /// For indices clamped to -1..=32767.
    pub(crate) const fn of(x: i32, y: i32) -> Self {
        Self { x: x as i16, y: y as i16 }
    }
}
