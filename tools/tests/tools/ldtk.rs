//! Layers of `LDtk`: where it draws tiles and entities, and what the report says of them.

use tilesat::{TileKind, TileShape};
use tilesat_tools::read;
use tilesat_tools::rules::flags::Flags;
use tilesat_tools::rules::ground::Ground;
use tilesat_tools::rules::options::Options;

use crate::support::{run, scratch};

/// A project of one level of 8 x 8 cells of 16 pixels. Its tileset has tiles of this side, and all
/// of them are solid.
fn project(layers: &str, definition: &str, side: u32) -> String {
    let ids: Vec<String> = (0..16).map(|id| id.to_string()).collect();
    format!(
        r#"{{"jsonVersion":"1.5.3","defs":{{"layers":[{{"uid":2,{definition}"intGridValues":[{{"value":1,"identifier":"Full"}}]}}],
        "tilesets":[{{"uid":1,"identifier":"T","pxWid":128,"pxHei":128,"tileGridSize":{side},"spacing":0,"padding":0,
        "enumTags":[{{"enumValueId":"Solid","tileIds":[{}]}}]}}]}},
        "levels":[{{"identifier":"One","pxWid":128,"pxHei":128,"layerInstances":[{layers}]}}]}}"#,
        ids.join(",")
    )
}

/// A layer of this type and this member.
fn layer(form: &str, offset: (i32, i32), member: &str) -> String {
    format!(
        r#"{{"__type":"{form}","__identifier":"Solid","__cWid":8,"__cHei":8,"__gridSize":16,"__pxTotalOffsetX":{},"__pxTotalOffsetY":{},
        "__tilesetDefUid":1,"layerDefUid":2,{member}}}"#,
        offset.0, offset.1
    )
}

fn ground(name: &str, text: &str) -> Ground {
    let levels = read::load(&scratch("ldtk", &format!("{name}.ldtk"), text), None).unwrap();
    Ground::of(&levels.maps[0], &Options::default(), &mut Flags::default()).unwrap()
}

/// The box around everything solid, in halves of a pixel.
fn extent(ground: &Ground) -> [i64; 4] {
    let mut points: Vec<(i64, i64)> = ground.outlines.iter().flat_map(|outline| outline.points.clone()).collect();
    let side = i64::from(ground.tile) << 16;
    for (index, _) in ground.cells.iter().enumerate().filter(|(_, kind)| **kind == tilesat::TileKind::FULL) {
        let (column, row) = ((index % usize::from(ground.width)) as i64, (index / usize::from(ground.width)) as i64);
        let corner = (i64::from(ground.origin.0) + column * side, i64::from(ground.origin.1) + row * side);
        points.extend([corner, (corner.0 + side, corner.1 + side)]);
    }
    let along = |of: fn(&(i64, i64)) -> i64| points.iter().map(of);
    [along(|p| p.0).min(), along(|p| p.1).min(), along(|p| p.0).max(), along(|p| p.1).max()].map(|v| v.unwrap() >> 15)
}

