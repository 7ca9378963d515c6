//! The names of shapes, and N++'s numbers for them.

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

/// Whether it has an inside. One-way edges have none.
pub(crate) fn is_solid(shape: TileShape) -> bool {
    (1..TileShape::OneWayUp as u8).contains(&(shape as u8))
}

/// Whether it is one edge that blocks from one side.
pub(crate) fn is_one_way(shape: TileShape) -> bool {
    shape as u8 >= TileShape::OneWayUp as u8
}

/// The shape of this name, ignoring case.
pub fn shape(text: &str) -> Option<TileShape> {
    TileShape::ALL.into_iter().find(|&s| name(s).eq_ignore_ascii_case(text))
}

/// The shape with this number in N++. Its last four, 34 to 37, have no body and are refused.
pub fn npp(number: &str) -> Option<TileShape> {
    let number: usize = number.parse().ok()?;
    TileShape::ALL.get(number).copied().filter(|_| number < 34)
}
