//! What a tile's class and properties say about it.

use tilesat::TileShape;

use super::names;

/// Its shape, and the names of its flags in the order of the tileset.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Traits {
    pub shape: TileShape,
    pub flags: Vec<String>,
}

impl Traits {
    /// From the class and the names of the true properties: solid wins over one-way, all other names are flags. Names are compared
    /// without regard to case; empty ones say nothing.
    pub fn from_names(names: &[&str]) -> Self {
        let mut traits = Self::default();
        for name in names.iter().map(|n| n.trim()).filter(|n| !n.is_empty()) {
            match name.to_ascii_lowercase().as_str() {
                "collision" | "solid" => traits.shape = TileShape::Full,
                "oneway" if traits.shape == TileShape::Full => {}
                "oneway" => traits.shape = TileShape::OneWayUp,
                _ if traits.flags.iter().any(|f| f.eq_ignore_ascii_case(name)) => {}
                _ => traits.flags.push((*name).to_owned()),
            }
        }
        traits
    }

    /// With the shape that the properties `shape` and `npp` name, which wins over the class's.
    ///
    /// # Errors
    ///
    /// One of them names no shape, or the two name different ones.
    pub fn with_properties(mut self, shape: Option<&str>, npp: Option<&str>) -> Result<Self, String> {
        let shape = shape.map(str::trim).filter(|text| !text.is_empty());
        let named = shape.map(|text| {
            names::shape(text)
                .ok_or_else(|| format!("property shape '{text}' is no shape, such as slope-bottom-left (see --help)"))
        });
        let numbered = npp.map(str::trim).map(|text| {
            names::npp(text).ok_or_else(|| format!("property npp '{text}' is no shape of N++, a number from 0 to 33"))
        });
        self.shape = match (named.transpose()?, numbered.transpose()?) {
            (Some(a), Some(b)) if a != b => {
                let (name, other) = (names::name(a), names::name(b));
                return Err(format!("property shape '{name}' and property npp '{}' ({other}) differ", b as u8));
            }
            (Some(shape), _) | (None, Some(shape)) => shape,
            (None, None) => self.shape,
        };
        Ok(self)
    }
}
