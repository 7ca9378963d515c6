//! Messages in the words of those who draw levels.

use crate::support::{map, objects, run, scratch};

/// A point that is drawn twice in a row, as the last of a closed polygon often is, counts once.
#[test]
fn repeated_points_are_dropped() {
    let object =
        |points: &str| objects(&format!(r#"<object id="7" x="0" y="0"><polygon points="{points}"/></object>"#));
    let level = scratch("messages", "repeated.tmx", object("0,0 9,0 9,0 0,9 0,0"));
    let ran = run("bake", &level, &format!("-o {}", scratch("messages", "repeated.rs", "").display()));
    let note = "object 7 of layer 'L': 2 points are dropped: each is the same as the one before";
    assert!(ran.status == 0 && ran.out.contains(note), "{ran:?}");
    let ran = run("bake", level, "--json");
    assert!(ran.out.contains("\"segments\":3"), "{ran:?}");
}

/// The user knows objects, units and cells, and no numbers of the library.
#[test]
fn messages_in_the_words_of_the_user() {
    let object =
        |points: &str| objects(&format!(r#"<object id="7" x="8200" y="0"><polygon points="{points}"/></object>"#));
    let cases = [
        (
            object("0,0 9,0 0,9"),
            "object 7 of layer 'L' at (8200, 0): it is outside of the domain: coordinates stay below 8192 pixels; \
             move it, or --scale makes everything smaller",
        ),
        (
            object("0,0 900000,0 0,9"),
            "object 7 of layer 'L' at (908200, 0): it is outside of the domain: coordinates stay below 8192",
        ),
        (object("0,0 9,3 0,0"), "object 7 of layer 'L': it has no area, so it is not solid: give it one"),
        (
            map(3, 2, "0,0,0,0,0,99", ""),
            "layer 'World': 1 of its tiles are in no tileset, the first in column 2, row 1: 't' has no tile 98",
        ),
    ];
    for (text, why) in cases {
        let ran = run("bake", scratch("messages", "words.tmx", text), "--json");
        assert!(ran.status == 2 && ran.err.contains(why) && !ran.err.contains("path"), "{why} is not in {ran:?}");
    }
}
