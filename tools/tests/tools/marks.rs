//! Marks of tiles, layers and objects: how they go with drawn shapes, and what denies them.

use crate::support::{map, objects, rows, run, scratch};

fn baked(name: &str, text: &str) -> serde_json::Value {
    let ran = run("bake", scratch("marks", name, text), "--json");
    assert_eq!(ran.status, 0, "{ran:?}");
    serde_json::from_str(&ran.out).unwrap()
}

/// A property that is true or false.
fn property(name: &str, value: bool) -> String {
    format!(r#"<properties><property name="{name}" type="bool" value="{value}"/></properties>"#)
}

const RAMP: &str =
    r#"<objectgroup><object id="1" x="0" y="0"><polygon points="16,0 16,16 0,16"/></object></objectgroup>"#;

/// A mark says that a tile is solid. Its drawn shape says where.
#[test]
fn a_marked_tile_has_its_drawn_shape() {
    for own in [r#"class="Solid">"#.to_owned(), format!(">{}", property("collides", true))] {
        let text =
            rows(&["#"]).replace(r#"<tile id="0" type="Solid"/>"#, &format!(r#"<tile id="0" {own}{RAMP}</tile>"#));
        assert_eq!(baked("ramp.tmx", &text)["shapes"]["slope-bottom-right"], 1, "{own}");
    }
    // A sensor has no shape, and a property names one.
    let sensor = RAMP.replace(r#"y="0">"#, &format!(r#"y="0">{}"#, property("sensor", true)));
    let text = rows(&["#"]).replace(r#"type="Solid"/>"#, &format!(r#"type="Solid">{sensor}</tile>"#));
    assert_eq!(baked("sensor.tmx", &text)["shapes"]["full"], 1);
    // As the rules say, a layer of collisions makes it full, too.
    let text = text.replace(r#"type="Solid">"#, ">").replace(r#"name="World""#, r#"name="Collision""#);
    assert_eq!(baked("sensor_only.tmx", &text)["shapes"]["full"], 1);
    assert!(run("help", "rules", "").out.contains("A tile with only sensors counts as one without shapes"));
    let named = r#"type="Solid"><properties><property name="shape" value="half-top"/></properties>"#;
    let text = rows(&["#"]).replace(r#"type="Solid"/>"#, &format!("{named}{RAMP}</tile>"));
    assert_eq!(baked("named.tmx", &text)["shapes"]["half-top"], 1);
}

/// A tree that is larger than a cell has a trunk.
#[test]
fn a_large_marked_tile_has_its_drawn_shape() {
    let tree = r#"<tileset firstgid="1" name="t" tilewidth="32" tileheight="48" tilecount="4" columns="4">"#;
    let trunk = r#"<objectgroup><object id="1" x="12" y="36" width="8" height="12"/></objectgroup>"#;
    let text = map(2, 3, "0,0,0,0,1,0", "");
    let from = text.find("<tileset").unwrap();
    let to = text.find("</tileset>").unwrap();
    let text =
        format!("{}{tree}<tile id=\"0\">{}{trunk}</tile>{}", &text[..from], property("collides", true), &text[to..]);
    let found = baked("tree.tmx", &text);
    assert!(found["solid"] == 0 && found["segments"] == 4, "{found}");
}

/// What its author denies is not solid because of a shape, the name of a layer or a guess.
#[test]
fn what_is_denied_is_not_solid() {
    for name in ["solid", "collides", "Collidable"] {
        let own = format!("<tile id=\"2\">{}{RAMP}</tile>", property(name, false));
        let text = rows(&["#."]).replace(r#"<tile id="2" type="Kill"/>"#, &own).replace("1,0", "1,3");
        assert_eq!(baked("tile.tmx", &text)["solid"], 1, "{name}");
        assert_eq!(baked("layer.tmx", &text.replace("World", "Collision"))["solid"], 1, "{name}");
        // The property of a layer counts more than the marks of its tiles.
        let text = rows(&["#"]).replace("World", "Collision");
        let both = |denied: &str| {
            let layer = format!(
                r#"<layer id="3" name="Collision" width="1" height="1">{denied}<data encoding="csv">1</data></layer><objectgroup"#
            );
            baked("denied.tmx", &text.replace("<objectgroup", &layer))
        };
        let found = both(&property(name, false));
        let note = format!("layer 'Collision' is not solid, because its property '{name}' is false");
        assert!(found["rules"][0]["tiles"] == 1 && found["notes"].to_string().contains(&note), "{found}");
        assert_eq!(both("")["rules"][0]["tiles"], 2);
    }
    // The refusal of a level says it, too.
    let denied = format!(r#"height="1">{}<data"#, property("solid", false));
    let text = map(1, 1, "4", "").replace("World", "Collision").replace(r#"height="1"><data"#, &denied);
    let ran = run("bake", scratch("marks", "all.tmx", text), "--json");
    assert!(ran.status == 2 && ran.err.contains("because its property 'solid' is false"), "{ran:?}");
    // A mark that is denied by another one: the sensor.
    let own = format!(r#"type="Solid">{}</tile>"#, property("sensor", true));
    let text = rows(&["#="]).replace(r#"type="Solid"/>"#, &own);
    assert_eq!(baked("marked.tmx", &text)["solid"], 0);
}

/// A wall is solid within if it has an inside, however it is named.
#[test]
fn closed_walls_are_solid() {
    let segments = |text: &str| baked("wall.tmx", text)["segments"].clone();
    let object = |own: &str| format!(r#"<object id="1" x="0" y="0" {own} width="16" height="16"/>"#);
    let plain = objects(&object(r#"class="Wall""#)).replace(r#"class="Solid""#, "");
    assert_eq!(segments(&plain), 4);
    assert_eq!(segments(&objects(&object("")).replace(r#"class="Solid""#, r#"class="Walls""#)), 4);
    assert_eq!(segments(&objects(&object(r#"name="wall""#)).replace(r#"class="Solid""#, "")), 4);
    let line = r#"<object id="1" class="Solid" x="0" y="0"><polyline points="0,0 16,0"/></object>"#;
    assert_eq!(segments(&objects(line)), 2);
}

/// A hole in nothing is for the game.
#[test]
fn holes_without_a_solid() {
    let solid = r#"<object id="1" x="0" y="0" width="64" height="64"/>"#;
    let hole = |x: u32| format!(r#"<object id="2" class="Hole" x="{x}" y="16" width="16" height="16"/>"#);
    let text = |x: u32| objects(&(solid.to_owned() + &hole(x)));
    assert_eq!(baked("hole.tmx", &text(16))["segments"], 8);
    let found = baked("stray.tmx", &text(96));
    assert!(found["segments"] == 4 && found["objects"][0]["class"] == "Hole", "{found}");
    assert!(found["notes"].to_string().contains("it is a hole, and no solid polygon is around it"), "{found}");
}

/// Tags of tiles of `LDtk` that are no marks are in the report, and in the refusal.
#[test]
fn tags_that_no_output_has() {
    let project = |tags: &str| {
        format!(
            r#"{{"defs":{{"layers":[],"tilesets":[{{"uid":9,"identifier":"T","pxWid":64,"pxHei":64,"tileGridSize":16,"enumTags":[{tags}]}}]}},
            "levels":[{{"identifier":"A","pxWid":32,"pxHei":16,"layerInstances":[{{"__type":"Tiles","__identifier":"Deco","__cWid":2,"__cHei":1,"__gridSize":16,
            "__tilesetDefUid":9,"layerDefUid":2,"gridTiles":[{{"px":[0,0],"src":[0,0],"f":0,"t":0}},{{"px":[16,0],"src":[16,0],"f":0,"t":1}}]}}]}}]}}"#
        )
    };
    let tag = |name: &str, id: u32| format!(r#"{{"enumValueId":"{name}","tileIds":[{id}]}}"#);
    let text = project(&[tag("Solid", 0), tag("Spike", 1)].join(","));
    let found = baked("tags.ldtk", &text);
    assert!(
        found["unused"].to_string().contains("tags of tiles of tileset 'T': 'Spike': no output has them"),
        "{found}"
    );
    let ran = run("bake", scratch("marks", "tags.ldtk", text), "--json --flag Spike");
    assert!(ran.out.contains(r#""unused":[]"#) && ran.out.contains(r#""Spike":1"#), "{ran:?}");
    let ran = run("bake", scratch("marks", "tags.ldtk", project(&tag("Spike", 1))), "--json");
    assert!(ran.err.contains("the tag of tiles is 'Spike': add --solid 'Spike'"), "{ran:?}");
}

/// A true field of an entity is a mark, if its name is one.
#[test]
fn fields_of_entities_that_are_marks() {
    let project = |value: bool| {
        format!(
            r#"{{"defs":{{"layers":[]}},"levels":[{{"identifier":"A","pxWid":64,"pxHei":64,"layerInstances":[{{"__type":"Entities","__identifier":"E","__cWid":4,"__cHei":4,"__gridSize":16,
            "entityInstances":[{{"__identifier":"Wall","__pivot":[0,0],"px":[0,0],"width":16,"height":16}},{{"__identifier":"Box","__pivot":[0,0],"px":[32,0],"width":16,"height":16,
            "fieldInstances":[{{"__identifier":"solid","__type":"Bool","__value":{value}}}]}}]}}]}}]}}"#
        )
    };
    assert_eq!(baked("field.ldtk", &project(true))["segments"], 8);
    assert_eq!(baked("field.ldtk", &project(false))["segments"], 4);
}

/// Words of the language are no slips of the pen, and an option settles what is one.
#[test]
fn names_that_are_nearly_words() {
    let text = |class: &str| {
        let list = format!(r#"<object id="1" class="{class}" x="0" y="0" width="8" height="8"/>"#);
        rows(&["#"]).replace("</objectgroup>", &format!("{list}</objectgroup>")).replace(r#"class="Solid""#, "")
    };
    for class in ["Block", "Blocks", "Well", "Home", "Walk"] {
        assert_eq!(baked("near.tmx", &text(class))["warnings"], serde_json::json!([]), "{class}");
    }
    assert!(baked("slip.tmx", &text("Colision"))["warnings"].to_string().contains("close to 'collision'"));
    let ran = run("bake", scratch("marks", "slip.tmx", text("Colision")), "--json --flag Colision");
    assert!(ran.out.contains(r#""warnings":[]"#), "{ran:?}");
}

/// Nor does a guess by the names of tiles or by the shapes of some of them.
#[test]
fn no_guess_makes_a_denied_layer_solid() {
    let refused = |tile: &str, property: &str, name: &str| {
        let old = r#"<tile id="0" type="Solid"/>"#;
        let layer = format!(r#"height="1">{property}<data"#);
        let text = rows(&["#"]).replace(old, tile).replace("World", name).replace(r#"height="1"><data"#, &layer);
        run("bake", scratch("marks", "guess.tmx", text), "--json")
    };
    let mut tiles: Vec<String> = ["Solid", "Collision", "Blocked", "my collision"]
        .map(|class| format!(r#"<tile id="0" class="{class}"/>"#))
        .into();
    for (name, value) in [("solid", true), ("isSolid", true), ("impassable", true), ("walkable", false)] {
        tiles.push(format!(r#"<tile id="0">{}</tile>"#, property(name, value)));
    }
    for tile in tiles {
        assert_eq!(refused(&tile, "", "World").status, 0, "{tile}");
        for name in ["solid", "collides"] {
            let ran = refused(&tile, &property(name, false), "World");
            let why = format!("layer 'World' is not solid, because its property '{name}' is false");
            assert!(ran.status == 2 && ran.err.contains(&why), "{tile} {ran:?}");
        }
        let ran = refused(&tile, &property("solid", false), "Walls");
        assert!(ran.status == 2 && ran.err.contains("its property 'solid' is false; --solid-layer"), "{tile} {ran:?}");
    }
    // Some tiles of platforms have a shape, elsewhere.
    let platforms = |denied: &str| {
        let ramp = format!(r#"<tile id="0">{RAMP}</tile><tile id="3"><properties/></tile>"#);
        let layer = format!(
            r#"<layer name="Platforms" width="4" height="1">{denied}<data encoding="csv">4,4,4,1</data></layer><objectgroup"#
        );
        let text = rows(&["#..."])
            .replace(r#"<tile id="0" type="Solid"/>"#, &ramp)
            .replace("<objectgroup id", &layer.replace("<objectgroup", "<objectgroup id"));
        baked("platforms.tmx", &text)["shapes"].clone()
    };
    assert_eq!(platforms("")["full"], 3);
    assert!(platforms(&property("solid", false))["full"].is_null());
}

/// A property of a group is that of its layers. The nearest one wins.
#[test]
fn groups_deny_as_they_claim() {
    let says = |word: &str| match word {
        "yes" => property("solid", true),
        "no" => property("solid", false),
        _ => String::new(),
    };
    let grouped = |outer: &str, inner: &str, own: &str, layer: &str| {
        let class = if inner == "class" { r#" class="Solid""# } else { "" };
        format!(
            r#"<group name="A">{}<group name="B"{class}>{}{}</group></group><objectgroup id"#,
            says(outer),
            says(inner),
            layer.replacen('>', &format!(">{}", says(own)), 1)
        )
    };
    for (outer, inner, own, name, cell, solid) in [
        ("", "", "", "Collision", 4, 2),
        ("no", "", "", "Collision", 4, 1),
        ("yes", "", "", "Deco", 4, 2),
        ("no", "yes", "", "Deco", 4, 2),
        ("no", "class", "", "Deco", 4, 2),
        ("yes", "no", "", "Deco", 4, 1),
        ("no", "", "yes", "Deco", 4, 2),
        ("", "yes", "no", "Deco", 4, 1),
        ("", "", "", "Deco", 1, 2),
        ("no", "", "", "Deco", 1, 1),
    ] {
        let layer = format!(r#"<layer name="{name}" width="1" height="1"><data encoding="csv">{cell}</data></layer>"#);
        let text = rows(&["#"]).replace("<objectgroup id", &grouped(outer, inner, own, &layer));
        let found = baked("groups.tmx", &text);
        let count: u64 = found["rules"].as_array().unwrap().iter().map(|rule| rule["tiles"].as_u64().unwrap()).sum();
        assert_eq!(count, solid, "{outer} {inner} {own} {name} {cell} {found}");
        let of_group = solid == 1 && own.is_empty();
        let note = "because the property 'solid' of its group";
        assert_eq!(found["notes"].to_string().contains(note), of_group, "{found}");
        let list = r#"<object id="9" x="0" y="0" width="8" height="8"/>"#;
        let layer = format!(r#"<objectgroup name="{name}">{list}</objectgroup>"#);
        let text = rows(&["#"]).replace("<objectgroup id", &grouped(outer, inner, own, &layer));
        let wanted = if solid == 2 && cell == 4 { 4 } else { 0 };
        assert_eq!(baked("objects.tmx", &text)["segments"], wanted, "{outer} {inner} {own} {name}");
    }
    // A marked object is solid all the same.
    let layer =
        r#"<objectgroup name="Deco"><object id="9" class="Solid" x="0" y="0" width="8" height="8"/></objectgroup>"#;
    let text = rows(&["#"]).replace("<objectgroup id", &grouped("no", "", "", layer));
    assert_eq!(baked("marked.tmx", &text)["segments"], 4);
    // A guess does not count, and the refusal says why.
    let layer = r#"<layer name="Walls" width="1" height="1"><data encoding="csv">4</data></layer>"#;
    let text = rows(&["."]).replace("<objectgroup id", &grouped("no", "", "", layer));
    let ran = run("bake", scratch("marks", "guess.tmx", text), "--json");
    let why = "layer 'Walls' is not solid, because the property 'solid' of its group 'A' is false";
    assert!(ran.status == 2 && ran.err.contains(why), "{ran:?}");
}

/// A tile or an object that says both has a warning. The mark counts.
#[test]
fn a_mark_and_its_denial_on_one_element() {
    let no = property("solid", false);
    let tile = rows(&["#"]).replace(r#"type="Solid"/>"#, &format!(r#"type="Solid">{no}</tile>"#));
    let object = format!(r#"<object id="7" class="Wall" x="0" y="0" width="16" height="16">{no}</object>"#);
    let object = objects(&object).replace(r#" class="Solid">"#, ">");
    let named = objects(&format!(r#"<object id="7" name="Wall" x="0" y="0" width="16" height="16">{no}</object>"#));
    for (file, text, who, mark) in [
        ("both_tile.tmx", tile, "tile 0 of tileset 't'", "class 'Solid'"),
        ("both_object.tmx", object, "object 7 of layer 'L'", "class 'Wall'"),
        ("both_name.tmx", named, "object 7 'Wall' of layer 'L'", "name 'Wall'"),
    ] {
        let line = format!("{who}: its {mark} says solid, and counts; its property 'solid' is false");
        let level = baked(file, &text);
        assert!(level["solid"] == 1 || level["segments"] == 4, "{level}");
        let warnings = level["warnings"].as_array().unwrap();
        assert!(warnings.len() == 1 && warnings[0].as_str().unwrap().starts_with(&line), "{level}");
        let ran = run("lint", scratch("marks", file, text), "");
        assert!(ran.out.contains(&format!("warning doubtful at (0, 0): {line}")), "{ran:?}");
    }
    // One way is not quite solid.
    let one_way = rows(&["#=", "#="]).replace(r#"type="OneWay"/>"#, &format!(r#"type="OneWay">{no}</tile>"#));
    let level = baked("one_way.tmx", &one_way);
    assert!(level["one_way"] == 2 && level["warnings"] == serde_json::json!([]), "{level}");
}

/// What an object itself denies counts more than its template and its tile.
#[test]
fn an_object_denies_its_template_and_its_tile() {
    let template = r#"<template><object class="Solid" width="16" height="16"/></template>"#;
    let _ = scratch("marks", "box.tx", template);
    let (no, yes) = (property("solid", false), property("solid", true));
    let object =
        |id: u32, of: &str, x: u32, own: &str| format!(r#"<object id="{id}" {of} x="{x}" y="32">{own}</object>"#);
    let (of_template, of_tile) = (r#"template="box.tx""#, r#"gid="1" width="16" height="16""#);
    let all = [
        object(1, of_template, 0, ""),
        object(2, of_template, 32, &no),
        object(3, of_tile, 64, ""),
        object(4, of_tile, 96, &no),
        // Its own class is as near as its property.
        object(5, &format!(r#"{of_template} class="Wall""#), 128, &no),
        object(6, of_template, 160, &yes),
    ];
    let text = objects(&all.concat()).replace(r#" class="Solid">"#, ">");
    let level = baked("denied_template.tmx", &text);
    let ignored: Vec<&str> = level["ignored"].as_array().unwrap().iter().filter_map(|line| line.as_str()).collect();
    let denied = [2, 4].map(|id| format!("object {id} of layer 'L': its property 'solid' is false"));
    assert!(level["segments"] == 16 && ignored == denied, "{level}");
    let warnings = level["warnings"].as_array().unwrap();
    assert!(warnings.len() == 1 && warnings[0].as_str().unwrap().starts_with("object 5 "), "{level}");
}
