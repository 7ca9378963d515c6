//! The traits of a tile, from its names and properties.

use tilesat::TileShape;

use super::words::{is_one_way, plain};
use super::{doubts, names};

/// The names that make a tile full.
const FULL: [&str; 8] = ["collision", "solid", "collide", "collides", "collidable", "collider", "wall", "blocked"];

/// The trait of a class or of the name of a true property: the shape of a tile, or nothing known.
pub(super) fn shape(name: &str) -> Option<TileShape> {
    let text = plain(name);
    let is = |known: &str| text == known || text.strip_suffix('s') == Some(known);
    if FULL.into_iter().any(is) {
        return Some(TileShape::Full);
    }
    let edges = || TileShape::ALL.into_iter().filter(|shape| names::is_one_way(*shape));
    let known = || edges().find(|shape| plain(&names::name(*shape)) == text);
    is_one_way(name).then(|| known().unwrap_or(TileShape::OneWayUp))
}

/// The shape that one of these names gives, and that name. One-way says more than solid.
pub(super) fn named<'a>(names: impl Iterator<Item = &'a str>) -> Option<(&'a str, TileShape)> {
    let known = names.filter_map(|name| Some((name, shape(name)?)));
    known.min_by_key(|(_, shape)| *shape == TileShape::Full)
}

/// The shape that the properties `shape` and `npp` name. Games use the word `shape` for other
/// things.
///
/// # Errors
///
/// If one is nearly a shape, or the number is none of N++, or the two name different ones.
pub(super) fn by_property(shape: Option<&str>, npp: Option<&str>) -> Result<Option<TileShape>, String> {
    let shape = shape.map(str::trim).filter(|text| !text.is_empty());
    let named = shape.and_then(|text| match names::shape(text) {
        None if !is_nearly_a_shape(text) => None,
        known => Some(known.ok_or_else(|| {
            format!(
                "property shape '{text}' is not a shape; name one such as slope-bottom-left (see tilesat help rules)"
            )
        })),
    });
    let numbered = npp.map(str::trim).map(|text| {
        names::npp(text)
            .ok_or_else(|| format!("property npp '{text}' is not a shape of N++; give a number from 0 to 33"))
    });
    match (named.transpose()?, numbered.transpose()?) {
        (Some(a), Some(b)) if a != b => {
            let (name, other) = (names::name(a), names::name(b));
            Err(format!("property shape '{name}' and property npp '{}' ({other}) differ", b as u8))
        }
        (a, b) => Ok(a.or(b)),
    }
}

/// A slip of the pen in a name of several words.
fn is_nearly_a_shape(text: &str) -> bool {
    let text = text.to_lowercase();
    let Some((first, _)) = text.split_once('-') else { return false };
    let near = |name: String| name.split('-').next() == Some(first) || doubts::distance(&text, &name) <= 2;
    TileShape::ALL.into_iter().any(|shape| near(names::name(shape)))
}
