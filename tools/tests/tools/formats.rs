//! What old versions and other writers of Tiled and `LDtk` put into their files.

use serde_json::{Value, json};
use tilesat_tools::model::map::Map;
use tilesat_tools::read::load;

use crate::support::{self, Ran, rows, run, scratch};

/// The only map of a file.
fn read(name: &str, text: &str) -> Map {
    load(&scratch("formats", name, text), None).unwrap().maps.remove(0)
}

fn bake(name: &str, text: &str) -> Ran {
    run("bake", scratch("formats", name, text), "--json")
}

/// A map in JSON of these layers, with a tileset.
#[allow(clippy::needless_pass_by_value, reason = "the macro takes it by reference")]
fn json_map(layers: Value) -> Value {
    json!({"orientation": "orthogonal", "width": 2, "height": 1, "tilewidth": 16, "tileheight": 16, "layers": layers,
        "tilesets": [{"firstgid": 1, "name": "t", "tilewidth": 16, "tileheight": 16, "tilecount": 2, "columns": 2,
            "tiles": [{"id": 0, "type": "Solid"}]}]})
}

#[allow(clippy::needless_pass_by_value, reason = "the macro takes it by reference")]
fn json_layer(data: Value) -> Value {
    json!({"type": "tilelayer", "name": "World", "width": 2, "height": 1, "data": data})
}

