//! How a tile says its shape: by name, or by N++'s number.

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

/// Whether it has an inside; one-way edges have none.
pub(crate) fn is_solid(shape: TileShape) -> bool {
    (1..TileShape::OneWayUp as u8).contains(&(shape as u8))
}

/// Whether it is one edge that blocks from one side.
pub(crate) fn is_one_way(shape: TileShape) -> bool {
    shape as u8 >= TileShape::OneWayUp as u8
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
