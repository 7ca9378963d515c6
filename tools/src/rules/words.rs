//! The words in a name, and those that mean a solid.

/// In the name of a layer.
pub(super) const COLLISION: &[&str] =
    &["collision", "collider", "solid", "collide", "collidable", "blocked", "blocking"];
/// In the name of a layer, if nothing else decides.
pub(super) const GUESS: &[&str] = &["wall", "ground", "terrain", "platform", "block", "obstacle", "physics"];
/// In the name of a layer or a value, if not even those do. Seen from above, bodies walk on a
/// floor.
pub(super) const LAST: &[&str] = &["floor", "boundary", "boundaries", "barrier"];
/// The same in German, French, Spanish, Portuguese, Russian, Chinese and Japanese, if no English
/// word decides: collisions, walls and platforms.
#[rustfmt::skip]
pub(super) const WALLS_ABROAD: &[&str] = &[
    "kollision", "kollisionen", "mauer", "mauern", "wand", "wände", "waende", "plattform", "plattformen", "hindernis",
    "hindernisse", "mur", "paroi", "plateforme", "solide", "colisión", "colision", "colisiones", "pared", "paredes",
    "muro", "sólido", "solido", "plataforma", "obstáculo", "obstaculo", "colisão", "colisao", "colisões", "colisoes",
    "parede", "коллизи", "столкновени", "стена", "стены", "стенам", "стенк", "препятстви", "платформ", "碰撞", "墙",
    "牆", "障碍", "障礙", "平台", "衝突", "当たり判定", "壁", "足場", "障害物",
];
/// The same for ground, which bodies walk on if it is seen from above.
#[rustfmt::skip]
pub(super) const GROUND_ABROAD: &[&str] = &[
    "boden", "gelände", "gelaende", "erde", "sol", "terre", "suelo", "terreno", "tierra", "chão", "chao", "земля",
    "земли", "地面", "地形", "床",
];
/// What is drawn behind, or for the eye only.
const BEHIND: &[&str] =
    &["background", "backdrop", "bg", "behind", "parallax", "fake", "deco", "decor", "decoration", "decorative"];
/// The same in those languages, and their words for not.
#[rustfmt::skip]
const BEHIND_ABROAD: &[&str] = &[
    "hintergrund", "ohne", "kein", "keine", "fond", "arrière", "sans", "fondo", "sin", "fundo", "sem", "фон", "задн",
    "без", "背景", "后", "後", "无", "無", "非",
];
/// In the name of a value of `LDtk`.
pub(super) const VALUE: &[&str] =
    &["wall", "ground", "terrain", "platform", "block", "obstacle", "dirt", "stone", "rock", "brick", "earth"];
/// In the name of a value that is not solid even in a layer of collisions.
#[rustfmt::skip]
const FREE: &[&str] = &[
    "air", "empty", "none", "nothing", "void", "free", "sky", "hole", "pit", "gap", "abyss", "walkable",
    "passable", "water", "lava", "acid", "liquid", "ladder", "vine", "rope", "climb", "climbable", "stair",
    "coin", "item", "pickup", "spike", "hazard", "death", "kill", "trigger", "sensor", "event", "zone",
    "portal", "teleport", "teleporter", "warp", "spawn", "start", "entrance", "exit", "finish", "goal",
    "checkpoint", "player", "enemy", "npc",
];
/// In the name of a tile that bodies walk on.
const WALKABLE: &[&str] = &["walkable", "passable"];
/// In the name of one that they do not.
const BLOCKED: &[&str] = &["impassable", "impassible", "unpassable", "unwalkable"];
/// In the name of what only notices bodies.
const SENSOR: &[&str] = &["sensor", "trigger"];
/// In the name of a layer of things that bodies take.
const TAKEN: &[&str] = &["coin", "gem", "pickup", "collectible", "collectable"];
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

/// Whether a name contains one of the words, or its plural. A word of a guess does not count beside
/// one for what is drawn behind.
pub(super) fn has(name: &str, list: &[&str]) -> bool {
    mentions(name, list) && !any(&words(name), behind(list))
}

/// The same beside words for what is drawn behind.
pub(super) fn mentions(name: &str, list: &[&str]) -> bool {
    let words = words(name);
    any(&words, list) && !denies(&words)
}

/// The words beside which those of a list do not count.
fn behind(list: &[&str]) -> &'static [&'static str] {
    if list == WALLS_ABROAD || list == GROUND_ABROAD {
        BEHIND_ABROAD
    } else if list == GUESS || list == LAST || list == VALUE {
        BEHIND
    } else {
        &[]
    }
}

