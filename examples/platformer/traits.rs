//! What a tile's class and boolean properties say about it.

/// Solid wins over one-way; the flags are all other names, in the order of the tileset.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Traits {
    pub solid: bool,
    pub one_way: bool,
    pub flags: Vec<String>,
}

impl Traits {
    /// Names are compared without regard to case; empty ones say nothing.
    pub fn from_names(names: &[&str]) -> Self {
        let mut traits = Self::default();
        for name in names.iter().map(|n| n.trim()).filter(|n| !n.is_empty()) {
            match name.to_ascii_lowercase().as_str() {
                "collision" | "solid" => traits.solid = true,
                "oneway" => traits.one_way = true,
                _ if traits.flags.iter().any(|f| f.eq_ignore_ascii_case(name)) => {}
                _ => traits.flags.push((*name).to_owned()),
            }
        }
        traits
    }
}