/// The extent that `LDtk` draws, from `display.LayerRender` of its version 1.5.3.
#[test]
fn tiles_lie_where_ldtk_draws_them() {
    // The member, the pivot, the side of a tile, the flips, and left, top, right and bottom of the
    // tile in column 3, row 4, in pixels.
    let (grid, auto) = ("gridTiles", "autoLayerTiles");
    for (member, pivot, side, flips, wanted) in [
        (grid, (0.0, 0.0), 16, 0, [48, 64, 64, 80]),
        (grid, (0.0, 0.0), 32, 0, [48, 64, 80, 96]),
        // The pivot of the picture is on that of the cell.
        (grid, (0.5, 0.5), 32, 0, [40, 56, 72, 88]),
        (grid, (1.0, 1.0), 32, 0, [32, 48, 64, 80]),
        (grid, (0.5, 0.5), 8, 0, [52, 68, 60, 76]),
        (grid, (1.0, 1.0), 8, 0, [56, 72, 64, 80]),
        (grid, (0.5, 0.5), 16, 0, [48, 64, 64, 80]),
        // A flipped picture ends where its cell does.
        (grid, (0.0, 0.0), 32, 1, [32, 64, 64, 96]),
        (grid, (0.0, 0.0), 32, 3, [32, 48, 64, 80]),
        (grid, (0.0, 0.0), 8, 2, [48, 72, 56, 80]),
        (grid, (0.5, 0.5), 16, 1, [64, 64, 80, 80]),
        // The x pivot of the cell counts in both directions.
        (grid, (0.5, 1.0), 16, 0, [48, 56, 64, 72]),
        (grid, (0.0, 1.0), 32, 0, [48, 32, 80, 64]),
        // Rules have their pictures from the corner on.
        (auto, (0.0, 0.0), 16, 3, [48, 64, 64, 80]),
        (auto, (0.0, 0.0), 32, 1, [32, 64, 64, 96]),
        (auto, (0.5, 1.0), 16, 0, [56, 80, 72, 96]),
    ] {
        let definition = format!(r#""tilePivotX":{},"tilePivotY":{},"#, pivot.0, pivot.1);
        let tile = format!(r#""{member}":[{{"px":[48,64],"src":[0,0],"f":{flips},"t":1}}]"#);
        let found = ground("pivot", &project(&layer("Tiles", (0, 0), &tile), &definition, side));
        let wanted: [i64; 4] = wanted.map(|v: i64| 2 * v);
        assert_eq!(extent(&found), wanted, "{member} {pivot:?} {side} {flips}");
        // Programs that follow the documentation draw a tile from its pivot, flipped or not.
        let corner = |at: f64, pivot: f64| (2.0 * (at + pivot * (16.0 - f64::from(side)))) as i64;
        let documented = (corner(48.0, pivot.0), corner(64.0, pivot.1)) == (wanted[0], wanted[1]);
        let noted = found.notes.iter().any(|note| note.contains("LDtk draws 1 of its tiles elsewhere"));
        assert_eq!(noted, !documented, "{:?}", found.notes);
        // An offset of the layer moves all of them.
        let moved = ground("moved", &project(&layer("Tiles", (16, -32), &tile), &definition, side));
        let [left, top, right, bottom] = wanted;
        assert_eq!(extent(&moved), [left + 32, top - 64, right + 32, bottom - 64]);
    }
}

/// An entity's own point is its pivot.
#[test]
fn entities_lie_around_their_pivot() {
    for (pivot, wanted) in [("0,0", [40, 72, 64, 112]), ("0.5,1", [28, 32, 52, 72]), ("1,0.5", [16, 52, 40, 92])] {
        let entity = format!(
            r#""entityInstances":[{{"__identifier":"Solid","__pivot":[{pivot}],"px":[40,72],"width":24,"height":40}}]"#
        );
        let found = ground("entity", &project(&layer("Entities", (0, 0), &entity), "", 16));
        assert_eq!(extent(&found), wanted.map(|v: i64| 2 * v), "{pivot}");
        let moved = ground("entities", &project(&layer("Entities", (8, 4), &entity), "", 16));
        let [left, top, right, bottom] = wanted.map(|v: i64| 2 * v);
        assert_eq!(extent(&moved), [left + 16, top + 8, right + 16, bottom + 8], "{pivot}");
    }
}

#[test]
fn hidden_layers_of_solid_entities_are_noted() {
    let entity = r#""visible":false,"entityInstances":[{"__identifier":"Solid","__pivot":[0,0],"px":[0,0],"width":16,"height":16}]"#;
    let found = ground("hidden", &project(&layer("Entities", (0, 0), entity), "", 16));
    assert!(found.notes.iter().any(|note| note.starts_with("layer 'Solid' is hidden")), "{:?}", found.notes);
}

/// Nine tiles in one cell: one too many.
#[test]
fn tiles_that_are_not_read_are_noted() {
    let tiles = [r#"{"px":[48,64],"src":[0,0],"f":0,"t":1}"#; 9].join(",");
    let found = ground("pile", &project(&layer("Tiles", (0, 0), &format!(r#""gridTiles":[{tiles}]"#)), "", 16));
    let note =
        "layer 'Solid': 1 tiles lie over 8 others in their cells, and are not read; the first is in column 3, row 4";
    assert!(found.notes.iter().any(|line| line.starts_with(note)), "{:?}", found.notes);
}

/// A level has each layer of its project, drawn or not. Options can name all of them.
#[test]
fn options_name_layers_without_tiles() {
    let grid = layer("IntGrid", (0, 0), &format!(r#""intGridCsv":[{}]"#, ["1"; 64].join(",")));
    let bare = |form: &str, tileset: &str| {
        let text = layer(form, (0, 0), r#""gridTiles":[],"autoLayerTiles":[]"#).replace("\"Solid\"", "\"Trees\"");
        // Of smaller cells, which are no cells of the level.
        text.replace("\"__tilesetDefUid\":1", tileset).replace("16", "4")
    };
    let found = ground("plain", &project(&grid, "", 16));
    for (form, tileset) in [("Tiles", r#""__tilesetDefUid":1"#), ("AutoLayer", r#""__tilesetDefUid":null"#)] {
        let text = project(&format!("{},{grid}", bare(form, tileset)), "", 16);
        assert_eq!(ground("bare", &text), found);
        for option in ["--ignore-layer", "--solid-layer"] {
            let ran = run("bake", scratch("ldtk", "bare.ldtk", &text), &format!("--json {option} Trees"));
            assert_eq!(ran.status, 0, "{ran:?}");
        }
    }
}

/// A project of one level with `IntGrid` layers, from the lowest up: each has a name, values from 1
/// on with these identifiers (none if empty), and a row of cells.
fn grids(layers: &[(&str, &[&str], &str)]) -> String {
    let identifier = |name: &str| if name.is_empty() { "null".to_owned() } else { format!("\"{name}\"") };
    let definition = |(uid, (_, values, _)): (usize, &(&str, &[&str], &str))| {
        let values = values
            .iter()
            .zip(1..)
            .map(|(name, value): (_, u32)| format!(r#"{{"value":{value},"identifier":{}}}"#, identifier(name)));
        format!(r#"{{"uid":{uid},"intGridValues":[{}]}}"#, values.collect::<Vec<_>>().join(","))
    };
    let instance = |(uid, (name, _, cells)): (usize, &(&str, &[&str], &str))| {
        let width = cells.split(',').count();
        format!(
            r#"{{"__type":"IntGrid","__identifier":"{name}","__cWid":{width},"__cHei":1,"__gridSize":16,"layerDefUid":{uid},"intGridCsv":[{cells}]}}"#
        )
    };
    format!(
        r#"{{"defs":{{"layers":[{}]}},"levels":[{{"identifier":"One","layerInstances":[{}]}}]}}"#,
        layers.iter().enumerate().map(definition).collect::<Vec<_>>().join(","),
        layers.iter().enumerate().rev().map(instance).collect::<Vec<_>>().join(",")
    )
}

/// The cells, `#` full, `=` one-way and `.` empty, with the guesses; or the refusal.
fn decided(text: &str, options: &Options) -> (String, Vec<String>) {
    let levels = read::load(&scratch("ldtk", "decided.ldtk", text), None).unwrap();
    let ground = match Ground::of(&levels.maps[0], options, &mut Flags::default()) {
        Ok(ground) => ground,
        Err(fail) => return (String::new(), vec![fail.to_string()]),
    };
    let cell = |kind: &TileKind| match kind.shape {
        TileShape::Full => '#',
        TileShape::Empty => '.',
        _ => '=',
    };
    let guesses = ground.notes.into_iter().filter(|note| note.starts_with("GUESS: "));
    (ground.cells.iter().map(cell).collect(), guesses.collect())
}

/// Identifiers are optional in `LDtk`. Without one, the layer decides.
#[test]
fn values_without_an_identifier() {
    let none = Options::default();
    let collisions = "GUESS: values 1, 2 of layer 'Collisions' are full because of the layer's name; \
                      --solid 'Collisions:1' confirms it, --empty 'Collisions:1' refuses it";
    let walls = "GUESS: value 1 of layer 'Walls' is full because of the layer's name; --solid 'Walls:1' confirms it, \
                 --empty 'Walls:1' refuses it";
    let others = "GUESS: value 1 of layer 'Walls', values 1, 3 of layer 'Foliage' have no identifier, and are empty because \
                  other things are solid; --solid 'Walls:1' makes it full";
    for (layers, cells, note) in [
        (&[("Collisions", &["", ""][..], "1,0,2")][..], "#.#", collisions),
        // Rule d: nothing else is solid.
        (&[("Walls", &[""], "0,1,0"), ("Foliage", &["", "", ""], "1,0,3")], ".#.", walls),
        (&[("Walls", &[""], "0,1,0"), ("Foliage", &["", "", ""], "1,0,3"), ("G", &["Full"], "1,0,0")], "#..", others),
    ] {
        let (found, notes) = decided(&grids(layers), &none);
        assert_eq!(found, cells, "{notes:?}");
        assert!(notes.iter().any(|line| line == note), "{note} is not in {notes:?}");
    }
    // Refused only if nothing is solid: all of them at once, with what settles it.
    let (_, notes) = decided(&grids(&[("A", &["", ""], "1,0,2"), ("B", &[""], "0,1,0")]), &none);
    let why = "values 1, 2 of layer 'A', value 1 of layer 'B' have no identifier: name them in LDtk, or add --solid A:1, \
               --one-way A:1, --flag A:1 or --empty A:1";
    assert!(notes[0].contains(why), "{notes:?}");
}

/// In a layer of collisions all values are solid if no other name says more.
#[test]
fn names_without_a_meaning_in_a_layer_of_collisions() {
    let none = Options::default();
    let layer = |names: &[&str], cells: &str| decided(&grids(&[("Collisions", names, cells)]), &none);
    let (cells, notes) = layer(&["grass", "one", "water", "no_collision"], "1,2,3,4,0");
    assert_eq!(cells, "##...", "{notes:?}");
    let note = "GUESS: values 1 'grass', 2 'one' of layer 'Collisions' are full because of the layer's name; \
                --solid 'Collisions:1' confirms it";
    assert!(notes[0].starts_with(note), "{notes:?}");
    // Rule d, the last words: a value's own name.
    let (cells, notes) = decided(&grids(&[("G", &["wood_floor", "sky"], "1,2")]), &none);
    let note = "GUESS: value 1 'wood_floor' of layer 'G' is full because of its name; --solid 'G:1' confirms it";
    assert!(cells == "#." && notes[0].starts_with(note), "{notes:?}");
    assert_eq!(decided(&grids(&[("G", &["floor", "wall"], "1,2")]), &none), (".#".to_owned(), Vec::new()));
    let (cells, notes) = decided(&grids(&[("OneWay", &[""], "1,0"), ("G", &["Full"], "0,1")]), &none);
    assert!(
        cells == "=#" && notes[0].contains("is one-way-up") && notes[0].contains("--one-way 'OneWay:1'"),
        "{notes:?}"
    );
    // Games name directions differently.
    let (_, notes) = decided(&grids(&[("G", &["Slope_left", "Full"], "1,2")]), &none);
    assert!(notes[0].contains("value 1 'Slope_left' of layer 'G' is no slope"), "{notes:?}");
    // Neither a name that means a solid nor a one-way value changes what the others are.
    for (names, cells) in [
        (["grass", "wall"], "##."),
        (["grass", "OneWay"], "#=."),
        (["Bg_wall", "Fake_wall"], ""),
        (["grass", "pit"], "#.."),
    ] {
        assert_eq!(layer(&names, "1,2,0").0, cells, "{names:?}");
    }
    assert_eq!(layer(&["water"], "1").0, "");
    let flag = Options { flags: vec!["grass".to_owned()], ..Options::default() };
    assert_eq!(decided(&grids(&[("Collisions", &["grass", "one"], "1,2")]), &flag).0, ".#");
}

/// Options come first: a value without an identifier needs none.
#[test]
fn options_decide_about_values() {
    let text = grids(&[("Collisions", &["", "", ""], "1,2,3,0"), ("Fog", &[""], "1,1,1,1")]);
    let solid = |layers: &[&str], empty: &[&str], flags: &[&str]| {
        let names = |list: &[&str]| list.iter().map(|&name| name.to_owned()).collect::<Vec<String>>();
        let shapes = names(empty).into_iter().map(|name| (name, TileShape::Empty)).collect();
        let options = Options { solid_layers: names(layers), shapes, flags: names(flags), ..Options::default() };
        decided(&text, &options)
    };
    let fog = "GUESS: value 1 of layer 'Fog' has no identifier, and is empty because other things are solid";
    let (cells, notes) = solid(&["Collisions"], &[], &[]);
    assert!(cells == "###." && notes.len() == 1 && notes[0].starts_with(fog), "{cells} {notes:?}");
    assert_eq!(solid(&["Collisions"], &["Fog:1"], &[]), ("###.".to_owned(), Vec::new()));
    assert_eq!(solid(&["Collisions"], &["Fog:1", "2"], &[]).0, "#.#.");
    let (cells, notes) = solid(&[], &["Fog:1"], &["Collisions:3"]);
    assert!(cells == "##.." && notes.len() == 1 && notes[0].contains("values 1, 2 of"), "{cells} {notes:?}");
}

#[test]
fn projects_without_levels() {
    for (text, why) in [
        (r#"{"defs":{"layers":[]},"levels":[]}"#, "a project of LDtk without levels: add one"),
        ("{}", "not an LDtk project: it has no levels"),
    ] {
        let fail = read::load(&scratch("ldtk", "none.ldtk", text), None).unwrap_err().to_string();
        assert!(fail.ends_with(why), "{fail}");
    }
}

/// Tiles over each other are several layers here, and one layer for their author.
#[test]
fn a_guess_about_a_layer_is_said_once() {
    let tiles = [r#"{"px":[48,64],"src":[0,0],"f":0,"t":1}"#; 3].join(",");
    let layer = layer("Tiles", (0, 0), &format!(r#""gridTiles":[{tiles}]"#)).replace("Solid", "Ground");
    let found = ground("pile", &project(&layer, "", 16).replace("Solid", "Grass"));
    assert_eq!(found.notes.iter().filter(|note| note.starts_with("GUESS")).count(), 1, "{:?}", found.notes);
    let refused = project(&layer.replace("Ground", "Trees"), "", 16).replace("Solid", "Grass");
    let ran = run("bake", scratch("ldtk", "pile.ldtk", refused), "--json");
    assert!(ran.err.contains("the tile layer is 'Trees' (3 tiles): add --solid-layer 'Trees'"), "{ran:?}");
}

/// A project of two levels with the same two layers, and other numbers of fine walls. The last
/// level can lack the coarse layer.
fn two_grids(offset: i32, fine: usize, last: bool) -> String {
    let layer = |uid: u32, name: &str, side: u32, csv: &str| {
        let (width, height) = (64 / side, 32 / side);
        format!(
            r#"{{"__type":"IntGrid","__identifier":"{name}","__cWid":{width},"__cHei":{height},"__gridSize":{side},
            "__pxTotalOffsetX":{},"__pxTotalOffsetY":0,"layerDefUid":{uid},"intGridCsv":[{csv}]}}"#,
            if name == "Coarse" { offset } else { 0 }
        )
    };
    let level = |name: &str, x: i32, fine: usize, both: bool| {
        let values: Vec<&str> = (0..32).map(|cell| if cell < fine { "1" } else { "0" }).collect();
        let (fine, coarse) = (layer(2, "Fine", 8, &values.join(",")), layer(1, "Coarse", 16, "0,2,0,0,1,2,1,1"));
        let layers = if both { format!("{fine},{coarse}") } else { fine };
        format!(
            r#"{{"identifier":"{name}","worldX":{x},"worldY":0,"pxWid":64,"pxHei":32,"layerInstances":[{layers}]}}"#
        )
    };
    format!(
        r#"{{"worldLayout":"Free","defs":{{"layers":[
        {{"uid":1,"intGridValues":[{{"value":1,"identifier":"Wall"}},{{"value":2,"identifier":"Ladder"}}]}},
        {{"uid":2,"intGridValues":[{{"value":1,"identifier":"Wall"}}]}}]}},"levels":[{},{}]}}"#,
        level("L0", 0, fine, true),
        level("L1", 64, 1, last)
    )
}

/// The levels of a project have cells of one size. A coarse tile is some fine ones, and they have
/// its flags.
#[test]
fn levels_of_layers_with_several_grids_have_one_size_of_cells() {
    let file = scratch("ldtk", "two_grids.ldtk", two_grids(0, 8, true));
    let ran = run("bake", &file, "--json");
    let lines: Vec<serde_json::Value> = ran.out.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    for (level, solid) in lines.iter().zip([20, 13]) {
        let found = [&level["cell"], &level["solid"], &level["segments"], &level["flags"]["Ladder"]];
        assert_eq!(found, [8, solid, 0, 8], "{level}");
        assert!(level["warnings"].as_array().unwrap().is_empty(), "{level}");
    }
    assert_eq!(lines.len(), 2, "{ran:?}");
    let ran = run("rooms", &file, &format!("-o {}", scratch("ldtk", "two_grids.rs", "").display()));
    assert!(ran.status == 0 && ran.out.contains("rooms   2 of cells of 8 px"), "{ran:?}");
    // Between the cells nothing can have its flags, and a coarse wall is a polygon.
    let ran = run("bake", scratch("ldtk", "two_grids_moved.ldtk", two_grids(4, 8, true)), "--json");
    assert!(ran.out.contains("layer 'Coarse': its flags are in no output"), "{ran:?}");
    // A level without a layer of the common size has polygons, and is a room like the others.
    let file = scratch("ldtk", "two_grids_fine.ldtk", two_grids(0, 0, false));
    let ran = run("bake", &file, "--json");
    let last: serde_json::Value = serde_json::from_str(ran.last()).unwrap();
    assert_eq!([&last["cell"], &last["width"], &last["height"], &last["segments"]], [16, 4, 2, 4], "{ran:?}");
    let ran = run("rooms", &file, &format!("-o {}", scratch("ldtk", "two_grids.rs", "").display()));
    assert!(ran.status == 0 && ran.out.contains("rooms   2 of cells of 16 px"), "{ran:?}");
}
