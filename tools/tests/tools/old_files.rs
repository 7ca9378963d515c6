//! What the editors no longer write, or only rarely: it is read as they draw it, or refused with a
//! reason.

use tilesat_tools::read::load;
use tilesat_tools::rooms::{self, Cut};
use tilesat_tools::rules::flags::Flags;
use tilesat_tools::rules::ground::Ground;
use tilesat_tools::rules::options::Options;

use crate::support::{folder, layered, map, objects, rows, run, scratch};

fn ground(name: &str, text: &str) -> Ground {
    let levels = load(&scratch("old_files", name, text), None).unwrap();
    Ground::of(&levels.maps[0], &Options::default(), &mut Flags::default()).unwrap()
}

fn refused(name: &str, text: &str) -> String {
    let file = scratch("old_files", name, text);
    let ran = run("bake", &file, "--json");
    assert!(ran.status == 2 && ran.out.is_empty() && ran.err.lines().count() == 1, "{ran:?}");
    ran.err
}

/// Tiled draws a layer from its own column and row on, and has written 0 for years.
#[test]
fn a_layer_begins_at_its_own_cell() {
    let text = map(2, 1, "1,0", "").replace("name=\"World\"", "name=\"World\" x=\"3\" y=\"-2\"");
    assert_eq!(ground("moved.tmx", &text).origin, (48 << 16, -(32 << 16)));
    let text = r#"{"orientation":"orthogonal","width":2,"height":1,"tilewidth":16,"tileheight":16,
        "tilesets":[{"firstgid":1,"name":"t","tilewidth":16,"tileheight":16,"tilecount":1,"columns":1,"tiles":[{"id":0,"type":"Solid"}]}],
        "layers":[{"type":"tilelayer","name":"World","x":3,"y":-2,"width":2,"height":1,"data":[1,0]}]}"#;
    assert_eq!(ground("moved.tmj", text).origin, (48 << 16, -(32 << 16)));
}

/// Also where one more column would be the first negative one again.
#[test]
fn layers_far_away_are_refused() {
    for at in ["2147483647", "-2147483648", "4194304"] {
        let chunk = format!("<chunk x=\"{at}\" y=\"0\" width=\"1\" height=\"1\">1</chunk>");
        let text = map(1, 1, &chunk, "").replace("infinite=\"0\"", "infinite=\"1\"");
        let why = refused("chunk.tmx", &text);
        assert!(why.contains(&format!("layer 'World': it begins in column {at}, row 0: move it nearer")), "{why}");
        let text = map(1, 1, "1", "").replace("name=\"World\"", &format!("name=\"World\" x=\"{at}\""));
        assert!(refused("layer.tmx", &text).contains(&format!("it begins in column {at}, row 0")));
    }
}

