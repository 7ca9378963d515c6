//! The platformer example for its user: arguments, good and bad files, the last line, the exit
//! status.

use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};

use tilesat_tools::cli::play::{self, Program};

use crate::support::{self, Ran, own};

/// As in the example.
fn run<A: Into<OsString>>(args: impl IntoIterator<Item = A>) -> Ran {
    let levels = ["meadow", "ninja"].map(|name| (name, own(&format!("platformer/levels/{name}.tmx"))));
    let program = Program { name: "platformer", levels: levels.to_vec(), picture: Some(scratch("platformer.png")) };
    support::ran(|args, out, err| play::run(&program, args, out, err), args)
}

/// A path for a file of this test run.
fn scratch(name: &str) -> PathBuf {
    support::folder("play").join(name)
}

fn level(name: &str, text: &str) -> PathBuf {
    support::scratch("play", &format!("{name}.tmx"), text)
}

/// A map with one layer, and a tileset of a solid, a one-way and some flagged tiles.
fn map(width: u32, height: u32, tile: u32, csv: &str) -> String {
    format!(
        r#"<?xml version="1.0" encoding="UTF-8"?>
<map version="1.10" orientation="orthogonal" renderorder="right-down" width="{width}" height="{height}" tilewidth="{tile}" tileheight="{tile}" infinite="0">
 <tileset firstgid="1" name="t" tilewidth="{tile}" tileheight="{tile}" tilecount="12" columns="4">
  <image source="t.png" width="32" height="24"/>
  <tile id="0" type="Solid"/><tile id="1" type="OneWay"/><tile id="2" type="Kill"/>
  <tile id="3" type="A"/><tile id="4" type="B"/><tile id="5" type="C"/><tile id="6" type="D"/>
  <tile id="7" type="E"/><tile id="8" type="F"/><tile id="9" type="G"/><tile id="10" type="H"/>
 </tileset>
 <layer id="1" name="World" width="{width}" height="{height}"><data encoding="csv">{csv}</data></layer>
</map>"#
    )
}

/// Twelve columns, ten rows: a floor, a wall, a one-way tile, spikes.
fn small() -> String {
    let rows = "000000000000 000000000000 000000000000 000002200000 000000000000 \
                000100000000 000100000000 000100003000 111111111111 111111111111";
    let cells: Vec<String> = rows.chars().filter(|c| *c != ' ').map(String::from).collect();
    map(12, 10, 8, &cells.join(","))
}

/// A refusal: status 2, one line that contains the word, and nothing that looks like a result.
fn refused(ran: &Ran, word: &str) {
    assert_eq!(ran.status, 2, "{ran:?}");
    assert_eq!(ran.err.lines().count(), 1, "{ran:?}");
    assert!(ran.err.starts_with("platformer: ") && ran.err.contains(word), "{word:?} is not in {ran:?}");
    assert!(!ran.out.contains("frames="), "{ran:?}");
}

fn fine(ran: &Ran, frames: u32) {
    assert_eq!((ran.status, ran.err.as_str()), (0, ""), "{ran:?}");
    let words: Vec<&str> = ran.last().split(' ').collect();
    let [first, bodies, contacts, overlaps, escaped, hash] = words[..] else { panic!("{ran:?}") };
    assert_eq!(
        [first, bodies, overlaps, escaped],
        [&format!("frames={frames}"), "bodies=33", "overlaps=0", "escaped=0"]
    );
    assert!(contacts.strip_prefix("contacts=").unwrap().parse::<u64>().is_ok());
    let hash = hash.strip_prefix("hash=").unwrap();
    assert!(hash.len() == 8 && u32::from_str_radix(hash, 16).is_ok());
}

fn played(path: &Path, more: &[&str]) -> Ran {
    let png = path.with_extension("png");
    let fixed = [path.as_os_str().to_owned(), "--png".into(), png.into()];
    run(fixed.into_iter().chain(more.iter().map(Into::into)))
}

#[test]
fn plays_its_own_level() {
    let (png, svg) = (scratch("own.png"), scratch("own.svg"));
    let ran = run(["--frames", "600", "--png", png.to_str().unwrap(), "--svg", svg.to_str().unwrap()]);
    fine(&ran, 600);
    for word in ["layer   World", "Coin = bit ", "own.png", "own.svg"] {
        assert!(ran.out.contains(word), "{word:?} is not in {}", ran.out);
    }
    assert!(fs::read(png).unwrap().starts_with(b"\x89PNG\r\n"));
    let text = fs::read_to_string(svg).unwrap();
    assert!(text.starts_with("<svg ") && text.ends_with("</svg>\n"));
}

