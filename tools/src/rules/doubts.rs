//! Names that are nearly a word of the rules: most likely a slip of the pen.

use std::collections::{BTreeMap, BTreeSet};

use super::names;
use super::words::{self, plain, several};
use crate::model::map::{Map, Placed};

/// The words that make something solid or one-way.
const WORDS: [&str; 8] = ["collision", "solid", "collides", "collidable", "wall", "blocked", "oneway", "hole"];

/// Words of the language that are as near as a slip of the pen, and are none.
const ORDINARY: [&str; 23] = [
    "walk",
    "well",
    "will",
    "wail",
    "wale",
    "wally",
    "hold",
    "home",
    "hope",
    "hose",
    "hoe",
    "hone",
    "hale",
    "holy",
    "sold",
    "block",
    "blocker",
    "booked",
    "backed",
    "bricked",
    "blockade",
    "collie",
    "collusion",
];

/// For each name that is a letter or two from a word of the rules: who it is, and what it may mean.
pub(super) fn near_misses<'a>(names: impl Iterator<Item = &'a str>) -> Vec<(String, String)> {
    let names: BTreeSet<&str> = names.map(str::trim).filter(|name| !name.is_empty()).collect();
    let near = names.into_iter().filter_map(|name| Some((name, near(name)?)));
    near.map(|(name, word)| {
        let what = format!("it is not a word of the rules, but close to '{word}': correct it, or add --flag {name}");
        (format!("the name '{name}'"), what)
    })
    .collect()
}

/// A doubt about each value of the property `shape` of a drawn tile that is no shape.
pub(super) fn shapes(map: &Map) -> Vec<(String, String)> {
    let mut found: BTreeMap<(usize, String), (u32, usize)> = BTreeMap::new();
    let tiles: BTreeSet<(usize, u32)> = map.palette.iter().filter_map(placed).collect();
    for (index, id) in tiles {
        let value = map.tilesets[index].tiles.get(&id).and_then(|tile| tile.properties.text("shape"));
        let value = value.filter(|value| !value.trim().is_empty() && names::shape(value.trim()).is_none());
        if let Some(value) = value {
            found.entry((index, value)).or_insert((id, 0)).1 += 1;
        }
    }
    let doubt = |((index, value), (id, count)): ((usize, String), (u32, usize))| {
        let what = format!(
            "the property shape '{value}' of {}, the first of them {id}, is no shape of the library, so it has no effect",
            several(count, "tile")
        );
        (format!("tileset '{}'", map.tilesets[index].name), what)
    };
    found.into_iter().map(doubt).collect()
}

fn placed(placed: &Placed) -> Option<(usize, u32)> {
    if let Placed::Tile { tileset, id, .. } = placed { Some((*tileset, *id)) } else { None }
}

fn near(name: &str) -> Option<&'static str> {
    // A name with a right word in it is of several words: blocked by.
    if words::has(name, &WORDS) {
        return None;
    }
    let name = plain(name);
    if ORDINARY.contains(&name.strip_suffix('s').unwrap_or(&name)) {
        return None;
    }
    // Names that differ at their start are other words: a ball is no wall.
    let like = |word: &&&str| {
        let most = if word.len() > 5 { 2 } else { 1 };
        let off = distance(&name, word).min(distance(name.strip_suffix('s').unwrap_or(&name), word));
        off <= most && off > 0 && name.chars().next() == word.chars().next()
    };
    WORDS.iter().find(like).copied()
}

/// How many letters must be added, left out or exchanged to make one name the other.
pub(super) fn distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.chars().enumerate() {
        let mut corner = i;
        row[0] = i + 1;
        for (j, y) in b.iter().enumerate() {
            let kept = corner + usize::from(x != *y);
            corner = row[j + 1];
            row[j + 1] = kept.min(row[j] + 1).min(corner + 1);
        }
    }
    row[b.len()]
}

#[cfg(test)]
mod tests {
    use super::near;

    #[test]
    fn near_misses_and_other_words() {
        for (name, word) in [("Sollid", "solid"), ("solidd", "solid"), ("Colision", "collision"), ("one-wai", "oneway")]
        {
            assert_eq!(near(name), Some(word), "{name}");
        }
        for name in [
            "Solid", "Walls", "One Way", "Ball", "Coin", "Water", "Kill", "Ladder", "Spike", "Ice", "Spawn", "Blocks",
            "Well", "Sold", "Home",
        ] {
            assert_eq!(near(name), None, "{name}");
        }
    }
}
