//! Tiles that are flipped or turned.

use tilesat::TileShape;

/// The three flip bits of a tile in a layer. Tiled writes a quarter turn as two of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct Flip {
    /// Rows become columns. This flip comes first.
    pub diagonal: bool,
    /// Left becomes right.
    pub horizontal: bool,
    /// Top becomes bottom.
    pub vertical: bool,
}

impl Flip {
    /// The tile after the flip.
    ///
    /// After empty and full come groups of four that turn right. Halves and one-way edges go by
    /// side, from the top. All others go by corner, from the top left. The diagonal keeps the
    /// corners on it, and makes mild slopes steep.
    pub fn of(self, shape: TileShape) -> TileShape {
        let id = shape as usize;
        if id < 2 {
            return shape;
        }
        let (mut group, mut turn) = ((id - 2) / 4, (id - 2) % 4);
        let sides = matches!(group, 0 | 8);
        if self.diagonal {
            turn = if sides { 3 - turn } else { (4 - turn) % 4 };
            // Groups 4 to 7 are mild low, mild high, steep low and steep high.
            group ^= if (4..8).contains(&group) { 2 } else { 0 };
        }
        if self.horizontal {
            turn = if sides { (4 - turn) % 4 } else { turn ^ 1 };
        }
        if self.vertical {
            turn = if sides { (6 - turn) % 4 } else { 3 - turn };
        }
        TileShape::ALL[2 + group * 4 + turn]
    }
}
