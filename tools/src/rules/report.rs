//! Records which rule made which part solid.

use std::fmt;

/// The first rule that applies to a tile counts. See [`ground`](super::ground).
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Rule {
    /// The user's option.
    Option,
    /// The tile's class, a true property, `shape` or `npp`.
    A,
    /// Its shapes of the collision editor.
    B,
    /// Its layer is a collision layer.
    C,
    /// A guess by the name of the layer, or the name of an `LDtk` value.
    D,
}

impl fmt::Display for Rule {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Option => "option",
            Self::A => "a",
            Self::B => "b",
            Self::C => "c",
            Self::D => "d",
        })
    }
}

/// A rule that was used.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Applied {
    pub rule: Rule,
    /// The name that it used, and the result for the tiles.
    pub what: String,
    /// Tiles that were placed, or objects.
    pub tiles: u64,
}

/// The rules used so far.
#[derive(Debug, Clone, Default)]
pub(super) struct Ledger(pub(super) Vec<Applied>);

impl Ledger {
    pub(super) fn add(&mut self, rule: Rule, what: &str, tiles: u64) {
        match self.0.iter_mut().find(|known| known.rule == rule && known.what == what) {
            Some(known) => known.tiles += tiles,
            None => self.0.push(Applied { rule, what: what.to_owned(), tiles }),
        }
    }

    /// Takes back one of what a rule made solid.
    pub(super) fn take(&mut self, what: &str) {
        if let Some(known) = self.0.iter_mut().find(|known| known.what == what) {
            known.tiles -= 1;
        }
        self.0.retain(|known| known.tiles > 0);
    }
}
