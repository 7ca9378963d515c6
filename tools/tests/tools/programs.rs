//! Files that other programs than Tiled and `LDtk` write, or have saved once more.

use std::fs;
use std::path::PathBuf;

use serde_json::{Value, json};

use crate::support::{Ran, ldtk, map, rows, run, scratch};

fn file(name: &str, text: impl AsRef<[u8]>) -> PathBuf {
    scratch("programs", name, text)
}

fn bake(name: &str, text: impl AsRef<[u8]>, options: &str) -> Ran {
    run("bake", file(name, text), &format!("--json {options}"))
}

/// A line of JSON about a level that is read.
fn level(name: &str, text: impl AsRef<[u8]>, options: &str) -> Value {
    let ran = bake(name, text, options);
    assert_eq!(ran.status, 0, "{name}: {ran:?}");
    serde_json::from_str(ran.last()).unwrap()
}

fn refused(name: &str, text: impl AsRef<[u8]>, why: &str) {
    let ran = bake(name, text, "");
    assert!(ran.status == 2 && ran.out.is_empty() && ran.err.lines().count() == 1, "{ran:?}");
    assert!(ran.err.contains(why), "{name}: {why} is not in {}", ran.err);
}

fn has_note(level: &Value, words: &str) -> bool {
    level["notes"].as_array().unwrap().iter().any(|note| note.as_str().unwrap().contains(words))
}

/// A text in UTF-16 with its mark, of the order that the function gives.
fn utf16(text: &str, bytes: fn(u16) -> [u8; 2]) -> Vec<u8> {
    format!("\u{feff}{text}").encode_utf16().flat_map(bytes).collect()
}