#[test]
fn plays_the_level_of_all_shapes() {
    let (png, svg) = (scratch("ninja.png"), scratch("ninja.svg"));
    let files = ["--png", png.to_str().unwrap(), "--svg", svg.to_str().unwrap()];
    let ran = run(["--level", "ninja", "--frames", "600"].into_iter().chain(files));
    fine(&ran, 600);
    for word in ["ninja.tmx: 48x27 tiles of 24 px", "Water = bit "] {
        assert!(ran.out.contains(word), "{word:?} is not in {}", ran.out);
    }
    // By its path it is the same level.
    let path = own("platformer/levels/ninja.tmx");
    let again = run([path.as_os_str(), "--frames".as_ref(), "600".as_ref(), "--png".as_ref(), png.as_os_str()]);
    assert_eq!(again.last(), ran.last());
    assert!(fs::read_to_string(svg).unwrap().contains("<polygon "));
}

#[test]
fn the_seed_alone_decides() {
    let level = level("seeds", &small());
    let line = |seed: &str| played(&level, &["--frames", "200", "--seed", seed]).last().to_owned();
    assert_eq!(line("7"), line("7"));
    assert_ne!(line("7"), line("8"));
    fine(&played(&level, &["--frames", "0"]), 0);
}

#[test]
fn help_is_no_error() {
    for arg in ["--help", "-h"] {
        let ran = run([arg]);
        assert!(ran.status == 0 && ran.err.is_empty() && ran.out.starts_with("usage:"), "{ran:?}");
    }
}

#[test]
fn bad_arguments() {
    let cases: &[(&[&str], &str)] = &[
        (&["--fps", "3"], "--fps"),
        (&["-x"], "-x"),
        (&["--frames"], "--frames needs a value"),
        (&["--png", "--svg"], "--png needs a value"),
        (&["--frames", "many"], "whole number"),
        (&["--frames", "-1"], "whole number"),
        (&["--frames", "1.5"], "whole number"),
        (&["--seed", "4294967296"], "whole number"),
        (&["--seed", "1", "--seed", "1"], "twice"),
        (&["a.tmx", "b.tmx"], "twice"),
        (&[""], "empty"),
        (&["--layer", ""], "--layer needs a value"),
        (&["--level"], "--level needs a value"),
        (&["--level", "desert"], "no level of the example is called desert; there are: meadow, ninja"),
        (&["--level", "ninja", "--level", "meadow"], "twice"),
        (&["--level", "ninja", "a.tmx"], "twice"),
        (&["--png", "/no/such/folder/a.png"], "cannot write"),
        (&["--svg", "/no/such/folder/a.svg"], "cannot write"),
        (&["--bake", "/no/such/folder/a"], "cannot write"),
        (&["--layer", "Nowhere"], "no tile layer 'Nowhere'; there are: Scenery, World, Items"),
        (&["/no/such/level.tmx"], "cannot read"),
        (&["/"], ""),
    ];
    for (args, word) in cases {
        refused(&run(args.iter().copied()), word);
    }
}

#[cfg(unix)]
#[test]
fn arguments_that_are_not_unicode() {
    use std::os::unix::ffi::OsStringExt;
    let odd = OsString::from_vec(vec![b'a', 0xff]);
    refused(&run([odd.clone()]), "cannot read");
    refused(&run(["--layer".into(), odd.clone()]), "UTF-8");
    refused(&run(["--frames".into(), odd]), "whole number");
}

