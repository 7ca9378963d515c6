//! How a tile says its shape: by name, by N++'s number, turned by Tiled's flip bits.

use tilesat::TileShape;

/// `slope-bottom-left` for `SlopeBottomLeft`, and so on for all shapes.
pub fn name(shape: TileShape) -> String {
    let mut name = String::new();
    for c in format!("{shape:?}").chars() {
        if c.is_ascii_uppercase() && !name.is_empty() {
            name.push('-');
        }
        name.push(c.to_ascii_lowercase());
    }
    name
}

/// The shape of this name, without regard to case.
pub fn shape(text: &str) -> Option<TileShape> {
    TileShape::ALL.into_iter().find(|&s| name(s).eq_ignore_ascii_case(text))
}

/// The shape that N++ gives this number; its last four, 34 to 37, have no body and are not taken.
pub fn npp(number: &str) -> Option<TileShape> {
    let number: usize = number.parse().ok()?;
    TileShape::ALL.get(number).copied().filter(|_| number < 34)
}

/// The three flip bits of a tile in a layer. Tiled draws a quarter turn as two of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct Flip {
    /// Rows become columns. Comes first.
    pub diagonal: bool,
    /// Left becomes right.
    pub horizontal: bool,
    /// Top becomes bottom.
    pub vertical: bool,
}

impl Flip {
    /// What the tile is after the flip.
    ///
    /// After empty and full come groups of four that turn right: halves and one-way edges by side, from the top; all others by corner,
    /// from the top left. The diagonal keeps the corners on it and makes mild slopes steep.
    pub fn of(self, shape: TileShape) -> TileShape {
        let id = shape as usize;
        if id < 2 {
            return shape;
        }
        let (mut group, mut turn) = ((id - 2) / 4, (id - 2) % 4);
        let sides = matches!(group, 0 | 8);
        if self.diagonal {
            turn = if sides { 3 - turn } else { (4 - turn) % 4 };
            // Mild low, mild high, steep low, steep high are groups 4 to 7.
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