/// Words for what blocks bodies from above only.
const ONE_WAY: &[[&str; 2]] = &[
    ["one", "way"],
    ["semi", "solid"],
    ["solid", "top"],
    ["jump", "through"],
    ["jump", "thru"],
    ["pass", "through"],
    ["pass", "thru"],
    ["drop", "through"],
    ["drop", "thru"],
];

/// Whether these two words begin here, apart or as one word: `one way`, `onewayplatform`.
fn begins(words: &[String], [first, second]: [&str; 2]) -> bool {
    let together = |word: &String| word.strip_prefix(first).is_some_and(|rest| rest.starts_with(second));
    match words {
        [word, ..] if together(word) => true,
        [word, next, ..] => word == first && is(next, second),
        _ => false,
    }
}

/// Whether a name contains words for what blocks bodies from above only: one way, semi solid.
pub(super) fn is_one_way(name: &str) -> bool {
    let words = words(name);
    let at = |from: usize| ONE_WAY.iter().any(|two| begins(&words[from..], *two));
    (0..words.len()).any(at) && !denies(&words)
}

/// Whether a name says that something is not solid.
pub(super) fn is_free(name: &str) -> bool {
    let words = words(name);
    any(&words, FREE) || any(&words, BEHIND) || denies(&words)
}

/// Whether the name of a tile or of its property says that bodies walk there.
pub(super) fn is_walkable(name: &str) -> bool {
    has(name, WALKABLE)
}

/// Whether a name says that something only notices bodies.
pub(super) fn is_sensor(name: &str) -> bool {
    has(name, SENSOR)
}

/// Whether bodies pass the collision shapes in a layer of this name.
pub(super) fn is_passed(name: &str) -> bool {
    is_sensor(name) || has(name, TAKEN)
}

/// Whether the name of a tile or of its property says that bodies do not pass, in other words than
/// those of the rules.
pub(super) fn is_blocked(name: &str) -> bool {
    let words = words(name);
    let walkable = any(&words, WALKABLE);
    let blocks = (any(&words, COLLISION) || any(&words, BLOCKED)) && !denies(&words) && !is_one_way(name);
    blocks || walkable && denies(&words)
}

/// The words for the sides of a tile, clockwise from the top.
const SIDES: [&[&str]; 4] =
    [&["top", "up", "north"], &["right", "east"], &["bottom", "down", "south"], &["left", "west"]];

/// The side from which a tile blocks, if its name is about one side only: 0 is the top, and the
/// others follow clockwise.
pub(super) fn blocked_side(name: &str) -> Option<usize> {
    let words = words(name);
    let blocks = any(&words, COLLISION) || any(&words, BLOCKED);
    let named = |side: &&[&str]| words.iter().any(|word| side.contains(&word.as_str()));
    let mut sides = SIDES.iter().enumerate().filter(|(_, side)| named(side)).map(|(number, _)| number);
    let side = sides.next().filter(|_| blocks && !denies(&words));
    side.filter(|_| sides.next().is_none())
}

fn any(words: &[String], list: &[&str]) -> bool {
    words.iter().any(|word| list.iter().any(|known| is(word, known)))
}

/// What authors write behind another word, without a blank: `collisionlayer`, `WALLTILES`.
const ENDS: &[&str] = &["layer", "map", "tile", "object", "box", "shape", "grid", "mask"];

/// Whether a word is this one, or its plural, or begins with it and ends in one of [`ENDS`]. Words
/// of Russian have endings, and Chinese and Japanese have no blanks between words.
fn is(word: &str, known: &str) -> bool {
    let ends = |rest: &str| ENDS.iter().any(|end| rest.strip_prefix(end).is_some_and(|s| ["", "s", "es"].contains(&s)));
    match known.chars().next() {
        Some('\u{400}'..='\u{4ff}') => word.starts_with(known),
        Some('\u{3000}'..) => word.contains(known),
        _ => word.strip_prefix(known).is_some_and(|rest| {
            rest.is_empty() || rest == "s" || ends(rest) || rest.strip_prefix('s').is_some_and(ends)
        }),
    }
}

fn denies(words: &[String]) -> bool {
    words.iter().any(|word| NOT.contains(&word.as_str()))
}

/// A name without case, hyphens, underscores, spaces and line breaks.
pub(super) fn plain(name: &str) -> String {
    name.chars().filter(|c| !"-_".contains(*c) && !c.is_whitespace()).flat_map(char::to_lowercase).collect()
}

/// Whether two names are equal for a user who types one of them.
pub(crate) fn same(a: &str, b: &str) -> bool {
    plain(a) == plain(b)
}

/// `1 tile`, `2 tiles`.
pub(super) fn several(count: usize, what: &str) -> String {
    format!("{count} {what}{}", if count == 1 { "" } else { "s" })
}