#[test]
fn bad_files() {
    let small = small();
    let solid = ["1"; 9].join(",");
    let cases: &[(&str, String, &str)] = &[
        ("empty", String::new(), "the file is empty"),
        ("words", "no XML\nat all".into(), "not a Tiled map"),
        ("html", "<html></html>".into(), "not a Tiled map"),
        ("cut", small[..small.len() / 2].into(), "not a Tiled map"),
        ("infinite", small.replace("infinite=\"0\"", "infinite=\"1\""), "nothing is solid"),
        ("isometric", small.replace("orthogonal", "isometric"), "isometric"),
        ("zero", small.replace("=\"8\"", "=\"0\""), "pixels"),
        ("wide", map(2048, 1, 8, &vec!["1"; 2048].join(",")), "beyond the domain"),
        ("huge", map(4_000_000_000, 4_000_000_000, 8, "1"), "more than 16777216 tiles"),
        ("short", map(12, 20, 8, "1,1,1,0"), "4 tiles, but 12x20 cells need 240: save the map again in Tiled"),
        ("letters", map(3, 1, 8, "1,x,1"), "layer 'World': 'x' is not a tile"),
        ("no_layer", small.replace("<layer", "<strata").replace("</layer", "</strata"), "nothing is solid"),
        (
            "no_solid",
            small.replace("\"Solid\"", "\"Soup\"").replace("\"OneWay\"", "\"Plank\""),
            "names of tiles are 'Kill', 'Plank', 'Soup': add --solid NAME",
        ),
        ("no_room", map(3, 3, 8, &solid), "no room"),
        (
            "no_tileset",
            small
                .replace("name=\"t\"", "source=\"nowhere.tsx\"")
                .replace("tilewidth=\"8\" tileheight=\"8\" tilecount", "x"),
            "nowhere.tsx",
        ),
        ("tiles", small.replace("tilecount=\"12\"", "tilecount=\"4000000000\""), "1048576"),
        ("deep", small.replace("<layer", &("<group>".repeat(1000) + "<layer")), "nested"),
    ];
    for (name, text, word) in cases {
        refused(&played(&level(name, text), &[]), word);
    }
    refused(&run([scratch(".")]), "");
}

#[test]
fn odd_but_good_files() {
    let small = small();
    let csv = small.split("csv\">").nth(1).unwrap().split('<').next().unwrap();
    let tags: Vec<String> = csv.split(',').map(|gid| format!("<tile gid=\"{gid}\"/>")).collect();
    let tags = tags.join("\n");
    let as_tags = small.replace(csv, &tags).replace(" encoding=\"csv\"", "");
    let flipped = small.replace(",1,1", ",2147483649,3758096385");
    let old = small.replace(" tilecount=\"12\" columns=\"4\"", "").replace(" width=\"32\" height=\"24\"", "");
    let extras = "</layer><objectgroup id=\"2\"><object id=\"1\" x=\"3\"/></objectgroup>";
    let group = small.replace("<layer", "<group id=\"9\" name=\"g\"><layer").replace("</layer>", "</layer></group>");
    let expected = played(&level("plain", &small), &["--frames", "300"]);
    fine(&expected, 300);
    let cases = [
        ("tags", as_tags),
        ("flipped", flipped),
        ("old", old),
        ("objects", small.replace("</layer>", extras)),
        ("group", group),
    ];
    for (name, text) in cases {
        assert_eq!(played(&level(name, &text), &["--frames", "300"]).last(), expected.last(), "{name}");
    }
}

/// Cells of every size, and maps that nearly fill the domain. The mover refuses no motion at the
/// end of a map.
#[test]
fn every_size() {
    for (width, height, tile) in [(30, 20, 1), (30, 20, 7), (31, 31, 256), (1023, 3, 8), (3, 1023, 8), (8191, 2, 1)] {
        let cells: Vec<&str> = (0..width * height).map(|i| if i * 7 % 11 == 0 { "1" } else { "0" }).collect();
        let level = level(&format!("size_{width}_{height}_{tile}"), &map(width, height, tile, &cells.join(",")));
        fine(&played(&level, &["--frames", "300"]), 300);
    }
    fine(&played(&level("one_cell", &map(2, 1, 8, "0,1")), &["--frames", "300"]), 300);
}

#[test]
fn levels_of_the_environment() {
    let Some(folder) = std::env::var_os("TILESAT_LEVELS") else {
        println!("skipped: TILESAT_LEVELS is not set");
        return;
    };
    let (mut pending, mut played) = (vec![PathBuf::from(folder)], 0);
    while let Some(path) = pending.pop() {
        if path.is_dir() {
            pending.extend(fs::read_dir(path).unwrap().map(|entry| entry.unwrap().path()));
        } else if path.extension().is_some_and(|e| e == "tmx") {
            let png = scratch("level.png");
            let ran = run([path.into_os_string(), "--png".into(), png.into()]);
            fine(&ran, 3600);
            println!("{}{}", ran.out.lines().next().unwrap_or_default(), ran.last());
            played += 1;
        }
    }
    assert!(played > 0, "no .tmx in TILESAT_LEVELS");
}
