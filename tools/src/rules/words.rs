//! The words in a name, and which of them say that something is solid.

/// In the name of a layer.
pub(super) const COLLISION: &[&str] = &["collision", "collider", "solid"];
/// In the name of a layer, where nothing else says anything.
pub(super) const GUESS: &[&str] = &["wall", "ground", "terrain", "platform", "block", "obstacle"];
/// In the name of a value of `LDtk`.
pub(super) const VALUE: &[&str] =
    &["wall", "ground", "terrain", "platform", "block", "obstacle", "dirt", "stone", "rock", "brick", "earth"];
/// They turn a name into its contrary.
const NOT: &[&str] = &["no", "non", "not", "without"];

/// The words of a name in small letters: `solidTiles`, `Solid Tiles` and `SOLID_TILES2` are the
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

/// Whether a name has one of the words in it, alone or as a plural.
pub(super) fn has(name: &str, list: &[&str]) -> bool {
    let words = words(name);
    let is = |word: &String| list.iter().any(|known| word == known || word.strip_suffix('s') == Some(known));
    words.iter().any(is) && !words.iter().any(|word| NOT.contains(&word.as_str()))
}

/// A name without regard to case, hyphens, underscores and spaces.
pub(super) fn plain(name: &str) -> String {
    name.chars().filter(|c| !"-_ ".contains(*c)).flat_map(char::to_lowercase).collect()
}

/// Whether two names are the same for a user who types one of them.
pub(crate) fn same(a: &str, b: &str) -> bool {
    plain(a) == plain(b)
}