/// Some shells and editors save text in UTF-16. Old programs wrote Latin-1 and windows-1252.
#[test]
fn encodings() {
    let named = |encoding: &str| {
        let text = rows(&["#."]).replace("UTF-8", encoding);
        text.replace(r#"name="World""#, "name=\"H\u{f6}hle \u{2019}1\" visible=\"0\"")
    };
    let is_read = |level: &Value| has_note(level, "layer 'H\u{f6}hle \u{2019}1' is hidden") && level["solid"] == 1;
    assert!(is_read(&level("plain.tmx", named("UTF-8"), "")));
    assert!(is_read(&level("little.tmx", utf16(&named("UTF-16"), u16::to_le_bytes), "")));
    assert!(is_read(&level("big.tmx", utf16(&named("UTF-16"), u16::to_be_bytes), "")));
    // Without its mark, the first sign shows the order.
    assert!(is_read(&level("bare.tmx", &utf16(&named("UTF-16"), u16::to_le_bytes)[2..], "")));
    assert!(is_read(&level("bare.tmx", &utf16(&named("UTF-16"), u16::to_be_bytes)[2..], "")));
    let wide: Vec<u8> = named("UTF-32").chars().flat_map(|c| u32::from(c).to_le_bytes()).collect();
    refused("wide.tmx", [&[0xff, 0xfe, 0, 0], &wide[..]].concat(), "text in UTF-32: save it as UTF-8");
    // Its name is wrong, and its text is right.
    assert!(is_read(&level("wrong.tmx", named("ISO-8859-1"), "")));
    let byte = |c: char| if c == '\u{2019}' { 0x92 } else { u8::try_from(u32::from(c)).unwrap() };
    for encoding in ["windows-1252", "ISO-8859-1", "latin1"] {
        let bytes: Vec<u8> = named(encoding).chars().map(byte).collect();
        assert!(is_read(&level("western.tmx", &bytes, "")), "{encoding}");
    }
    let bytes: Vec<u8> = named("UTF-8").chars().map(byte).collect();
    refused("no_name.tmx", &bytes, "not UTF-8 text: save it as UTF-8");

    let project = ldtk(&["Full"], 2, 1, "1,0");
    assert_eq!(level("wide.ldtk", utf16(&project, u16::to_le_bytes), "")["solid"], 1);
    let set = r#"<tileset name="t" tilewidth="16" tileheight="16"><tile id="0" type="Solid"/></tileset>"#;
    file("wide.tsx", utf16(set, u16::to_be_bytes));
    let outside = rows(&["#."]);
    let (start, rest) = (outside.find("<tileset").unwrap(), outside.find("<layer").unwrap());
    let outside = format!("{}<tileset firstgid=\"1\" source=\"wide.tsx\"/>{}", &outside[..start], &outside[rest..]);
    assert_eq!(level("outside.tmx", outside, "")["solid"], 1);

    let whole = utf16(&named("UTF-16"), u16::to_le_bytes);
    refused("odd.tmx", &whole[..whole.len() - 1], "damaged text in UTF-16: save it as UTF-8");
    refused("half.tmx", [&whole[..], &[0x00, 0xd8]].concat(), "damaged text in UTF-16");
}

/// Tiled unpacks zlib and gzip, whichever of the two names a layer has. Others leave the padding
/// of base64 out.
#[test]
fn packings() {
    let (zlib, gzip) = ("eJxjZEAARiAGAAAkAAM=", "H4sIAAAAAAACA2NkQABGIAYAob1v+hAAAAA=");
    for (name, data) in [("zlib", zlib), ("zlib", gzip), ("gzip", zlib), ("gzip", gzip)] {
        for data in [data, data.trim_end_matches('=')] {
            let own = format!(r#"<data encoding="base64" compression="{name}">{data}</data>"#);
            let text = map(2, 2, "", "").replace(r#"<data encoding="csv"></data>"#, &own);
            assert_eq!(level("packed.tmx", text, "")["solid"], 2, "{name} {data}");
        }
    }
    for data in ["AQAAAAAAAAAAAAAAAQAAAA==", "AQAAAAAAAAAAAAAAAQAAAA"] {
        let text = map(2, 2, data, "").replace("csv", "base64");
        assert_eq!(level("plain.tmx", text, "")["solid"], 2);
    }
}

/// A finite map gives the size of its layers, too.
#[test]
fn sizes() {
    let good = map(3, 2, "1,0,0,1,1,0", "");
    let text = good.replace(r#"name="World" width="3" height="2""#, r#"name="World""#);
    let read = level("no_size.tmx", &text, "");
    assert_eq!((&read["width"], &read["height"], &read["solid"]), (&json!(3), &json!(2), &json!(3)));
    refused("five.tmx", text.replace("1,0,0,1,1,0", "1,0,0,1,1"), "5 tiles, but 3x2 cells need 6");
    let layer = json!({"type": "tilelayer", "name": "World", "data": [1, 0, 0, 1, 1, 0]});
    let set = json!({"firstgid": 1, "name": "t", "tilewidth": 16, "tileheight": 16, "tilecount": 1, "columns": 1,
        "tiles": [{"id": 0, "type": "Solid"}]});
    let json = json!({"orientation": "orthogonal", "width": 3, "height": 2, "tilewidth": 16, "tileheight": 16,
        "layers": [layer], "tilesets": [set]});
    assert_eq!(level("no_size.tmj", json.to_string(), "")["solid"], 3);

    let decimals = good.replace(r#"width="3""#, r#"width="3.0""#).replace(r#"tilewidth="16""#, r#"tilewidth="16.00""#);
    assert_eq!(level("decimals.tmx", decimals, "")["solid"], 3);
    for text in ["3.5", "3.0.0", "three", ".0"] {
        let text = good.replacen(r#"width="3""#, &format!("width=\"{text}\""), 1);
        refused("part.tmx", text, "<map> has width=");
    }
}

/// As in Tiled, any case counts, and every value except 0, false and nothing.
#[test]
fn truth() {
    let solid = |value: &str| {
        let text = rows(&["#."]).replace(
            r#"<tile id="0" type="Solid"/>"#,
            &format!(
                r#"<tile id="0"><properties><property name="solid" type="bool" value="{value}"/></properties></tile>"#
            ),
        );
        bake("truth.tmx", text, "").status == 0
    };
    assert!(["true", "True", "TRUE", "1", "yes"].into_iter().all(solid));
    assert!(!["false", "False", "0", ""].into_iter().any(solid));
}

/// Some games give tiles a text, or only say where bodies can walk. Options name both.
#[test]
fn values_of_properties_as_names() {
    let tile = |id: u32, name: &str, rest: &str| {
        format!(r#"<tile id="{id}"><properties><property name="{name}" {rest}/></properties></tile>"#)
    };
    let own = tile(0, "type", r#"value="wall""#)
        + &tile(1, "passable", r#"type="bool" value="false""#)
        + &tile(2, "Height", r#"type="int" value="8""#);
    let start = r#"<tile id="0" type="Solid"/><tile id="1" type="OneWay"/><tile id="2" type="Kill"/>"#;
    let text = map(4, 1, "1,2,3,0", "").replace(start, &own);
    refused(
        "hint.tmx",
        text.replace("passable", "p"),
        "tiles have the property 'type' = 'wall': add --solid 'type:wall'",
    );
    let solid = |options: &str| {
        let read = level("values.tmx", &text, options);
        (read["solid"].as_u64().unwrap(), read["one_way"].as_u64().unwrap())
    };
    assert_eq!(solid("--solid type:wall"), (1, 0));
    assert_eq!(solid("--solid TYPE:Wall --solid passable:false --one-way height:8"), (2, 1));
    assert_eq!(solid("--solid height:8=half-bottom"), (1, 0));
    let texts = map(1, 1, "1", "").replace(start, &tile(0, "solid", r#"value="yes""#));
    refused("texts.tmx", &texts, "make it a bool that is true, or add --solid 'solid:yes'");
    assert_eq!(level("texts.tmx", &texts, "--solid solid:yes")["solid"], 1);
}

/// If authors draw collision shapes for ramps only, the ground between them is no accident.
#[test]
fn ground_without_shapes_beside_ramps() {
    let ramp = r#"<tile id="1"><objectgroup><object x="0" y="0"><polygon points="16,0 16,16 0,16"/></object></objectgroup></tile>"#;
    let start = r#"<tile id="0" type="Solid"/><tile id="1" type="OneWay"/><tile id="2" type="Kill"/>"#;
    let text = |name: &str, csv: &str| {
        map(4, 1, csv, "").replace(start, ramp).replace(r#"name="World""#, &format!("name=\"{name}\""))
    };
    let says = "GUESS: 2 tiles of layer 'Ground' are not solid";
    let found = level("ramps.tmx", text("Ground", "1,2,1,0"), "");
    assert!(found["solid"] == 1 && has_note(&found, says), "{found}");
    assert_eq!(level("ramps.tmx", text("Ground", "1,2,1,0"), "--solid-layer Ground")["solid"], 3);
    // Ornaments, a layer of another name, and a layer that something else marks.
    for (name, csv, options) in
        [("Ground", "1,2,2,0", ""), ("World", "1,2,1,0", ""), ("Ground", "1,2,1,0", "--one-way t:0")]
    {
        assert!(!has_note(&level("others.tmx", text(name, csv), options), "are not solid"), "{name} {csv}");
    }
}

/// Other programs write null for an empty list, and whole numbers as decimals. Scripts write
/// projects without definitions.
#[test]
fn projects_of_other_programs() {
    let good: Value = serde_json::from_str(&ldtk(&["Full"], 2, 1, "1,0")).unwrap();
    let mut text = good.clone();
    text["worlds"] = Value::Null;
    text["defs"]["tilesets"] = Value::Null;
    let found = &mut text["levels"][0];
    found["fieldInstances"] = Value::Null;
    (found["worldX"], found["pxWid"], found["pxHei"]) = (json!(16.0), json!(32.0), json!("16"));
    for name in ["gridTiles", "autoLayerTiles", "entityInstances"] {
        found["layerInstances"][0][name] = Value::Null;
    }
    found["layerInstances"][0]["__gridSize"] = json!(16.0);
    found["layerInstances"][0]["intGridCsv"] = json!([1.0, 0]);
    let entity = json!({"__identifier": "Door", "__tags": null, "fieldInstances": null, "px": [0.0, 0],
        "width": 16.0, "height": 16.0});
    let layers = found["layerInstances"].as_array_mut().unwrap();
    layers.push(json!({"__identifier": "E", "__type": "Entities", "__gridSize": 16.0, "entityInstances": [entity]}));
    let read = level("null.ldtk", text.to_string(), "");
    assert_eq!((&read["solid"], &read["objects"][0]["class"]), (&json!(1), &json!("Door")));

    let mut bare = good.clone();
    bare["defs"]["layers"] = json!([]);
    bare["levels"][0]["layerInstances"][0]["__identifier"] = json!("Collision");
    assert!(has_note(&level("bare.ldtk", bare.to_string(), ""), "GUESS: value 1 of layer 'Collision' is full"));
    bare["levels"][0]["layerInstances"][0]["__identifier"] = json!("L");
    refused("bare.ldtk", bare.to_string(), "value 1 of layer 'L' has no identifier");
    bare["defs"]["layers"] = json!([{"uid": 7}]);
    refused("damaged.ldtk", bare.to_string(), "defs.layers has no uid 2: save the project again");
}

/// As the files of maps, those of levels may have names that are not quite right.
#[test]
fn names_of_separate_levels() {
    let good: Value = serde_json::from_str(&ldtk(&["Full"], 2, 1, "1,0")).unwrap();
    let folder = file("names.txt", "").with_file_name("apart");
    fs::create_dir_all(&folder).unwrap();
    fs::write(folder.join("One.ldtkl"), good["levels"][0].to_string()).unwrap();
    for (name, note) in [("apart/One.ldtkl", false), ("apart\\One.ldtkl", false), ("Apart/one.ldtkl", true)] {
        let mut text = good.clone();
        text["levels"][0] = json!({"identifier": "One", "externalRelPath": name, "layerInstances": null});
        let read = level("apart.ldtk", text.to_string(), "");
        assert!(read["solid"] == 1 && has_note(&read, "is read from") == note, "{name}: {read}");
    }
}

#[test]
fn files_of_other_kinds() {
    let program = "an export of Tiled for programs: give the map itself";
    for (name, text) in [
        ("a.lua", "local map = {}\nreturn map"),
        ("a.js", "var map = {};"),
        ("b.js", "module.exports = {};"),
        ("c.js", "export default {};"),
    ] {
        refused(name, text, program);
    }
    refused("a.csv", "1,2\n-1,0\n", "a table of numbers, without the size and the classes of tiles: give the map");
    refused("a.gz", b"\x1f\x8b\x08\x00\x00", "a packed file: unpack it first");
    refused("a.zip", b"PK\x03\x04\x00\x00", "a packed file: unpack it first");

    let good = rows(&["#."]);
    assert_eq!(level("case.tmx", good.replace("orthogonal", "Orthogonal"), "")["solid"], 1);
    let without = level("without.tmx", good.replace(r#" orientation="orthogonal""#, ""), "");
    assert!(without["solid"] == 1 && has_note(&without, "it has no orientation, and is read as an orthogonal map"));
    refused("without.tmj", r#"{"tilewidth":16}"#, "not a Tiled map: it has no orientation");
    refused("other.tmx", good.replace("orthogonal", "isometric"), "the map is isometric, not orthogonal");
    refused("zero.tmx", good.replace(r#"firstgid="1""#, r#"firstgid="0""#), "that of the first tileset is 1");
    refused("nameless.tmx", map(1, 1, "1", r#"<object x="a" y="0"/>"#), "<object>: x is 'a', not a number");
    let nothing = r#"{"maps":[],"patterns":null}"#;
    refused("null.world", nothing, "a world of Tiled without maps");
}

/// Programs that write XML of several namespaces give Tiled's names a prefix.
#[test]
fn namespaces() {
    let prefixed = |text: &str| {
        let named = |part: &str| {
            let (slash, name) = part.strip_prefix('/').map_or(("", part), |name| ("/", name));
            let prefix = if name.starts_with('?') || name.is_empty() { "" } else { "t:" };
            format!("{slash}{prefix}{name}")
        };
        let all = text.split('<').map(named).collect::<Vec<_>>().join("<");
        all.replacen("<t:map", "<t:map xmlns:t=\"http://mapeditor.org\" xmlns:e=\"urn:e\"", 1)
    };
    let plain = rows(&["#="]);
    let text = prefixed(&plain).replace("<t:layer", "<e:layer name=\"x\"/><t:layer e:name=\"other\" t:class=\"Wide\"");
    let read = level("prefix.tmx", text, "");
    assert_eq!((&read["solid"], &read["one_way"]), (&json!(1), &json!(1)));
    // The layer of another namespace is none.
    assert!(!read["warnings"].to_string().contains("'x'"), "{read}");
    refused("mixed.tmx", prefixed(&plain).replace("</t:map>", "</map>"), "</map> closes <t:map>");
    // One namespace for all needs no prefix.
    assert_eq!(level("one.tmx", plain.replacen("<map", "<map xmlns=\"http://mapeditor.org\"", 1), "")["solid"], 1);
}

#[test]
fn document_types() {
    let with = |declared: &str, class: &str| {
        let text = rows(&["#="]).replacen("<map", &format!("<!DOCTYPE map {declared}>\r\n<map"), 1);
        text.replace(r#"type="Solid""#, &format!("type=\"{class}\"")).replace('\n', "\r\n")
    };
    for declared in ["", r#"SYSTEM "http://mapeditor.org/dtd/1.0/map.dtd""#, r#"[<!ENTITY s "Solid">]"#] {
        assert_eq!(level("type.tmx", with(declared, "Solid"), "")["solid"], 1, "{declared}");
    }
    let used = with(r#"[<!ENTITY s "Solid">]"#, "&s;");
    refused("entity.tmx", used, "&s; is declared in the document type: write its text instead");
}
