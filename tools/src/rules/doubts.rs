//! Names that are nearly a word of the rules: most likely a slip of the pen.

use std::collections::BTreeSet;

use super::words::plain;

/// The words that make something solid or one-way.
const WORDS: [&str; 8] = ["collision", "solid", "collides", "collidable", "wall", "blocked", "oneway", "hole"];

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

fn near(name: &str) -> Option<&'static str> {
    let name = plain(name);
    // Names that differ at their start are other words: a ball is no wall.
    let like = |word: &&&str| {
        let most = if word.len() > 5 { 2 } else { 1 };
        let off = distance(&name, word).min(distance(name.strip_suffix('s').unwrap_or(&name), word));
        off <= most && off > 0 && name.chars().next() == word.chars().next()
    };
    WORDS.iter().find(like).copied()
}

/// How many letters must be added, left out or exchanged to make one name the other.
fn distance(a: &str, b: &str) -> usize {
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
        for (name, word) in [("Sollid", "solid"), ("sold", "solid"), ("Colision", "collision"), ("one-wai", "oneway")] {
            assert_eq!(near(name), Some(word), "{name}");
        }
        for name in ["Solid", "Walls", "One Way", "Ball", "Coin", "Water", "Kill", "Ladder", "Spike", "Ice", "Spawn"] {
            assert_eq!(near(name), None, "{name}");
        }
    }
}