#[test]
fn tiles_larger_than_images_are_refused() {
    let text = rows(&["##"]).replace("name=\"t\" tilewidth=\"16\"", "name=\"t\" tilewidth=\"4194303\"");
    let why = refused("wide.tmx", &text);
    assert!(why.contains("tileset 't': tiles of 4194303x16 pixels; a side has at most 65536"), "{why}");
    let layer = r#""__type":"Tiles","__tilesetDefUid":1,"gridTiles":[{"px":[0,0],"src":[0,0],"f":0,"t":1}]"#;
    let why = refused("wide.ldtk", &project(layer).replace("\"tileGridSize\":16", "\"tileGridSize\":4194303"));
    assert!(why.contains("layer 'L': tiles of 4194303 pixels; a side has at most 65536"), "{why}");
    let own = r#"<tile id="0" type="Solid"><image source="a.png" width="16" height="70000"/></tile>"#;
    let why = refused("high.tmx", &rows(&["##"]).replace(r#"<tile id="0" type="Solid"/>"#, own));
    assert!(why.contains("tileset 't': tiles of 16x70000 pixels"), "{why}");
}

#[test]
fn layers_that_nobody_sees_are_noted() {
    let text = rows(&["...", "###"]);
    for (from, to) in
        [("name=\"World\"", "name=\"World\" opacity=\"0\""), ("<layer", "<group name=\"g\" opacity=\"0\"><layer")]
    {
        let text = text.replace(from, to);
        let text = if to.starts_with("<group") { text.replace("</layer>", "</layer></group>") } else { text };
        let notes = ground("opacity.tmx", &text).notes;
        assert!(notes.iter().any(|note| note.starts_with("layer 'World' is hidden")), "{notes:?}");
    }
    let shown = ground("shown.tmx", &text.replace("name=\"World\"", "name=\"World\" opacity=\"0.25\""));
    assert!(shown.notes.is_empty(), "{:?}", shown.notes);
}

/// Other programs write whole numbers as floats.
#[test]
fn positions_in_a_world_as_floats() {
    scratch("old_files", "part.tmx", rows(&["...", "###"]));
    let world = r#"{"maps":[{"fileName":"part.tmx","x":64.0,"y":-32.0,"width":48.0,"height":32.0}],"type":"world"}"#;
    let levels = load(&scratch("old_files", "floats.world", world), None).unwrap();
    let place = levels.maps[0].place.unwrap();
    assert_eq!((place.x, place.y), (64, -32));
}

/// The polygon winds around a corner of the room, and nothing of it is within.
#[test]
fn a_polygon_beyond_two_sides_of_a_room() {
    let room = r#"<object id="1" x="320" y="320" width="200" height="200"/>"#;
    // Relative to the room at (256, 256): right above it, then far to the left of it.
    let bent = r#"<object id="2" x="0" y="0"><polygon points="300,100 60,100 100,260 120,100"/></object>"#;
    let levels = load(&scratch("old_files", "bent.tmx", objects(&[room, bent].concat())), None).unwrap();
    let cut = Cut { room: Some((16, 16)), ..Cut::default() };
    let world = rooms::bake(&levels.maps, &Options::default(), &cut).unwrap();
    let room = |name: &str| world.rooms.iter().find(|room| room.name == name).unwrap();
    let count = |name: &str| {
        let bytes = room(name).segments.as_deref().unwrap();
        tilesat::SegmentMap::from_bytes(bytes).unwrap().count()
    };
    // The square alone.
    assert_eq!(count("1 1"), 4);
    // A part of its upper edge lies on another part.
    assert!(count("0 0") >= 3);
}

fn project(layer: &str) -> String {
    format!(
        r#"{{"jsonVersion":"0.5.0","defs":{{"layers":[{{"uid":2,"intGridValues":[{{"value":1,"identifier":"Full"}}]}}],
        "tilesets":[{{"uid":1,"identifier":"T","pxWid":64,"pxHei":64,"tileGridSize":16,"enumTags":[{{"enumValueId":"Solid","tileIds":[1]}}]}}]}},
        "levels":[{{"identifier":"One","pxWid":64,"pxHei":32,"layerInstances":[{{"__identifier":"L","__cWid":4,"__cHei":2,"__gridSize":16,
        "__pxTotalOffsetX":0,"__pxTotalOffsetY":0,"layerDefUid":2,{layer}}}]}}]}}"#
    )
}

