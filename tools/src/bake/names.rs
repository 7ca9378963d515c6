//! Converts names of a level file to Rust names.

use std::collections::{HashMap, HashSet};

/// Words that cannot name an item.
const KEYWORDS: &str = " as break const continue crate dyn else enum extern false fn for if impl in let loop match mod move mut pub ref \
                        return self static struct super trait true type unsafe use where while async await abstract become box do \
                        final gen macro override priv try typeof unsized virtual yield ";

/// A module name for each level: small letters, digits and underscores, each unique.
pub(crate) fn modules<'a>(names: impl Iterator<Item = &'a str>) -> Vec<String> {
    unique(names.map(module))
}

/// A name in small letters, digits and underscores. Rust may not accept it.
pub(crate) fn plain(name: &str) -> String {
    let letter = |c: char| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '_' };
    let name: String = name.chars().map(letter).collect();
    name.trim_matches('_').to_owned()
}

/// The module of a level whose name no other level has.
pub(crate) fn module(name: &str) -> String {
    let name = plain(name);
    let wrong =
        name.is_empty() || name.starts_with(|c: char| c.is_ascii_digit()) || KEYWORDS.contains(&format!(" {name} "));
    if wrong { format!("level_{name}").trim_matches('_').to_owned() } else { name }
}

/// A constant name for each flag: `FLAG_` and the name in capitals, each unique.
pub(crate) fn constants<'a>(names: impl Iterator<Item = &'a str>) -> Vec<String> {
    capitals("FLAG_", names)
}

/// A constant for each object: `OBJECT_` and the name in capitals, each one different.
pub(crate) fn objects<'a>(names: impl Iterator<Item = &'a str>) -> Vec<String> {
    capitals("OBJECT_", names)
}

fn capitals<'a>(prefix: &str, names: impl Iterator<Item = &'a str>) -> Vec<String> {
    let plain = |c: char| if c.is_ascii_alphanumeric() { c.to_ascii_uppercase() } else { '_' };
    unique(names.map(|name| format!("{prefix}{}", name.chars().map(plain).collect::<String>())))
}

/// A repeated name gets a number.
fn unique(names: impl Iterator<Item = String>) -> Vec<String> {
    let mut taken: HashSet<String> = HashSet::new();
    // All numbers of a name below this are taken. A level can have thousands of coins.
    let mut next: HashMap<String, usize> = HashMap::new();
    let mut all = Vec::new();
    for name in names {
        let mut free = name.clone();
        if taken.contains(&free) {
            let number = next.entry(name.clone()).or_insert(2);
            while taken.contains(&free) {
                free = format!("{name}_{number}");
                *number += 1;
            }
        }
        taken.insert(free.clone());
        all.push(free);
    }
    all
}
