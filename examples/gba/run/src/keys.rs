//! The player's script.

/// The numbers of libretro's pad.
const NAMES: [(&str, u32); 10] = [
    ("b", 0),
    ("select", 2),
    ("start", 3),
    ("up", 4),
    ("down", 5),
    ("left", 6),
    ("right", 7),
    ("a", 8),
    ("l", 10),
    ("r", 11),
];

/// The keys of each frame, a bit per key, from stretches such as `20:right+a`.
pub fn parse(text: &str) -> Result<Vec<u16>, String> {
    let mut frames = Vec::new();
    for stretch in text.split_whitespace() {
        let (count, names) = stretch.split_once(':').unwrap_or((stretch, ""));
        let count: usize = count.parse().map_err(|_| format!("{stretch}: a stretch begins with a number of frames"))?;
        let mut keys = 0;
        for name in names.split('+').filter(|name| !name.is_empty()) {
            let (_, id) =
                NAMES.iter().find(|key| key.0 == name).ok_or(format!("{stretch}: no key is called {name}"))?;
            keys |= 1 << id;
        }
        frames.resize(frames.len() + count, keys);
    }
    Ok(frames)
}