#[test]
fn layers_of_ldtk_that_would_lose_their_content() {
    for (layer, why) in [
        (r#""__type":"Hexagons","intGridCsv":[1,1,1,1,1,1,1,1]"#, "layer 'L': its type 'Hexagons' is unknown"),
        (
            r#""__type":"Tiles","gridTiles":[{"px":[0,0],"src":[0,0],"f":0,"t":1}]"#,
            "layer 'L': it has tiles, and no tileset: choose one in LDtk",
        ),
        (
            r#""__type":"Tiles","__tilesetDefUid":1,"gridTiles":[{"px":[0,0],"d":[0,1]}]"#,
            "layer 'L': its tiles have no t: saved by LDtk 0.5.0: open it in a newer one, and save it",
        ),
    ] {
        let found = refused("content.ldtk", &project(layer));
        assert!(found.contains(why), "{why} is not in {found}");
    }
}

/// Rules can move their tiles, also over the border, where `LDtk` cuts them off.
#[test]
fn tiles_of_rules_lie_between_cells() {
    let tile = |x: i32, y: i32| {
        let tile = format!(r#"{{"px":[{x},{y}],"src":[16,0],"f":0,"t":1}}"#);
        let layer = format!(r#""__type":"AutoLayer","__tilesetDefUid":1,"autoLayerTiles":[{tile}]"#);
        let options = Options::default();
        let levels = load(&scratch("old_files", "rules.ldtk", project(&layer)), None).unwrap();
        let found = Ground::of(&levels.maps[0], &options, &mut Flags::default());
        found.map(|ground| {
            let corners = ground.outlines.iter().flat_map(|outline| &outline.points);
            corners.min().map(|p| (p.0 >> 16, p.1 >> 16)).unwrap_or_default()
        })
    };
    assert_eq!(tile(24, 8).unwrap(), (24, 8));
    assert_eq!(tile(-8, 16).unwrap(), (-8, 16));
    assert_eq!(tile(60, 20).unwrap(), (60, 20));
    // Nothing of it is in the level.
    for (x, y) in [(-16, 0), (64, 0), (0, 32)] {
        let levels = tile(x, y).unwrap();
        assert_eq!(levels, (0, 0), "{x} {y}");
    }
}

/// Old versions of Tiled had no types, and texts of several lines are the content of the element.
#[test]
fn truth_with_blanks() {
    let walls = |inner: &str| {
        let tile = format!("<tile id=\"0\"><properties><property name=\"solid\"{inner}</properties></tile>");
        rows(&["##"]).replace(r#"<tile id="0" type="Solid"/>"#, &tile).replace(r#"name="World""#, r#"name="Walls""#)
    };
    let tiles = |inner: &str| {
        let applied = ground("blanks.tmx", &walls(inner)).applied;
        applied.into_iter().map(|applied| applied.what).collect::<Vec<_>>()
    };
    for inner in [
        ">true\n</property>",
        ">\n  True\n </property>",
        " value=\" true \"/>",
        " value=\"true&#10;\"/>",
        " type=\"bool\">\n true\n</property>",
        " value=\" 1 \"/>",
    ] {
        assert_eq!(tiles(inner), ["property solid is full"], "{inner}");
    }
    // A tile that denies it is not solid because of its layer.
    for inner in
        [">false\n</property>", " value=\" False \"/>", " value=\" 0\"/>", " type=\"bool\">\n false\n</property>"]
    {
        assert!(refused("denied.tmx", &walls(inner)).contains("nothing is solid"), "{inner}");
    }
}

/// Before Tiled 1.9, a project named a file of object types. Their values are not in its maps.
#[test]
fn object_types_of_a_project() {
    let home = folder("old_files").join("types");
    std::fs::create_dir_all(&home).unwrap();
    let project =
        |file: &str| std::fs::write(home.join("a.tiled-project"), format!(r#"{{"objectTypesFile":"{file}"}}"#));
    let layer = r#"<objectgroup name="G"><object id="7" type="Bat" x="0" y="0" width="8" height="8"/></objectgroup>"#;
    let tiles = r#"<tile id="0" type="Brick"/>"#;
    let map = layered(&[("Main", "0,0,0,0,0,0,0,0,1,1,1,1")], tiles, layer);
    std::fs::write(home.join("a.tmx"), map).unwrap();
    let xml = r#"<objecttypes><objecttype name="Brick"><property name="solid" type="bool" default="true"/></objecttype>
        <objecttype name="Bat"><property name="hp" type="int" default="3"/><property name="cry" default="eek"/></objecttype></objecttypes>"#;
    std::fs::write(home.join("types.xml"), xml).unwrap();
    let json = r#"[{"name":"Brick","properties":[{"name":"solid","type":"bool","value":true}]},
        {"name":"Bat","properties":[{"name":"hp","type":"int","value":3},{"name":"cry","type":"string","value":"eek"}]}]"#;
    std::fs::write(home.join("types.json"), json).unwrap();
    for file in ["types.xml", "types.json"] {
        project(file).unwrap();
        let ran = run("bake", home.join("a.tmx"), "--json");
        let level: serde_json::Value = serde_json::from_str(ran.last()).unwrap();
        assert_eq!((&level["solid"], &level["notes"]), (&4.into(), &serde_json::json!([])), "{level}");
        assert_eq!(level["objects"][0]["properties"], serde_json::json!({"cry": ["eek"], "hp": [3]}));
    }
    std::fs::write(home.join("broken.xml"), "<objecttypes><objecttype").unwrap();
    for (file, why) in [("broken.xml", "the file ends within a tag"), ("gone.xml", "cannot read")] {
        project(file).unwrap();
        let ran = run("bake", home.join("a.tmx"), "--json --solid Brick");
        assert!(ran.status == 0 && ran.err.contains(file) && ran.err.contains(why), "{ran:?}");
    }
}
