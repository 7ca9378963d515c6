//! The results for objects of a map: kinds by name, positions by offsets and rotations.

use tilesat_tools::bake::{Settings, bake};
use tilesat_tools::read::load;
use tilesat_tools::rules::flags::Flags;
use tilesat_tools::rules::ground::Ground;
use tilesat_tools::rules::kind::Kind;
use tilesat_tools::rules::options::Options;

use crate::support::{objects, run, scratch};

/// The solid parts of a map. There is a solid tile somewhere.
fn drawing(name: &str, text: &str) -> Ground {
    let text = text.replacen(">0</data>", ">1</data>", 1);
    let levels = load(&scratch("objects", &format!("{name}.tmx"), text), None).unwrap();
    Ground::of(&levels.maps[0], &Options::default(), &mut Flags::default()).unwrap()
}

/// The points of the only outline in whole pixels.
fn pixels(name: &str, text: &str) -> Vec<(i64, i64)> {
    let drawing = drawing(name, text);
    let [outline] = &drawing.outlines[..] else { panic!("{drawing:?}") };
    assert!(outline.rounding.iter().all(|&off| off == 0), "{outline:?}");
    outline.points.iter().map(|&(x, y)| (x >> 16, y >> 16)).collect()
}

#[test]
fn turned_and_moved() {
    let turned = |degrees: &str| {
        let list = format!(r#"<object id="1" x="100" y="50" width="20" height="8" rotation="{degrees}"/>"#);
        pixels("turned", &objects(&list))
    };
    let plain = [(100, 50), (120, 50), (120, 58), (100, 58)];
    let quarter = [(100, 50), (100, 70), (92, 70), (92, 50)];
    let half = [(100, 50), (80, 50), (80, 42), (100, 42)];
    let back = [(100, 50), (100, 30), (108, 30), (108, 50)];
    let cases = [
        ("0", plain),
        ("360", plain),
        ("90.000", quarter),
        ("-270", quarter),
        ("180", half),
        ("-180", half),
        ("270", back),
        ("-90", back),
    ];
    for (degrees, expected) in cases {
        assert_eq!(turned(degrees), expected, "{degrees}");
    }
    let map = objects(r#"<object id="1" x="0.5" y="-3"><polygon points="0.5,0 8,4 -2,9"/></object>"#);
    let moved = map
        .replace(
            "<objectgroup id=\"2\"",
            "<group offsetx=\"10\" offsety=\"-20\"><group offsety=\"5\"><objectgroup id=\"2\" offsetx=\"-1\"",
        )
        .replace("</objectgroup>", "</objectgroup></group></group>");
    assert_eq!(pixels("moved", &moved.replace("x=\"0.5\"", "x=\"-0.5\"")), [(9, -18), (16, -14), (6, -9)]);
    // Any other rotation is rounded, and the size of the object stays.
    let list = r#"<object id="1" x="100" y="50" width="20" height="8" rotation="30"/>"#;
    let outline = &drawing("askew", &objects(list)).outlines[0];
    assert!(outline.rounding[0] == 0 && outline.rounding[1] > 0);
    for ((a, b), length) in outline.edges().zip([20, 8, 20, 8]) {
        let (x, y) = (b.0 - a.0, b.1 - a.1);
        assert!(((x * x + y * y).isqrt() - (length << 16)).abs() <= 2, "{a:?} {b:?}");
    }
}

#[test]
fn names_of_objects() {
    let kind = |what: &str, layer: &str, shape: &str| {
        let (attributes, properties) = what.split_once('|').unwrap_or((what, ""));
        let list = format!(
            r#"<object id="1" width="9" height="9" {attributes}><properties>{properties}</properties>{shape}</object>"#
        );
        let map = objects(&list).replace("name=\"L\" class=\"Solid\"", &format!("name=\"L\" class=\"{layer}\""));
        drawing("names", &map).outlines.first().map(|outline| (outline.kind, outline.closed, outline.flags.clone()))
    };
    let (polygon, chain) = (r#"<polygon points="0,0 9,0 0,9"/>"#, r#"<polyline points="0,0 9,0 0,9"/>"#);
    let plain = |kind, closed| Some((kind, closed, Vec::<String>::new()));
    let yes = |name: &str| format!("|<property name=\"{name}\" type=\"bool\" value=\"true\"/>");
    // By form, if only the layer makes it solid. Not at all if nothing does.
    for layer in ["Solid", "collisions", "Solid Objects", "colliderLayer"] {
        assert_eq!(kind("", layer, polygon), plain(Kind::Solid, true));
        assert_eq!(kind("", layer, ""), plain(Kind::Solid, true));
        assert_eq!(kind("", layer, chain), plain(Kind::Wall, false));
        assert_eq!(kind("", layer, r#"<polyline points="0,0 9,0 0,9 0,0"/>"#), plain(Kind::Wall, true));
    }
    assert_eq!(kind("", "", polygon), None);
    assert_eq!(kind("", "Not Solid", polygon), None);
    // By class. The object's class takes precedence over the layer's.
    assert_eq!(kind(r#"class="collision""#, "", polygon), plain(Kind::Solid, true));
    assert_eq!(kind(r#"type="HOLE""#, "", polygon), None);
    assert_eq!(kind(r#"type="one-way""#, "Wall", chain), plain(Kind::OneWay, false));
    assert_eq!(kind("", "One_Way", polygon), plain(Kind::OneWay, false));
    assert_eq!(kind(&yes("Wall"), "", polygon), plain(Kind::Solid, true));
    assert_eq!(kind(r#"|<property name="Kind" value="hole"/>"#, "Solid", polygon), plain(Kind::Hole, true));
    // Not ours, unless something else decides. Then the class is a flag.
    assert_eq!(kind(r#"type="Spawn""#, "", polygon), None);
    assert_eq!(kind("", "Spawns", polygon), None);
    assert_eq!(kind(r#"type="Ice""#, "Solid", polygon), Some((Kind::Solid, true, vec!["Ice".into()])));
    let ice = yes("Ice") + &yes("ice")[1..] + &yes("Solid")[1..] + &yes("A &amp; B&#33;")[1..];
    assert_eq!(kind(&ice, "", chain), Some((Kind::Wall, false, vec!["Ice".into(), "A & B!".into()])));
    // A false property means nothing, and neither does a nested one.
    assert_eq!(kind(&yes("Hole").replace("true", "false"), "Solid", polygon), plain(Kind::Solid, true));
    let inner =
        r#"|<property name="c" type="class"><properties><property name="kind" value="hole"/></properties></property>"#;
    assert_eq!(kind(inner, "Solid", polygon), plain(Kind::Solid, true));
}

/// The collision shapes of tiles in a tileset are not objects of the level.
#[test]
fn shapes_of_tiles_are_not_the_level() {
    let shape = r#"<tile id="3"><objectgroup><object id="1" width="9" height="9"/></objectgroup></tile></tileset>"#;
    let map = objects("").replace("</tileset>", shape);
    assert!(drawing("tiles", &map).outlines.is_empty());
    // A comment is none, either.
    let map = objects(r#"<!-- <object id="1" width="9" height="9"/> --><object id="2" width="9" height="9"/>"#);
    assert_eq!(drawing("comment", &map).outlines.len(), 1);
}

/// What is not solid is for the game: class, name and area.
#[test]
fn objects_for_the_game() {
    let list = r#"<object id="1" name="spawn" type="Spawn" x="20" y="30"><point/></object>
        <object id="2" name="first lift" class="Lift" x="48" y="64.5" width="32" height="8"/>
        <object id="3" class="Enemy" x="10" y="60" width="4" height="8" rotation="90"/>
        <object id="4" name="wall" class="Solid" x="1" y="2" width="3" height="4"/>
        <object id="5" name="spawn" class="Spawn" x="9000" y="0"><point/></object>"#;
    let text = objects(list).replacen(">0</data>", ">1</data>", 1).replace("name=\"L\" class=\"Solid\"", "name=\"L\"");
    let levels = load(&scratch("objects", "game.tmx", text), None).unwrap();
    let source = bake(&levels.maps, &Settings::default()).unwrap().source();
    let unit = 1 << 16;
    let area = |x: i32, y: i32, right: i32, bottom: i32| format!("area({x}, {y}, {right}, {bottom})");
    let lift = area(48 * unit, 64 * unit + unit / 2, 80 * unit, 72 * unit + unit / 2);
    let spawn = area(20 * unit, 30 * unit, 20 * unit, 30 * unit);
    for line in [
        format!(
            "    Object {{ id: 1, class: \"Spawn\", name: \"spawn\", area: {spawn}, points: &[], properties: &[] }},"
        ),
        format!(
            "    Object {{ id: 2, class: \"Lift\", name: \"first lift\", area: {lift}, points: &[], properties: &[] }},"
        ),
        // A quarter turn around its corner.
        format!(
            "    Object {{ id: 3, class: \"Enemy\", name: \"\", area: {}, points: &[], properties: &[] }},",
            area(2 * unit, 60 * unit, 10 * unit, 64 * unit)
        ),
        format!("pub const OBJECT_SPAWN: ::tilesat::Aabb = {spawn};"),
        format!("pub const OBJECT_FIRST_LIFT: ::tilesat::Aabb = {lift};"),
    ] {
        assert!(source.lines().any(|known| known == line), "{line}\n{source}");
    }
    // Neither what is solid nor what lies beyond the domain.
    assert_eq!(source.matches("    Object {").count(), 3, "{source}");
}

/// The way of a lift and its speed, a list, and what no list of values can hold.
#[test]
fn properties_and_points() {
    let list = r#"<object id="1" name="way" x="8" y="6"><polyline points="0,0 0,-4.5 3,-4.5"/></object>
        <object id="2" class="Lift" x="48" y="64" width="32" height="8"><properties>
        <property name="speed" type="float" value="0.1"/><property name="far" type="int" value="40000"/>
        <property name="loops" type="bool" value="false"/><property name="say &quot;" value="a\b"/>
        <property name="next" type="object" value="1"/></properties></object>"#;
    let text = objects(list).replacen(">0</data>", ">1</data>", 1).replace("name=\"L\" class=\"Solid\"", "name=\"L\"");
    let levels = load(&scratch("objects", "values.tmx", text), None).unwrap();
    let bundle = bake(&levels.maps, &Settings::default()).unwrap();
    let source = bundle.source();
    let point = |x: i32, y: i32| format!("::tilesat::Vec2::from_raw({}, {})", x << 15, y << 15);
    let way = format!("points: &[{}, {}, {}], properties: &[]", point(16, 12), point(16, 3), point(22, 3));
    // The nearest number of 16.16 is 6554 / 65536. 40000 is beyond them.
    // What it refers to is in the output.
    let values = r#"points: &[], properties: &[("speed", Value::Number(::tilesat::Fx::lit("0.1"))), ("far", Value::Text("40000")), ("loops", Value::Bool(false)), ("say \"", Value::Text("a\\b")), ("next", Value::Object(1))]"#;
    for part in [&way, values] {
        assert!(source.contains(part), "{part}\n{source}");
    }
    assert!(bundle.levels[0].unused().is_empty());
}

/// Fields of an entity are values for the game.
#[test]
fn fields_of_entities() {
    let entity = r#"{"__identifier":"Mob","__pivot":[0,0],"__tags":["Angry"],"px":[32,16],"width":16,"height":16,
        "fieldInstances":[{"__identifier":"Ready","__type":"Bool","__value":true},
        {"__identifier":"kind","__type":"LocalEnum.Kind","__value":"slow"},
        {"__identifier":"loot","__type":"Array<Int>","__value":[3,-4]},
        {"__identifier":"none","__type":"Int","__value":null},
        {"__identifier":"way","__type":"Array<Point>","__value":[{"cx":1,"cy":0},{"cx":-1,"cy":2}]},
        {"__identifier":"home","__type":"Point","__value":{"cx":0,"cy":0}},
        {"__identifier":"door","__type":"EntityRef","__value":{"entityIid":"x"}}]}"#;
    let text = format!(
        r#"{{"__header__":{{"app":"LDtk"}},"worldLayout":"Free","defs":{{"layers":[{{"uid":2,"intGridValues":[{{"value":1,"identifier":"Full"}}]}}]}},"levels":[{{"identifier":"A","pxWid":32,"pxHei":16,"layerInstances":[
        {{"__type":"Entities","__identifier":"E","__cWid":2,"__cHei":1,"__gridSize":16,"entityInstances":[{entity}]}},
        {{"__type":"IntGrid","__identifier":"G","__cWid":2,"__cHei":1,"__gridSize":16,"layerDefUid":2,"intGridCsv":[1,0]}}]}}]}}"#
    );
    let levels = load(&scratch("objects", "fields.ldtk", text), None).unwrap();
    let bundle = bake(&levels.maps, &Settings::default()).unwrap();
    let source = bundle.source();
    let point = |x: i32, y: i32| format!("::tilesat::Vec2::from_raw({}, {})", x << 16, y << 16);
    let line = format!(
        r#"points: &[{}, {}], properties: &[("Angry", Value::Bool(true)), ("Ready", Value::Bool(true)), ("kind", Value::Text("slow")), ("loot", Value::Number(::tilesat::Fx::lit("3"))), ("loot", Value::Number(::tilesat::Fx::lit("-4"))), ("way", Value::Point({})), ("way", Value::Point({})), ("home", Value::Point({}))]"#,
        point(24, 8),
        point(-8, 40),
        point(24, 8),
        point(-8, 40),
        point(8, 8)
    );
    assert!(source.contains(&line), "{line}\n{source}");
    let unused = bundle.levels[0].unused();
    let why = "it refers to an entity that is in no level of the input";
    assert_eq!(unused, [format!("property 'door' of object 1 'Mob' of layer 'E': {why}")]);
}

/// A slip of the pen makes a flag of a floor: it is said.
#[test]
fn names_that_are_nearly_a_rule() {
    let doubts = |class: &str, flags: &[&str]| {
        let list = format!(r#"<object id="1" class="{class}" x="1" y="2" width="3" height="4"/>"#);
        let text =
            objects(&list).replacen(">0</data>", ">1</data>", 1).replace("name=\"L\" class=\"Solid\"", "name=\"L\"");
        let levels = load(&scratch("objects", "doubts.tmx", text), None).unwrap();
        let options = Options { flags: flags.iter().map(|&flag| flag.to_owned()).collect(), ..Options::default() };
        Ground::of(&levels.maps[0], &options, &mut Flags::default()).unwrap().doubts
    };
    assert!(doubts("Sollid", &[]).iter().any(|doubt| doubt.who.contains("Sollid") && doubt.what.contains("'solid'")));
    assert!(doubts("Enemy", &[]).is_empty() && doubts("Solid", &[]).is_empty());
}

/// A hidden object is solid, as a hidden layer is, and the report says so.
#[test]
fn hidden_objects() {
    let list = r#"<object id="1" x="1" y="1" width="5" height="5" visible="0"/>
        <object id="2" name="hut" x="9" y="1" width="5" height="5" visible="0"/>
        <object id="3" x="20" y="1" width="5" height="5"/>"#;
    let note = "2 objects of layer 'L' are hidden, and solid all the same: object 1, object 2 'hut'";
    let notes = |name: &str, text: &str| load(&scratch("objects", name, text), None).unwrap();
    for text in [objects(list), objects(list).replace(" class=\"Solid\">", " class=\"Solid\" visible=\"1\">")] {
        let levels = notes("hidden.tmx", &text);
        let bundle = bake(&levels.maps, &Settings::default()).unwrap();
        let notes = &bundle.levels[0].ground.notes;
        assert!(notes.iter().any(|line| line.starts_with(note)), "{notes:?}");
    }
    let open = objects(&list.replace(" visible=\"0\"", ""));
    let levels = notes("shown.tmx", &open);
    assert_eq!(bake(&levels.maps, &Settings::default()).unwrap().levels[0].ground.notes, [""; 0]);
}

/// Authors mark one barrier in two ways: a class for the editor, a property for the engine.
#[test]
fn solid_and_wall_are_synonyms() {
    let wall = |property: &str, form: &str| {
        let marks = format!(r#"<properties><property name="{property}" type="bool" value="true"/></properties>"#);
        let text = objects(&format!(r#"<object id="1" type="Wall" x="16" y="16" {form}{marks}</object>"#));
        drawing("synonyms", &text.replace("name=\"L\" class=\"Solid\"", "name=\"L\"")).outlines
    };
    for property in ["solid", "collides", "Collidable"] {
        let [outline] = &wall(property, r#"width="8" height="8">"#)[..] else { panic!("{property}") };
        assert_eq!((outline.kind, outline.closed, &outline.flags[..]), (Kind::Solid, true, &[][..]), "{property}");
        let [outline] = &wall(property, r#"><polyline points="0,0 9,9"/>"#)[..] else { panic!("{property}") };
        assert_eq!((outline.kind, outline.closed), (Kind::Wall, false), "{property}");
    }
    let hole = r#"<object id="1" type="Hole" width="8" height="8"><properties><property name="solid" type="bool" value="true"/></properties></object>"#;
    let levels = load(&scratch("objects", "hole.tmx", objects(hole)), None).unwrap();
    let why = Ground::of(&levels.maps[0], &Options::default(), &mut Flags::default()).unwrap_err().to_string();
    let fix = "object 1 is both solid and hole: remove its class 'Hole' or its property 'solid'";
    assert!(why.contains(fix), "{why}");
}

/// Some engines read properties only, so their authors write the class or the name there.
#[test]
fn properties_that_name_objects() {
    let solid = |properties: &str, options: &str| {
        let list = format!(
            r#"<object id="1" x="0" y="0" width="16" height="16"><properties>{properties}</properties></object>"#
        );
        let text = objects(&list).replace(r#"class="Solid""#, "");
        let ran = run("bake", scratch("objects", "named.tmx", text), &format!("--json {options}"));
        if ran.status == 0 { ran.out } else { ran.err }
    };
    let property = |name: &str, value: &str| format!(r#"<property name="{name}" value="{value}"/>"#);
    for (name, value) in [("Name", "Solid"), ("name", "wall"), ("type", "Collision"), ("class", "solids")] {
        let out = solid(&property(name, value), "");
        assert!(out.contains(r#""segments":4"#) && out.contains(r#""rule":"a""#), "{name} {value}: {out}");
    }
    assert!(solid(&property("type", "OneWay"), "").contains(r#""segments":1"#));
    for (name, value) in [("name", "hole"), ("type", "Bush"), ("loot", "solid")] {
        assert!(solid(&property(name, value), "").contains("nothing is solid"), "{name} {value}");
    }
    // An option names the value, also of other properties.
    for (name, value) in [("Name", "Bush"), ("material", "rock")] {
        let out = solid(&property(name, value), &format!("--solid {name}:{value}"));
        assert!(out.contains(r#""segments":4"#), "{name} {value}: {out}");
    }
    assert!(solid(&property("Name", "Solid"), "--empty name:solid").contains("nothing is solid"));
}
