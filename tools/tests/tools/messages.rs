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

/// What would settle a file that cannot be read. Saving a map again keeps its compression.
#[test]
fn unreadable_files_say_what_settles_it() {
    let good = map(1, 1, "1", "");
    let data = |form: &str, text: &str| good.replace("encoding=\"csv\">1<", &format!("{form}>{text}<"));
    let format = "set Tile Layer Format to CSV, and save the map";
    let (damaged, give) = ("the file is damaged: take a copy that Tiled opens", "give a .tmx, .tmj or .world");
    let gone = r#"<tileset firstgid="1" source="gone.tsx"/>"#;
    let gone = format!("{}{gone}{}", good.split("<tileset").next().unwrap(), good.split("</tileset>").nth(1).unwrap());
    let cases = [
        ("bad64.tmx", data(r#"encoding="base64""#, "!!!!"), "called base64: '!' at 0 is no sign of base64", damaged),
        ("badz.tmx", data(r#"encoding="base64" compression="zlib""#, "eJzzzz"), "called base64 and zlib: ", damaged),
        ("lzma.tmx", data(r#"encoding="base64" compression="lzma""#, "AAAA"), "there are zlib, gzip and zstd", format),
        ("hex.tmx", data(r#"encoding="hex""#, "01"), "encoding 'hex' is unknown; there are csv and base64", format),
        ("list.tmj", "[]".to_owned(), "not JSON of a level, which begins with {", give),
        ("list.ldtk", "[1]".to_owned(), "not JSON of a level, which begins with {", give),
        ("text.json", "\"a\"".to_owned(), "not JSON of a level, which begins with {", give),
        ("nothing.tmj", "{}".to_owned(), "it has no orientation", give),
        ("nothing.json", "{}".to_owned(), "it has no orientation", give),
        ("gone.tmx", gone, "gone.tsx: cannot read", "put it there, or open the map in Tiled, which asks where it is"),
    ];
    for (file, text, what, fix) in cases {
        let ran = run("bake", scratch("messages", file, text), "--json");
        let line = ran.err.trim_end();
        assert!(ran.status == 2 && line.contains(what) && line.contains(fix) && !line.ends_with('.'), "{ran:?}");
    }
}
