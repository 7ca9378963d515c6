//! What a user of an editor draws without a thought: tiles as objects, references, clicks, levels
//! over each other. Each is in the output, or the report says why it is not.

use std::fs;
use std::path::PathBuf;

use tilesat_tools::read::load;
use tilesat_tools::rooms::{self, Cut, World};
use tilesat_tools::rules::options::Options;

use crate::support::{self, Ran, folder, map, scratch};

/// A map with a solid tile and these objects in a layer that says nothing.
fn plain(list: &str) -> String {
    map(1, 1, "1", list).replace("name=\"L\" class=\"Solid\"", "name=\"L\"")
}

/// The Rust source and the report of a level.
fn baked(file: PathBuf) -> (String, String) {
    let out = folder("drawn").join("out.rs");
    let ran = support::run("bake", file, &format!("-o {}", out.display()));
    assert!(ran.status == 0 && ran.err.is_empty(), "{ran:?}");
    (fs::read_to_string(out).unwrap(), ran.out)
}

/// The only line of an error.
fn refused(command: &str, file: PathBuf, options: &str) -> String {
    let Ran { status, out, err } = support::run(command, file, options);
    assert!(status == 2 && out.is_empty() && err.lines().count() == 1, "{status} {out} {err}");
    err
}

/// A level of an `LDtk` project, of 2 x 2 solid cells, with these entities.
fn level(name: &str, (x, y, depth): (i32, i32, i32), entities: &str) -> String {
    format!(
        r#"{{"identifier":"{name}","worldX":{x},"worldY":{y},"worldDepth":{depth},"pxWid":32,"pxHei":32,"layerInstances":[
        {{"__type":"Entities","__identifier":"E","__cWid":2,"__cHei":2,"__gridSize":16,"entityInstances":[{entities}]}},
        {{"__type":"IntGrid","__identifier":"G","__cWid":2,"__cHei":2,"__gridSize":16,"layerDefUid":2,"intGridCsv":[1,1,1,1]}}]}}"#
    )
}

const DEFS: &str =
    r#""__header__":{"app":"LDtk"},"defs":{"layers":[{"uid":2,"intGridValues":[{"value":1,"identifier":"Full"}]}]}"#;