/// Since Tiled 1.9 a tile of a collection can be a part of its image.
#[test]
fn a_tile_that_is_a_part_of_its_image() {
    let part = r#"<tile id="3" type="Solid" x="16" y="0" width="32" height="16"><image source="a.png" width="128" height="128"/></tile>"#;
    let level = rows(&[".."]).replace(r#"<tile id="0" type="Solid"/>"#, part);
    let tile = json!({"id": 3, "image": "a.png", "imagewidth": 128, "imageheight": 128, "x": 16, "y": 0, "width": 32,
        "height": 16, "type": "Solid"});
    let mut map = json_map(json!([json_layer(json!([4, 0]))]));
    map["tilesets"][0]["tiles"] = json!([tile]);
    for (name, text) in [("part.tmx", level.replace("0,0</data>", "4,0</data>")), ("part.tmj", map.to_string())] {
        assert_eq!(read(name, &text).tilesets[0].size_of(3), (32, 16), "{name}");
        let ran = bake(name, &text);
        assert!(ran.status == 0 && ran.out.contains("\"solid\":2,"), "{name}: {ran:?}");
    }
    let whole = |text: String| text.replace(r#" x="16" y="0" width="32" height="16""#, "");
    assert_eq!(read("whole.tmx", &whole(level)).tilesets[0].size_of(3), (128, 128));
}

/// Some programs wrap text in base64.
#[test]
fn wrapped_base64() {
    let level = rows(&["#."]);
    for (packing, text) in [
        ("", "AQAAAAAAAAA="),
        (" compression=\"zlib\"", "eJxjZIAAAAAQAAI="),
        (" compression=\"zstd\"", "KLUv/SAIQQAAAQAAAAAAAAA="),
    ] {
        let wrapped = format!("<data encoding=\"base64\"{packing}>\n{}\r\n\t{}\n</data>", &text[..5], &text[5..]);
        let map = read("wrapped.tmx", &level.replace("<data encoding=\"csv\">1,0</data>", &wrapped));
        assert_eq!(map.layers[0].tiles().unwrap().drawn().count(), 1, "{packing}");
    }
}

/// Tiled counts the tiles of an old tileset from its image: it has one margin.
#[test]
fn tiles_of_old_tilesets() {
    let set = |width: u32, height: u32, margin: u32, spacing: u32| {
        let image = format!(r#"<image source="a.png" width="{width}" height="{height}"/>"#);
        let level = rows(&[".."])
            .replace(r#"tilecount="4" columns="4">"#, &format!(r#"margin="{margin}" spacing="{spacing}">{image}"#));
        let map = read("old.tmx", &level);
        (map.tilesets[0].columns, map.tilesets[0].count)
    };
    assert_eq!(set(64, 32, 0, 0), (4, Some(8)));
    assert_eq!(set(68, 34, 4, 0), (4, Some(4)));
    assert_eq!(set(69, 35, 2, 1), (4, Some(8)));
    assert_eq!(set(66, 32, 3, 0), (3, Some(3)));
}

/// A document type can have comments.
#[test]
fn comments_in_a_document_type() {
    let level = rows(&["#."]);
    for inner in ["<!-- don't -->", "<!-- > ]> \" -->", "<?a don't ?>", "<!ENTITY a \"<!-- '\">"] {
        let text = level.replacen("<map", &format!("<!DOCTYPE map [{inner}]>\n<map"), 1);
        assert_eq!(read("type.tmx", &text).size, (2, 1), "{inner}");
    }
    let torn = level.replacen("<map", "<!DOCTYPE map [<!-- \n<map", 1);
    assert!(bake("torn.tmx", &torn).err.contains("the file ends within a comment"));
}

/// Before 0.8, `LDtk` listed only the cells with a value, and numbered values from 0 on.
#[test]
fn old_projects() {
    let new = support::ldtk(&["Empty", "Full"], 2, 1, "1,2");
    let old = new.replace(r#""intGridCsv":[1,2]"#, r#""intGrid":[{"coordId":1,"v":1},{"coordId":0,"v":0}]"#);
    let old = old.replace(r#""value":1,"#, "").replace(r#""value":2,"#, "");
    let level = |text: &str| support::level(&scratch("formats", "old.ldtk", text)).unwrap();
    assert_eq!(level(&old).tiles, level(&new).tiles);
    assert!(level(&old).tiles[0] != level(&old).tiles[1]);
    for (cell, why) in
        [(r#""coordId":2,"v":0"#, "value 0 in cell 2 of 2"), (r#""coordId":0,"v":-1"#, "value -1 in cell 0")]
    {
        let ran = bake("wrong.ldtk", &old.replace(r#""coordId":1,"v":1"#, cell));
        assert!(ran.status == 2 && ran.err.contains(why), "{ran:?}");
    }
    // Neither form.
    let none = new.replace(r#""intGridCsv":[1,2]"#, r#""x":0"#);
    let ran = bake("none.ldtk", &none.replacen('{', r#"{"jsonVersion":"0.7.2","#, 1));
    assert!(ran.status == 2 && ran.err.contains("saved by LDtk 0.7.2: open it in a newer one, and save it"), "{ran:?}");
    assert!(bake("older.ldtk", &none).err.contains("saved by an old LDtk: open it"));
}

/// What a property is called does not make a map a project.
#[test]
fn properties_with_the_names_of_a_project() {
    let mut map = json_map(json!([json_layer(json!([1, 0]))]));
    map["properties"] = json!([{"name": "levels", "type": "string", "value": "defs"}]);
    map["editorsettings"] = json!({"levels": 1, "defs": {}});
    assert_eq!(read("levels.json", &map.to_string()).size, (2, 1));
    let project = support::ldtk(&["Full"], 2, 1, "1,0").replacen('{', r#"{"x":"\"orientation\"","#, 1);
    assert!(read("project.json", &project).values);
}

/// Programs other than Tiled write both names of the class, whole numbers as floats, and null.
#[test]
fn json_of_other_programs() {
    let object = json!({"id": 2.0, "x": 0, "y": 0, "width": 4, "height": 4, "type": "Solid", "class": "Solid",
        "properties": null});
    let group = json!({"type": "objectgroup", "name": "things", "objects": [object], "properties": null});
    let mut map = json_map(json!([json_layer(json!([1.0, 0])), group]));
    map["tilewidth"] = json!(16.0);
    map["tilesets"][0]["tiles"][0]["class"] = json!("");
    map["tilesets"][0]["columns"] = Value::Null;
    let ran = bake("other.tmj", &map.to_string());
    assert!(ran.status == 0 && ran.out.contains("\"solid\":1,") && ran.out.contains("\"segments\":4"), "{ran:?}");
    map["tilewidth"] = json!(16.5);
    let ran = bake("half.tmj", &map.to_string());
    assert!(ran.status == 2 && ran.err.contains("16.5"), "{ran:?}");
}

/// As deep as in XML.
#[test]
fn groups_in_json() {
    let nested = |depth: usize| {
        let group = |inner: Value, _| json!({"type": "group", "name": "g", "layers": [inner]});
        json_map(json!([(0..depth).fold(json_layer(json!([1, 0])), group)])).to_string()
    };
    assert_eq!(read("deep.tmj", &nested(90)).layers.len(), 1);
    let ran = bake("deeper.tmj", &nested(110));
    assert!(ran.status == 2 && ran.err.contains("nested more than"), "{ran:?}");
    let open = "{\"layers\":[".repeat(200_000);
    for text in [open.clone(), json_map(json!([])).to_string().replacen('{', &format!("{{\"x\":{open}"), 1)] {
        let ran = bake("deepest.tmj", &text);
        assert!(ran.status == 2 && ran.err.contains("nested more than"), "{ran:?}");
    }
}
