//! The words in a name, and those that mean a solid.

/// In the name of a layer.
pub(super) const COLLISION: &[&str] = &["collision", "collider", "solid"];
/// In the name of a layer, if nothing else decides.
pub(super) const GUESS: &[&str] = &["wall", "ground", "terrain", "platform", "block", "obstacle"];
/// In the name of a value of `LDtk`.
pub(super) const VALUE: &[&str] =
    &["wall", "ground", "terrain", "platform", "block", "obstacle", "dirt", "stone", "rock", "brick", "earth"];
/// They reverse the meaning of a name.
const NOT: &[&str] = &["no", "non", "not", "without"];

/// The words of a name in small letters. `solidTiles`, `Solid Tiles` and `SOLID_TILES2` have the
/// same two.
fn words(name: &str) -> Vec<String> {
    let mut words: Vec<String> = Vec::new();
    let (mut word, mut before) = (String::new(), ' ');
    for c in name.chars().chain([' ']) {
        let ends = !c.is_alphabetic() || c.is_uppercase() && before.is_lowercase();
        if ends && !word.is_empty() {
            words.push(std::mem::take(&mut word));
        }
        if c.is_alphabetic() {
            word.extend(c.to_lowercase());
        }
        before = c;
    }
    words
}

/// Whether a name contains one of the words, or its plural.
pub(super) fn has(name: &str, list: &[&str]) -> bool {
    let words = words(name);
    let is = |word: &String| list.iter().any(|known| word == known || word.strip_suffix('s') == Some(known));
    words.iter().any(is) && !words.iter().any(|word| NOT.contains(&word.as_str()))
}

/// A name without case, hyphens, underscores and spaces.
pub(super) fn plain(name: &str) -> String {
    name.chars().filter(|c| !"-_ ".contains(*c)).flat_map(char::to_lowercase).collect()
}

/// Whether two names are equal for a user who types one of them.
pub(crate) fn same(a: &str, b: &str) -> bool {
    plain(a) == plain(b)
}

/// `1 tile`, `2 tiles`.
pub(super) fn several(count: usize, what: &str) -> String {
    format!("{count} {what}{}", if count == 1 { "" } else { "s" })
}
