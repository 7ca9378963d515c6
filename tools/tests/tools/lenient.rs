//! Files that Tiled opens although something of them is missing or odd. They are read, and a line
//! of the report names what was dropped or guessed.

use std::fs;
use std::path::PathBuf;

use serde_json::{Value, json};

use crate::support::{Ran, folder, map, rows, run, scratch};

fn file(name: &str, text: impl AsRef<[u8]>) -> PathBuf {
    scratch("lenient", name, text)
}

/// A line of JSON about a level that is read.
fn level(ran: &Ran) -> Value {
    assert_eq!(ran.status, 0, "{ran:?}");
    serde_json::from_str(ran.last()).unwrap()
}

fn bake(name: &str, text: impl AsRef<[u8]>) -> Value {
    level(&run("bake", file(name, text), "--json"))
}

fn refused(name: &str, text: impl AsRef<[u8]>) -> String {
    let ran = run("bake", file(name, text), "--json");
    assert!(ran.status == 2 && ran.out.is_empty() && ran.err.lines().count() == 1, "{ran:?}");
    ran.err
}

/// Whether a list of the report has a line with these words.
fn says(level: &Value, list: &str, words: &str) -> bool {
    let lines = level[list].as_array().unwrap();
    lines.iter().any(|line| line.as_str().unwrap().contains(words)) || {
        println!("{words} is not in {lines:?}");
        false
    }
}

#[allow(clippy::needless_pass_by_value, reason = "the macro takes it by reference")]
fn json_map(layer: Value) -> Value {
    json!({"orientation": "orthogonal", "width": 2, "height": 1, "tilewidth": 16, "tileheight": 16, "layers": [layer],
        "tilesets": [{"firstgid": 1, "name": "t", "tilewidth": 16, "tileheight": 16, "tilecount": 2, "columns": 2,
            "tiles": [{"id": 0, "type": "Solid"}]}]})
}

fn json_layer() -> Value {
    json!({"type": "tilelayer", "name": "World", "width": 2, "height": 1, "data": [1, 0]})
}

/// In JSON, Tiled reads the data of a layer first, and chunks only without it. In XML, chunks alone
/// count in an infinite map.
#[test]
fn infinite_maps_without_chunks() {
    let mut text = json_map(json_layer());
    text["infinite"] = json!(true);
    assert_eq!(bake("infinite.tmj", text.to_string())["solid"], 1);
    text["layers"][0]["chunks"] = json!([{"x": 0, "y": 0, "width": 2, "height": 1, "data": [1, 1]}]);
    let both = bake("both.tmj", text.to_string());
    assert!(both["solid"] == 1 && says(&both, "warnings", "layer 'World': it has data and chunks"));
    let text = rows(&["#."]).replace("infinite=\"0\"", "infinite=\"1\"");
    assert!(refused("infinite.tmx", text).contains("layer 'World': its tiles are dropped, as in Tiled"));
}