fn project(levels: &[String]) -> String {
    format!(r#"{{{DEFS},"worldLayout":"Free","levels":[{}]}}"#, levels.join(","))
}

fn world(name: &str, text: String) -> Result<World, String> {
    let levels = load(&scratch("drawn", name, text), None).unwrap();
    rooms::bake(&levels.maps, &Options::default(), &Cut::default()).map_err(|fail| fail.to_string())
}

#[test]
fn only_levels_of_one_depth_are_neighbours() {
    let levels = [level("A", (0, 0, 0), ""), level("B", (32, 0, 1), ""), level("C", (0, 0, 1), "")];
    let made = world("depth.ldtk", project(&levels)).unwrap();
    let room = |name: &str| made.rooms.iter().find(|room| room.name == name).unwrap();
    let solid = |name: &str| room(name).tiles.iter().filter(|tile| **tile != 0).count();
    // Only their own tiles, and 2 x 2 of the neighbour.
    assert_eq!((solid("A"), solid("B"), solid("C")), (4, 8, 8));
    // `next_of` takes the rooms of one depth: they are neighbours in the table.
    let source = made.source();
    let table = "pub const fn near(room: usize) -> core::ops::Range<usize> {\n    match room {\n        0 => 0..1,\n        _ => 1..3,\n    }\n}";
    assert!(source.contains(table), "{source}");
    let one = world("one.ldtk", project(&[level("A", (0, 0, 3), ""), level("B", (32, 0, 3), "")])).unwrap();
    assert!(!one.source().contains("fn near"));
    // Worlds of one project have nothing to do with each other, either.
    let two = [("W", "A", 0), ("V", "B", 0)].map(|(world, name, x)| {
        format!(r#"{{"identifier":"{world}","worldLayout":"Free","levels":[{}]}}"#, level(name, (x, 0, 0), ""))
    });
    let text = format!(r#"{{{DEFS},"worldLayout":null,"levels":[],"worlds":[{}]}}"#, two.join(","));
    let two = world("worlds.ldtk", text).unwrap();
    assert!(two.rooms.iter().all(|room| room.tiles.iter().filter(|tile| **tile != 0).count() == 4));
}

#[test]
fn levels_over_each_other_are_refused() {
    let levels = [level("A", (0, 0, 0), ""), level("B", (16, 16, 0), "")];
    let why = world("over.ldtk", project(&levels)).unwrap_err();
    for part in ["level 'A'", "level 'B'", "1x1 cells", "worldDepth", "--ignore-level"] {
        assert!(why.contains(part), "{part} is not in {why}");
    }
    assert!(world("beside.ldtk", project(&[level("A", (0, 0, 0), ""), level("B", (32, 32, 0), "")])).is_ok());
}

/// As in Tiled, a tile gives its class and properties to its objects, which override them.
#[test]
fn objects_take_over_from_their_tile() {
    let list = r#"<object id="1" gid="1" x="64" y="48" width="16" height="32"/>
        <object id="2" gid="2" x="0" y="48" width="16" height="16"/>
        <object id="3" gid="3" x="0" y="0" width="16" height="16"/>
        <object id="4" gid="3" x="0" y="0" class="Lamp"><properties><property name="hp" type="int" value="9"/></properties></object>"#;
    let tile = r#"<tile id="2" type="Kill"><properties><property name="hp" type="int" value="5"/><property name="hot" type="bool" value="true"/></properties></tile>"#;
    let text = plain(list).replace(r#"<tile id="2" type="Kill"/>"#, tile);
    let (source, _) = baked(scratch("drawn", "tiles.tmx", &text));
    // A tile of a solid class is solid, one of a one-way class holds on its top.
    for part in [
        "    Vec2::from_ints(64, 16),\n    Vec2::from_ints(80, 16),\n    Vec2::from_ints(80, 48),\n    Vec2::from_ints(64, 48),\n];",
        "[Vec2; 2] = [\n    Vec2::from_ints(0, 32),\n    Vec2::from_ints(16, 32),\n];",
        "PathKind::Solid, &POINTS_0",
        "PathKind::OneWay, &POINTS_1",
        r#"class: "Kill", name: "", "#,
        r#"("hp", Value::Number(::tilesat::Fx::lit("5"))), ("hot", Value::Bool(true))"#,
        r#"class: "Lamp", name: "", "#,
        r#"("hp", Value::Number(::tilesat::Fx::lit("9"))), ("hot", Value::Bool(true))"#,
        // Without a size, it is as large as its tile.
        "area(0, -1048576, 1048576, 0)",
    ] {
        assert!(source.contains(part), "{part} is not in {source}");
    }
    assert_eq!(source.matches("    Object {").count(), 2, "{source}");
    // A template has numbers of its own.
    let set = r#"<tileset firstgid="7" source="own.tsx"/>"#;
    scratch(
        "drawn",
        "own.tsx",
        r#"<tileset name="o" tilewidth="8" tileheight="8" tilecount="1" columns="1"><tile id="0" type="Crate"/></tileset>"#,
    );
    scratch("drawn", "own.tx", format!(r#"<template>{set}<object gid="7" width="8" height="8"/></template>"#));
    let (source, _) = baked(scratch("drawn", "own.tmx", plain(r#"<object id="1" template="own.tx" x="5" y="9"/>"#)));
    assert!(source.contains(r#"class: "Crate""#), "{source}");
    let gone = scratch("drawn", "gid.tmx", plain(r#"<object id="6" gid="99" x="5" y="9"/>"#));
    let (_, report) = baked(gone);
    assert!(report.contains("warning object 6 of layer 'L': its tile 98 is not in tileset 't'"), "{report}");
}

#[test]
fn tilesets_align_their_objects() {
    let drawn = |set: &str| {
        let text = plain(r#"<object id="1" gid="3" x="64" y="48" width="16" height="32"/>"#);
        baked(scratch("drawn", "align.tmx", text.replace("<tileset ", &format!("<tileset {set} ")))).0
    };
    for (name, x, y) in [
        ("unspecified", 64, 16),
        ("topleft", 64, 48),
        ("top", 56, 48),
        ("topright", 48, 48),
        ("left", 64, 32),
        ("center", 56, 32),
        ("right", 48, 32),
        ("bottomleft", 64, 16),
        ("bottom", 56, 16),
        ("bottomright", 48, 16),
    ] {
        let source = drawn(&format!(r#"objectalignment="{name}""#));
        let unit = 1 << 16;
        let area = format!("area({}, {}, {}, {})", x * unit, y * unit, (x + 16) * unit, (y + 32) * unit);
        assert!(source.contains(&area), "{name}: {area} is not in {source}");
    }
    let text = plain("").replace("<tileset ", r#"<tileset objectalignment="middle" "#);
    assert!(refused("lint", scratch("drawn", "middle.tmx", text), "").contains("objectalignment 'middle' is unknown"));
}

#[test]
fn objects_beyond_the_domain() {
    let list = r#"<object id="14" name="far" x="9000" y="10" width="30" height="10"/>"#;
    let far = || scratch("drawn", "far.tmx", plain(list));
    let (source, report) = baked(far());
    assert!(!source.contains("Object {"), "{source}");
    let line = report.lines().find(|line| line.contains("object 14")).unwrap();
    assert!(line.starts_with("warning ") && line.contains("(9000, 10)") && line.contains("8192"), "{line}");
    assert!(!report.contains("nothing says"), "{report}");
    let lint = support::run("lint", far(), "");
    assert!(lint.out.contains("warning left-out at (9000, 10): object 14 'far' of layer 'L': "), "{lint:?}");
}

/// A click with the rectangle tool is a rectangle without a size.
#[test]
fn a_click_is_a_point() {
    let (source, report) = baked(scratch("drawn", "click.tmx", plain(r#"<object id="1" name="spawn" x="8" y="40"/>"#)));
    assert!(
        source.contains("pub const OBJECT_SPAWN: ::tilesat::Aabb = area(524288, 2621440, 524288, 2621440);"),
        "{source}"
    );
    assert!(report.contains("object  object 1 'spawn' of layer 'L': it has no size, so it is a point"), "{report}");
}

#[test]
fn references_of_tiled() {
    let text = |kind: &str| {
        let list = format!(
            r#"<object id="7" name="door" x="1" y="2" width="3" height="4"/><object id="8" class="Solid" x="1" y="2" width="3" height="4"/>
        <object id="9" class="Key" x="1" y="2"><properties><property name="opens" type="object" value="7"/>
        <property name="none" type="object" value="0"/><property name="wall" type="object" value="8"/><property name="gone" type="object" value="70"/>
        <property name="cls" type="class" propertytype="Pt"><properties><property name="x" type="int" value="3"/></properties></property>
        <property name="all" type="list"><item type="int" value="1"/></property><property name="odd" type="{kind}" value="1"/></properties></object>"#
        );
        scratch("drawn", "references.tmx", plain(&list))
    };
    let (source, report) = baked(text("matrix"));
    let line = r#"    Object { id: 9, class: "Key", name: "", area: area(65536, 131072, 65536, 131072), points: &[], properties: &[("opens", Value::Object(7))] },"#;
    assert!(source.lines().any(|known| known == line), "{source}");
    assert!(source.contains("pub id: u32,") && source.contains("Object { id: 7, "), "{source}");
    for (name, why) in [
        ("wall", "it refers to object 8, which is not in OBJECTS"),
        ("gone", "it refers to object 70, which is not in OBJECTS"),
        ("cls", "a class: make its members properties of the object"),
        ("all", "a list: make its values properties of the object"),
        ("odd", "its type 'matrix' is unknown"),
    ] {
        let line = format!("ignored property '{name}' of object 9 of layer 'L': {why}");
        assert!(report.lines().any(|known| known == line), "{line} is not in {report}");
    }
    assert!(!report.contains("'none'"), "{report}");
    // The same in JSON.
    let list = r#"[{"id":7,"x":1,"y":2,"width":3,"height":4},{"id":9,"x":1,"y":2,"properties":[
        {"name":"opens","type":"object","value":7},{"name":"cls","type":"class","propertytype":"P","value":{"x":1}}]}]"#;
    let text = format!(
        r#"{{"orientation":"orthogonal","width":1,"height":1,"tilewidth":16,"tileheight":16,"tilesets":[{{"firstgid":1,"name":"t","tilewidth":16,"tileheight":16,"tilecount":4,"columns":4,"tiles":[{{"id":0,"type":"Solid"}}]}}],
        "layers":[{{"type":"tilelayer","name":"W","width":1,"height":1,"data":[1]}},{{"type":"objectgroup","name":"L","objects":{list}}}]}}"#
    );
    let (source, report) = baked(scratch("drawn", "references.tmj", text));
    assert!(source.contains(r#"&[("opens", Value::Object(7))]"#), "{source}");
    assert!(report.contains("property 'cls' of object 9 of layer 'L': a class: "), "{report}");
}

/// Entities have ids that are unique in the project, and points keep the names of their fields.
#[test]
fn references_of_ldtk() {
    let entity = |iid: &str, fields: &str| {
        format!(
            r#"{{"iid":"{iid}","__identifier":"Mob","__pivot":[0,0],"px":[0,0],"width":16,"height":16,"fieldInstances":[{fields}]}}"#
        )
    };
    let refers = |name: &str, iid: &str| {
        format!(r#"{{"__identifier":"{name}","__type":"EntityRef","__value":{{"entityIid":"{iid}","levelIid":"l"}}}}"#)
    };
    let points = r#"{"__identifier":"way","__type":"Array<Point>","__value":[{"cx":1,"cy":0},{"cx":0,"cy":2}]},
        {"__identifier":"home","__type":"Point","__value":{"cx":0,"cy":0}},
        {"__identifier":"face","__type":"Tile","__value":{"tilesetUid":1,"x":0,"y":0,"w":8,"h":8}}"#;
    let first = entity("a", &[refers("target", "b"), refers("lost", "c"), points.to_owned()].join(","));
    let levels = [level("A", (0, 0, 0), &first), level("B", (64, 0, 0), &entity("b", &refers("back", "a")))];
    let (source, report) = baked(scratch("drawn", "references.ldtk", project(&levels)));
    let id = |module: &str| {
        let part = source.split(&format!("pub mod {module} {{")).nth(1).unwrap();
        part.split("Object { id: ").nth(1).unwrap().split(',').next().unwrap().parse::<u32>().unwrap()
    };
    let (a, b) = (id("a"), id("b"));
    assert_ne!(a, b);
    let point = |x: i32, y: i32| format!("::tilesat::Vec2::from_raw({}, {})", x << 16, y << 16);
    let (way, home) = ([point(24, 8), point(8, 40)], point(8, 8));
    for part in [
        format!(r#"("target", Value::Object({b}))"#),
        format!(r#"("back", Value::Object({a}))"#),
        // The first field is the way, for simple use.
        format!("points: &[{}, {}], ", way[0], way[1]),
        format!(
            r#"("way", Value::Point({})), ("way", Value::Point({})), ("home", Value::Point({home}))"#,
            way[0], way[1]
        ),
    ] {
        assert!(source.contains(&part), "{part} is not in {source}");
    }
    let of = format!("of object {a} 'Mob' of layer 'E'");
    for line in [
        format!("ignored property 'lost' {of}: it refers to an entity that is in no level of the input"),
        format!("ignored property 'face' {of}: its type 'Tile' has no value here"),
    ] {
        assert!(report.lines().any(|known| known == line), "{line} is not in {report}");
    }
}

#[test]
fn messages_say_what_helps() {
    let solid = |list: &str| support::objects(list);
    let file = |name: &str, text: &str| scratch("drawn", name, text);
    let bow = r#"<object id="1" x="10" y="10"><polygon points="0,0 10,10 10,0 0,10"/></object>"#;
    let flat = r#"<object id="1" x="10" y="10" width="0" height="10"/>"#;
    for (file, parts) in [
        (file("bow.tmx", &solid(bow)), ["object 1 of layer 'L'", "it crosses itself", "two polygons"]),
        (file("flat.tmx", &solid(flat)), ["object 1 of layer 'L'", "its width is 0", "polyline"]),
        (file("bare.tmj", "{}"), ["not a Tiled map", "orientation", ""]),
        (file("bare.json", "{}"), ["neither a map of Tiled", "nor a project of LDtk", ""]),
        (file("w.world", r#"{"maps":[],"type":"world"}"#), ["a world of Tiled", "without maps", "World Tool"]),
        (
            file("l.ldtkl", r#"{"identifier":"A","layerInstances":[]}"#),
            ["one level of an LDtk project", "give the project", ".ldtk"],
        ),
    ] {
        let why = refused("bake", file, "--json");
        assert!(parts.iter().all(|part| why.contains(part)), "{parts:?} are not in {why}");
    }
}

/// A hidden layer is solid, but its author may not know it.
#[test]
fn layers_that_are_not_where_they_seem() {
    let text = map(1, 1, "1", "").replace("name=\"World\"", "name=\"World\" visible=\"0\"");
    let (_, report) = baked(scratch("drawn", "hidden.tmx", &text));
    assert!(
        report.contains("note    layer 'World' is hidden, and solid all the same; --ignore-layer 'World' skips it"),
        "{report}"
    );
    let text = map(1, 1, "1", r#"<object id="1" x="1" y="2" width="3" height="4"/>"#)
        .replace("<layer ", "<group parallaxx=\"0.5\"><layer ")
        .replace("</layer>", "</layer></group>")
        .replace("class=\"Solid\"", "class=\"Solid\" visible=\"0\"");
    let (_, report) = baked(scratch("drawn", "parallax.tmx", &text));
    let moves = "note    layer 'World' scrolls with a parallax factor, but its solid stays where it is drawn; --ignore-layer 'World' skips it";
    assert!(report.contains(moves) && report.contains("note    layer 'L' is hidden"), "{report}");
    let (_, report) = baked(scratch("drawn", "seen.tmx", map(1, 1, "1", "")));
    assert!(!report.contains("hidden") && !report.contains("parallax"), "{report}");
    let text = project(&[level("A", (0, 0, 0), "").replace("\"IntGrid\",", "\"IntGrid\",\"visible\":false,")]);
    assert!(baked(scratch("drawn", "hidden.ldtk", text)).1.contains("layer 'G' is hidden"));
}

/// Values of a layer whose cells are not those of the solid.
#[test]
fn flags_between_the_cells() {
    let fine = r#"{"__type":"IntGrid","__identifier":"Fine","__cWid":4,"__cHei":4,"__gridSize":8,"layerDefUid":3,"intGridCsv":[1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0]},"#;
    let text =
        project(&[level("A", (0, 0, 0), "").replace("\"layerInstances\":[", &format!("\"layerInstances\":[{fine}"))])
            .replace("\"layers\":[", r#""layers":[{"uid":3,"intGridValues":[{"value":1,"identifier":"Coin"}]},"#);
    let file = || scratch("drawn", "fine.ldtk", &text);
    let (_, report) = baked(file());
    let line = report.lines().find(|line| line.contains("'Fine'")).unwrap();
    assert!(line.starts_with("warning layer 'Fine': its flags are in no output"), "{line}");
    let lint = support::run("lint", file(), "");
    assert!(lint.out.contains("warning doubtful at (0, 0): layer 'Fine': its flags are in no output"), "{lint:?}");
}
