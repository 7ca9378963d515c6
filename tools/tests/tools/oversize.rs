//! Solid tiles whose pictures are larger than their cells: walls in perspective, of which the cells
//! are solid, and large blocks, of which the pictures are.

use crate::support::{map, run, scratch};

/// The solid cells of a map of these rows, whose tiles have a picture of this size, and the notes.
fn solid(rows: &[&str], size: (u32, u32), tile: &str, options: &str) -> (String, String) {
    let cell = |c: char| if c == '#' { "1" } else { "0" };
    let csv: Vec<&str> = rows.iter().flat_map(|row| row.chars().map(cell)).collect();
    let set = format!(r#"name="t" tilewidth="{}" tileheight="{}""#, size.0, size.1);
    let text = map(rows[0].len(), rows.len(), &csv.join(","), "")
        .replace(r#"name="t" tilewidth="16" tileheight="16""#, &set)
        .replace(r#"<tile id="0" type="Solid"/>"#, tile);
    let out = scratch("oversize", "level.bin", "");
    let file = scratch("oversize", "level.tmx", text);
    let ran = run("bake", file, &format!("-o {} {options}", out.display()));
    assert_eq!(ran.status, 0, "{ran:?}");
    let bytes = std::fs::read(&out).unwrap();
    let lines = bytes.chunks(rows[0].len());
    let shown = |line: &[u8]| line.iter().map(|id| if *id == 0 { '.' } else { '#' }).collect::<String>();
    (lines.map(shown).collect::<Vec<_>>().join(" "), ran.out + &ran.err)
}

const SOLID: &str = r#"<tile id="0" type="Solid"/>"#;
const ROOM: &[&str] = &["........", "########", "#......#", "#......#", "#......#", "########"];
const OVER: &str = "larger than cells, lie over each other, so only their cells are solid";
const ONE_DRAWN: &str = "1 tile of layer 'World', larger than cells, is solid as drawn";

/// A room is as large as its cells: its walls are two cells high only in the picture.
#[test]
fn walls_in_perspective() {
    for size in [(16, 32), (16, 24), (32, 32), (24, 40)] {
        let (cells, said) = solid(ROOM, size, SOLID, "");
        assert_eq!(cells, ROOM.join(" "), "{size:?}");
        assert!(said.contains("GUESS: ") && said.contains(OVER), "{size:?}: {said}");
    }
    // A long corridor, most of whose walls have nothing above them.
    let (full, middle) = ("#".repeat(200), format!("#{}#", ".".repeat(198)));
    let above = middle.replace('#', ".");
    let corridor = [&above, &full, &middle, &middle, &full].map(String::as_str);
    assert_eq!(solid(&corridor, (16, 32), SOLID, "").0, corridor.join(" "));
    // A layer or an option that makes them solid does not change it.
    assert_eq!(solid(ROOM, (16, 32), "", "--solid-layer World").0, ROOM.join(" "));
    let flagged = solid(ROOM, (16, 32), r#"<tile id="0" type="Ice"/>"#, "--solid Ice --flag Ice").0;
    assert_eq!(flagged, ROOM.join(" "));
}

#[test]
fn large_blocks() {
    let blocks = ["........", "#.#.#...", "........", "#...#.#."];
    let (cells, said) = solid(&blocks, (32, 32), SOLID, "");
    assert_eq!(cells, "######.. ######.. ##..#### ##..####");
    assert!(!said.contains("larger than cells"), "{said}");
    // Nothing is beside a single one.
    let (cells, said) = solid(&["....", "....", ".#.."], (16, 32), SOLID, "");
    assert!(cells == ".... .#.. .#.." && said.contains(ONE_DRAWN), "{cells} {said}");
    // One of many is in a wrong cell.
    let rows: Vec<String> = (0..8).map(|y| if y % 2 == 1 { "#.".repeat(8) } else { "..".repeat(8) }).collect();
    let mut rows: Vec<&str> = rows.iter().map(String::as_str).collect();
    rows[7] = "##.#.#.#.#.#.#..";
    assert!(!solid(&rows, (32, 32), SOLID, "").1.contains(OVER));
}

/// A collision shape says where the solid is.
#[test]
fn shapes_settle_it() {
    let shape =
        r#"<tile id="0"><objectgroup><object id="1" x="0" y="16" width="16" height="16"/></objectgroup></tile>"#;
    let file = |tile: &str| {
        let text = map(2, 3, "0,0,1,1,1,1", "").replace(SOLID, tile);
        scratch("oversize", "shape.tmx", text.replace("tileheight=\"16\" tilecount", "tileheight=\"32\" tilecount"))
    };
    let ran = run("bake", file(shape), "--json");
    assert!(ran.status == 0 && !(ran.out + &ran.err).contains("larger than cells"));
}

/// Cells that are not square are several, and a tile that fills all of them is not large.
#[test]
fn cells_that_are_not_square() {
    let text = |height: u32| {
        let rows = "0,0,0,0,1,1,1,1,1,0,0,1,1,0,0,1,1,1,1,1";
        let text = map(4, 5, rows, "")
            .replace("tilewidth=\"16\" tileheight=\"16\" infinite", "tilewidth=\"16\" tileheight=\"24\" infinite");
        text.replace(
            "name=\"t\" tilewidth=\"16\" tileheight=\"16\"",
            &format!("name=\"t\" tilewidth=\"16\" tileheight=\"{height}\""),
        )
    };
    for (height, large) in [(24, false), (48, true)] {
        let ran = run("bake", scratch("oversize", "odd.tmx", text(height)), "--json");
        let level: serde_json::Value = serde_json::from_str(ran.last()).unwrap();
        // Twelve cells of 2x3.
        assert_eq!((&level["solid"], ran.err.contains(OVER)), (&72.into(), large), "{height}: {ran:?}");
    }
}