#[test]
fn tiles_that_their_tileset_does_not_have() {
    let level = bake("beyond.tmx", map(3, 2, "0,0,0,1,0,99", r#"<object id="7" gid="50" type="Solid" x="0" y="16"/>"#));
    assert_eq!((&level["solid"], &level["segments"]), (&json!(1), &json!(4)));
    assert!(says(
        &level,
        "warnings",
        "layer 'World': 1 of its tiles are in no tileset, the first in column 2, row 1: 't' has no tile 98"
    ));
    assert!(says(&level, "warnings", "object 7 of layer 'L': its tile 49 is not in tileset 't'"));
    // Of a collection of images, a tile in the middle was deleted. It is as large as a cell.
    let image =
        |id: u32| format!(r#"<tile id="{id}" type="Coin"><image source="a.png" width="64" height="64"/></tile>"#);
    let tiles = r#"<tile id="0" type="Solid"/><tile id="1" type="OneWay"/><tile id="2" type="Kill"/>"#;
    let text = map(3, 2, "0,0,0,0,2,0", "").replace(tiles, &(image(0) + &image(2) + &image(3)));
    let level = bake("deleted.tmx", text.replace("name=\"World\"", "name=\"collision\""));
    assert!(
        level["solid"] == 1 && says(&level, "warnings", "the first in column 1, row 1: 't' has no tile 1"),
        "{level}"
    );
    let full = map(3, 2, "0,0,0,1,0,99", "").replace("name=\"World\"", "name=\"collision\"");
    assert_eq!(bake("full.tmx", full)["solid"], 2);
}

const GONE: &str = r#"<tileset firstgid="100" source="gone.tsx"/><layer"#;

#[test]
fn missing_tilesets() {
    let two = |csv: &str, name: &str| {
        let layer =
            format!(r#"<layer id="9" name="{name}" width="2" height="1"><data encoding="csv">{csv}</data></layer>"#);
        map(2, 1, "1,0", "").replacen(" <layer", &format!("{layer}<layer"), 1).replacen("<layer", GONE, 1)
    };
    let beside = bake("beside.tmx", two("100,101", "deco"));
    assert_eq!(beside["solid"], 1);
    assert!(
        says(&beside, "warnings", "gone.tsx: cannot read") && says(&beside, "warnings", "2 of its tiles are drawn")
    );
    assert_eq!(bake("layer.tmx", two("100,101", "Collision"))["solid"], 2);
    let by_option = run("bake", file("option.tmx", two("1,100", "deco")), "--json --solid-layer deco");
    assert_eq!(level(&by_option)["solid"], 2);
    // Nobody knows whether it is solid.
    let why = refused("mixed.tmx", two("1,100", "deco"));
    for part in ["gone.tsx: cannot read", "in column 1, row 0", "--solid-layer 'deco'", "--ignore-layer 'deco'"] {
        assert!(why.contains(part), "{part} is not in {why}");
    }
    let why = refused("alone.tmx", two("100,100", "deco").replace(">1,0<", ">0,0<"));
    assert!(why.contains("nothing is solid") && why.contains("gone.tsx: cannot read"), "{why}");
}

#[test]
fn missing_templates() {
    let text = |class: &str| {
        let object = r#"<object id="5" template="none.tx" x="3" y="4"/>"#;
        rows(&["#."]).replace("class=\"Solid\">", &format!("class=\"{class}\">{object}"))
    };
    let plain = bake("plain.tmx", text(""));
    assert!(plain["solid"] == 1 && says(&plain, "warnings", "object 5: template"), "{plain}");
    let why = refused("solid.tmx", text("Solid"));
    for part in ["layer 'L'", "object 5", "none.tx", "cannot read", "its form is not known", "--ignore-layer 'L'"] {
        assert!(why.contains(part), "{part} is not in {why}");
    }
}

/// Other systems write `\`, and do not distinguish case.
#[test]
fn names_of_files() {
    let home = folder("lenient");
    fs::create_dir_all(home.join("sub")).unwrap();
    let set = r#"<tileset name="t" tilewidth="16" tileheight="16" tilecount="1" columns="1"><tile id="0" type="Solid"/></tileset>"#;
    fs::write(home.join("sub/a.tsx"), set).unwrap();
    for (source, noted) in [("sub\\a.tsx", false), ("sub/A.tsx", true), ("SUB\\A.tsx", true)] {
        let text = format!(
            r#"<map orientation="orthogonal" width="2" height="1" tilewidth="16" tileheight="16"><tileset firstgid="1" source="{source}"/>
            <layer name="l" width="2" height="1"><data encoding="csv">1,0</data></layer></map>"#
        );
        let level = bake("names.tmx", text);
        assert_eq!(level["solid"], 1, "{source}");
        let note = format!("the file '{source}' is read from ");
        let notes = level["notes"].as_array().unwrap();
        assert_eq!(notes.iter().any(|line| line.as_str().unwrap().starts_with(&note)), noted, "{notes:?}");
    }
}

/// Games use the words `kind` and `shape`, too.
#[test]
fn properties_with_words_of_ours() {
    let villager = r#"<object id="7" x="0" y="0" width="8" height="8"><properties><property name="kind" value="villager"/></properties></object>"#;
    let text = rows(&["#."]).replace("class=\"Solid\">", &format!(">{villager}"));
    let level = bake("kind.tmx", &text);
    assert!(level["solid"] == 1 && says(&level, "notes", "1 object with the property kind, such as 'villager'"));
    let hole = bake("hole.tmx", text.replace("villager", "wall"));
    assert_eq!(hole["segments"], 8);
    let why = refused("solid.tmx", text.replace("name=\"L\"", "name=\"Collision\""));
    assert!(why.contains("object 7 has the kind 'villager'; the kinds are solid, hole, wall and one-way"), "{why}");
    for (value, solid) in [("box", true), ("round", true), ("slope-botom-left", false)] {
        let tile = format!(
            r#"<tile id="0" type="Solid"><properties><property name="shape" value="{value}"/></properties></tile>"#
        );
        let text = rows(&["##."]).replace(r#"<tile id="0" type="Solid"/>"#, &tile);
        if solid {
            let level = bake("shape.tmx", &text);
            assert!(
                level["solid"] == 2 && says(&level, "warnings", &format!("the property shape '{value}' of 1 tile"))
            );
        } else {
            assert!(refused("shape.tmx", &text).contains("property shape 'slope-botom-left' is not a shape"));
        }
    }
}

/// Each cell becomes several square ones, and the tiles are where Tiled draws them.
#[test]
fn cells_that_are_not_square() {
    let text = |sizes: &str| {
        rows(&["#.#", "=.."])
            .replace("tilewidth=\"16\" tileheight=\"16\" infinite", &format!("{sizes} infinite"))
            .replace("name=\"t\" tilewidth=\"16\" tileheight=\"16\"", &format!("name=\"t\" {sizes}"))
    };
    let level = bake("high.tmx", text("tilewidth=\"16\" tileheight=\"24\""));
    let expected = [("cell", 8), ("width", 6), ("height", 6), ("solid", 12)];
    assert!(expected.iter().all(|(name, count)| level[*name] == *count), "{level}");
    assert!(says(
        &level,
        "notes",
        "cells of 16x24 pixels become cells of 8x8: each of them is 2x3 of these, and takes a byte for each"
    ));
    // The one-way edge of a tile is as wide as the tile.
    assert_eq!(level["segments"], 1);
    assert_eq!(bake("wide.tmx", text("tilewidth=\"32\" tileheight=\"16\""))["solid"], 4);
    let grid = text("tilewidth=\"32\" tileheight=\"16\"")
        .replace("name=\"t\" tilewidth=\"32\"", "name=\"t\" tilerendersize=\"grid\" tilewidth=\"24\"");
    assert_eq!(bake("grid.tmx", grid)["solid"], 4);
}

#[test]
fn negative_sizes() {
    let area = |more: &str| {
        let text = map(4, 2, "1,0,0,0,0,0,0,0", "")
            .replace("class=\"Solid\">", &format!(r#" ><object id="7" x="40" y="20" {more}/>"#));
        let level = bake("negative.tmx", text);
        assert!(says(&level, "warnings", "object 7 of layer 'L': its size is negative"));
        level["objects"][0]["area"].clone()
    };
    assert_eq!(area(r#"width="-16" height="8""#), json!([24.0, 20.0, 40.0, 28.0]));
    assert_eq!(area(r#"width="16" height="-8""#), json!([40.0, 12.0, 56.0, 20.0]));
    assert_eq!(area(r#"width="-16" height="8" rotation="90""#), json!([32.0, 4.0, 40.0, 20.0]));
    // A tile lies above its point.
    assert_eq!(area(r#"gid="3" width="16" height="-8""#), json!([40.0, 20.0, 56.0, 28.0]));
}

/// Tiled does not write a property that has the value that its class gives it.
#[test]
fn classes_of_a_project() {
    let home = folder("lenient").join("project");
    fs::create_dir_all(home.join("maps")).unwrap();
    let member = json!({"name": "solid", "type": "bool", "value": true});
    let speed = json!({"name": "speed", "type": "float", "value": 2.5});
    let project = |used: &[&str]| {
        let brick = json!({"name": "Brick", "type": "class", "members": [member.clone()], "useAs": used});
        let lift = json!({"name": "Lift", "type": "class", "members": [speed.clone()], "useAs": ["object"]});
        json!({"propertyTypes": [brick, lift, {"name": "E", "type": "enum", "values": ["a"]}]}).to_string()
    };
    let text = rows(&["#.##"])
        .replace("type=\"Solid\"", "type=\"Brick\"")
        .replace("class=\"Solid\">", r#"><object id="3" type="Lift" x="1" y="1" width="4" height="4"/>"#);
    let path = home.join("maps/level.tmx");
    fs::write(&path, text).unwrap();
    fs::write(home.join("g.tiled-project"), project(&["tile", "object"])).unwrap();
    let ran = level(&run("bake", &path, "--json"));
    assert_eq!((&ran["solid"], &ran["objects"][0]["properties"]["speed"]), (&json!(3), &json!([2.5])), "{ran}");
    fs::write(home.join("maps/a.tiled-project"), "{").unwrap();
    let ran = run("bake", &path, "--json --solid Brick");
    assert!(says(&level(&ran), "notes", "a.tiled-project is not read: EOF"));
    fs::write(home.join("maps/b.tiled-project"), "{}").unwrap();
    let ran = run("bake", &path, "--json --solid Brick");
    assert!(says(&level(&ran), "notes", "several projects"));
    fs::remove_file(home.join("maps/a.tiled-project")).unwrap();
    fs::remove_file(home.join("maps/b.tiled-project")).unwrap();
    // The class is for something else.
    fs::write(home.join("g.tiled-project"), project(&["layer"])).unwrap();
    let ran = run("bake", &path, "--json");
    assert!(ran.status == 2 && ran.err.contains("the name of tiles is 'Brick'"), "{ran:?}");
}

#[test]
fn layers_with_less_than_their_tiles() {
    let good = rows(&["##"]);
    let short = good.replace("<data encoding=\"csv\">1,1</data>", "<data><tile gid=\"1\"/></data>");
    let level = bake("short.tmx", short);
    assert!(
        level["solid"] == 1
            && says(&level, "warnings", "layer 'World': its tiles are 1, fewer than its width and height")
    );
    for (i, nothing) in ["", "<data encoding=\"csv\"></data>"].into_iter().enumerate() {
        let layer = format!(r#"</layer><layer name="none" width="2" height="1">{nothing}</layer>"#);
        let level = bake(&format!("none{i}.tmx"), good.replace("</layer>", &layer));
        assert!(level["solid"] == 2 && says(&level, "warnings", "layer 'none': it has no data, so it is empty"));
    }
}

/// Programs other than Tiled write null, and numbers as texts.
#[test]
fn odd_values_in_json() {
    let mut text = json_map(json_layer());
    let object = json!({"id": "2", "x": "0", "y": 0, "width": "4.5", "height": 4, "type": "Solid", "point": null,
        "ellipse": null, "visible": null});
    text["layers"] = json!([text["layers"][0], {"type": "objectgroup", "name": "o", "objects": [object]}]);
    text["tilewidth"] = json!("16");
    text["infinite"] = Value::Null;
    text["tilesets"][0]["tileproperties"] = Value::Null;
    for name in ["opacity", "visible", "offsetx", "offsety", "parallaxx"] {
        text["layers"][0][name] = Value::Null;
    }
    let level = bake("odd.tmj", text.to_string());
    assert_eq!((&level["solid"], &level["segments"]), (&json!(1), &json!(4)));
    assert_eq!(level["notes"], json!([]), "null is not hidden");
    text["tilewidth"] = json!("x");
    assert!(refused("text.tmj", text.to_string()).contains("expected a whole number"));
}

/// They are outside of every level. Only a solid there is refused.
#[test]
fn objects_a_million_pixels_away() {
    let text =
        |class: &str, object: &str| rows(&["#."]).replace("class=\"Solid\">", &format!("class=\"{class}\">{object}"));
    for object in [
        r#"<object id="7" x="1e9" y="0" width="4" height="4"/>"#,
        r#"<object id="7" x="0" y="0" width="4000000" height="4"/>"#,
        r#"<object id="7" x="-999999" y="0"><polygon points="1000500,0 1000600,0 1000600,9"/></object>"#,
    ] {
        let level = bake("far.tmx", text("", object));
        assert!(level["solid"] == 1 && says(&level, "warnings", "it is outside of the domain"), "{object}");
        let why = refused("far_solid.tmx", text("Solid", object));
        assert!(why.contains("object 7 of layer 'L'") && why.contains("outside of the domain"), "{why}");
    }
}

#[test]
fn collision_shapes_without_an_inside() {
    let drawn = |inner: &str| {
        let shape =
            format!(r#"<tile id="0"><objectgroup><object id="1" x="0" y="0" {inner}</object></objectgroup></tile>"#);
        refused("shape.tmx", rows(&["#."]).replace(r#"<tile id="0" type="Solid"/>"#, &shape))
    };
    let why = drawn(r#"><polygon points="0,0 16,16"/>"#);
    assert!(why.contains("tileset 't': the collision polygon of tile 0 has 2 corners: it needs 3"), "{why}");
    assert!(drawn(r#"width="16">"#).contains("a collision shape of tile 0 has no width or no height"));
}

/// In Tiled the last one counts: the others have no tile in the layers.
#[test]
fn tilesets_that_begin_at_the_same_tile() {
    let second = |tile: &str| {
        let set = r#"<tileset firstgid="1" name="u" tilewidth="16" tileheight="16" tilecount="4" columns="4">"#;
        map(2, 1, "1,2", "").replace("<layer", &format!("{set}{tile}</tileset><layer"))
    };
    let level = bake("twice.tmx", second(r#"<tile id="1" type="Solid"/>"#));
    assert!(level["solid"] == 1 && level["one_way"] == 0, "{level}");
    assert!(says(&level, "warnings", "tileset 't': it begins at tile 1, as tileset 'u' after it"));
    assert!(refused("neither.tmx", second("")).contains("tileset 't': it begins at tile 1"));
}

#[test]
fn files_that_are_no_maps() {
    let set = json!({"name": "t", "tilewidth": 16, "tileheight": 16, "tilecount": 1, "columns": 1, "image": "a.png", "type": "tileset"});
    let good = rows(&["##"]);
    for (name, text, why) in [
        (
            "a.lua",
            "return {\n  version = \"1.10\",\n}".to_owned(),
            "an export of Tiled for programs: give the map itself",
        ),
        (
            "a.js",
            "(function(name,data){\n if(typeof onTileMapLoaded === 'undefined') {}".to_owned(),
            "an export of Tiled for programs",
        ),
        (
            "lfs.tmx",
            "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 9\n".to_owned(),
            "a pointer of Git LFS, not the file: run `git lfs pull`",
        ),
        ("merge.tmx", good.replacen("<map", "<<<<<<< HEAD\n<map", 1), "line 2: a mark of an unsolved git merge"),
        ("merge.tmj", "{\n<<<<<<< HEAD\n\"orientation\":1}".to_owned(), "line 2: a mark of an unsolved git merge"),
        ("comment.json", "// a map\n{}".to_owned(), "it begins with a comment"),
        (
            "a.tsx",
            "<?xml version=\"1.0\"?>\n<tileset name=\"t\"/>".to_owned(),
            "a tileset of Tiled: give a map that uses it",
        ),
        ("a.tsj", set.to_string(), "a tileset of Tiled: give a map that uses it"),
        ("a.tx", "<template><object/></template>".to_owned(), "a template of Tiled: give a map that uses it"),
        ("a.tj", r#"{"object":{"id":1},"type":"template"}"#.to_owned(), "a template of Tiled: give a map that uses it"),
        (
            "a.tiled-project",
            r#"{"automappingRulesFile":"","propertyTypes":[]}"#.to_owned(),
            "a project of Tiled: give a map or a .world",
        ),
        (
            "data.json",
            r#"{"identifier":"A","uniqueIdentifer":"x","layers":[]}"#.to_owned(),
            "a simplified export of LDtk: give the .ldtk",
        ),
        (
            "rows.tmx",
            good.replace(">1,1<", ">0,0\n0,1<"),
            "layer 'World': '0\\n0' is not a tile, in column 1, row 0: a comma is missing",
        ),
        (
            "comma.tmx",
            map(1, 1, "1", r#"<object id="1" x="1,5" y="0" width="4" height="4"/>"#),
            "object 1: x is '1,5', not a number: write a point, not a comma",
        ),
    ] {
        let found = refused(name, text);
        assert!(found.contains(&why.replace("\\n", " ")), "{why} is not in {found}");
    }
}
