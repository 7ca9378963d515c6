//! The meaning of the identifier of an `LDtk` value. It is the name of a shape, then the names of
//! flags, joined by underscores: `Full`, `SlopeTopLeft_Ice`, `slope_top_left`, `Empty_Coin`.
//! Otherwise the words in it decide.

use tilesat::TileShape;

use super::words::{self, COLLISION, VALUE};
use super::{Rule, traits};

/// The shape and the flags in an identifier: the words that name a shape, then flags. `None` if the
/// identifier is itself a flag.
pub(super) fn meaning(identifier: &str) -> Option<(Rule, TileShape, Vec<String>)> {
    let parts: Vec<&str> = identifier.split('_').collect();
    for count in (1..=parts.len()).rev() {
        let (name, flags) = parts.split_at(count);
        let name = name.concat();
        let plain = |shape: &TileShape| name.eq_ignore_ascii_case(&format!("{shape:?}"));
        if let Some(shape) = TileShape::ALL.into_iter().find(plain) {
            return Some((Rule::A, shape, owned(flags)));
        }
    }
    // One way says more than the other words.
    if words::is_one_way(identifier) {
        let count = (1..parts.len()).find(|&count| words::is_one_way(&parts[..count].join("_")));
        return Some((Rule::A, TileShape::OneWayUp, owned(&parts[count.unwrap_or(parts.len())..])));
    }
    // `Wall` is among the words below as well: authors often use it for values.
    let full = |name: &str| !words::has(name, VALUE) && traits::shape(name).is_some();
    if let Some(count) = (1..=parts.len()).rev().find(|&count| full(&parts[..count].concat())) {
        return Some((Rule::A, TileShape::Full, owned(&parts[count..])));
    }
    let by_word = [(Rule::D, VALUE), (Rule::C, COLLISION)].into_iter().find(|(_, list)| words::has(identifier, list));
    by_word.map(|(rule, _)| (rule, TileShape::Full, Vec::new()))
}

fn owned(flags: &[&str]) -> Vec<String> {
    flags.iter().filter(|flag| !flag.is_empty()).map(|flag| (*flag).to_owned()).collect()
}
