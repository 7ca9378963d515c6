//! The report names what a user has set and no output holds, a line for each owner.

use crate::support::{Ran, folder, map, run, scratch};

/// The lines of the report about parts that are in no output.
fn ignored(name: &str, text: &str) -> Vec<String> {
    let file = scratch("unused", name, text);
    let Ran { status, out, err } = run("bake", file, &format!("-o {}", folder("unused").join("out.rs").display()));
    assert!(status == 0 && err.is_empty(), "{out}{err}");
    out.lines().filter_map(|line| line.strip_prefix("ignored ").map(str::to_owned)).collect()
}

fn properties(list: &[(&str, &str, &str)]) -> String {
    let one = |&(name, kind, value): &(&str, &str, &str)| {
        format!(r#"<property name="{name}" type="{kind}" value="{value}"/>"#)
    };
    format!("<properties>{}</properties>", list.iter().map(one).collect::<String>())
}

/// A map with a property wherever Tiled has some. Those that are rules or flags are not ignored.
fn drawn() -> String {
    let solid = |id: u32| {
        let own = properties(&[
            ("hp", "int", "3"),
            ("kind", "string", "solid"),
            ("Ice", "bool", "true"),
            ("x", "bool", "false"),
        ]);
        format!(r#"<object id="{id}" x="{}" y="0" width="8" height="8">{own}</object>"#, id * 16)
    };
    let text = map(3, 1, "1,1,3", &[solid(1), solid(2)].concat());
    let of_map = properties(&[("gravity", "float", "0.5"), ("music", "string", "a.ogg"), ("dark", "bool", "false")]);
    let text = text.replacen("<tileset", &format!("{of_map}<tileset"), 1);
    let of_tile = properties(&[("damage", "int", "2"), ("shape", "string", "full"), ("Hot", "bool", "true")]);
    let text =
        text.replace(r#"<tile id="0" type="Solid"/>"#, &format!(r#"<tile id="0" type="Solid">{of_tile}</tile>"#));
    // A tile that is nowhere in the map.
    let text = text.replace(
        r#"<tile id="1" type="OneWay"/>"#,
        &format!(r#"<tile id="1">{}</tile>"#, properties(&[("q", "int", "1")])),
    );
    let of_layer = properties(&[("friction", "float", "1"), ("solid", "bool", "true")]);
    let text = text.replace("<data", &format!("{of_layer}<data"));
    let group = properties(&[("zone", "string", "cave")]);
    let game = r#"<objectgroup id="9" name="G"><object id="20" x="0" y="0" width="8" height="4" rotation="45"/>
        <object id="21" x="0" y="0" width="8" height="4"><text>Hi</text></object></objectgroup>"#;
    text.replace("</map>", &format!(r#"<group id="8" name="rest">{group}{game}</group></map>"#))
}

#[test]
fn properties_without_an_output_are_named() {
    assert_eq!(
        ignored("drawn.tmx", &drawn()),
        [
            "properties of the map: 'gravity', 'music': no output has them",
            "properties of group 'rest': 'zone': no output has them",
            "properties of tiles of tileset 't': 'damage': no output has them",
            "properties of layer 'World': 'friction': no output has them",
            "properties of solid objects of layer 'L': 'hp' (2 times): no output has them",
            "the text of 1 object of layer 'G': no output has it; give it as a property",
            "the rotation of 1 object of layer 'G': OBJECTS has the box around each; give it as a property",
        ]
    );
}

/// Points and texts of the collision editor, in one line for each kind. Tiles that are nowhere in
/// the map have none.
#[test]
fn points_and_texts_of_the_collision_editor_are_named() {
    let point = |id: u32| format!(r#"<object id="{id}" x="8" y="8"><point/></object>"#);
    let text = |id: u32| format!(r#"<object id="{id}" x="0" y="0" width="8" height="4"><text>Hi</text></object>"#);
    let half = r#"<object id="9" type="Ice" x="0" y="8" width="16" height="8"/>"#;
    let sensor = r#"<object id="7" type="Sensor" x="0" y="8" width="16" height="8"/>"#;
    let group = |drawn: &[&str]| format!(r#"<objectgroup id="2">{}</objectgroup>"#, drawn.concat());
    let tiles = [
        format!(r#"<tile id="0" type="Solid">{}</tile>"#, group(&[&point(1), &text(2)])),
        format!(r#"<tile id="1">{}</tile>"#, group(&[half, sensor, &point(1), &point(2)])),
        format!(r#"<tile id="2">{}</tile>"#, group(&[&point(1)])),
        format!(r#"<tile id="3">{}</tile>"#, group(&[&text(1)])),
    ];
    // Tile 2 is only an object of the game, and tile 3 is nowhere.
    let coin = r#"<objectgroup id="8" name="G"><object id="5" gid="3" x="0" y="16"/></objectgroup></map>"#;
    let level = map(3, 1, "1,2,2", "").replace("</map>", coin);
    let known = r#"<tile id="0" type="Solid"/><tile id="1" type="OneWay"/><tile id="2" type="Kill"/>"#;
    let level = level.replace(known, &tiles.concat());
    let lines = ignored("editor.tmx", &level);
    assert_eq!(
        lines,
        [
            "4 points in the collision editor of tileset 't': no output has them; draw them in an object layer",
            "1 text in the collision editor of tileset 't': no output has it; draw it in an object layer",
            "1 sensor in the collision editor of tileset 't': no output has it; draw it in an object layer",
            "properties and classes of collision shapes of tileset 't': 'Ice': no output has them",
        ]
    );
    let plain = level.replace(r#"type="Ice""#, "").replace(sensor, "");
    let plain = plain.replace(&point(1), "").replace(&point(2), "").replace(&text(2), "");
    assert!(ignored("plain.tmx", &plain).is_empty());
}

/// The same in JSON, and many objects are one line.
#[test]
fn many_objects_are_one_line() {
    let objects: Vec<String> = (1..=3000)
        .map(|id| {
            format!(
                r#"{{"id":{id},"x":{},"y":0,"width":4,"height":4,"properties":[{{"name":"hp","type":"int","value":3}},{{"name":"p{}","type":"string","value":"a"}}]}}"#,
                id % 500 * 16,
                id % 20
            )
        })
        .collect();
    let text = format!(
        r#"{{"orientation":"orthogonal","width":1,"height":1,"tilewidth":16,"tileheight":16,"tilesets":[],
        "properties":[{{"name":"gravity","type":"float","value":0.5}}],
        "layers":[{{"type":"objectgroup","name":"L","class":"Solid","objects":[{}]}}]}}"#,
        objects.join(",")
    );
    let lines = ignored("many.tmj", &text);
    assert_eq!(lines.len(), 2, "{lines:?}");
    assert_eq!(lines[0], "properties of the map: 'gravity': no output has them");
    let start = "properties of solid objects of layer 'L': 'hp' (3000 times), 'p0' (150 times), ";
    assert!(lines[1].starts_with(start) && lines[1].ends_with(" and 9 more: no output has them"), "{}", lines[1]);
}

#[test]
fn fields_of_a_level_are_named() {
    let text = r#"{"jsonVersion":"1.5.3","defs":{"layers":[{"uid":2,"intGridValues":[{"value":1,"identifier":"Full"}]}]},
        "levels":[{"identifier":"One","fieldInstances":[{"__identifier":"biome","__type":"LocalEnum.B","__value":"Snow"},{"__identifier":"none","__type":"Int","__value":null}],
        "layerInstances":[{"__type":"Entities","__identifier":"E","__cWid":2,"__cHei":1,"__gridSize":16,
        "entityInstances":[{"__identifier":"Door","__tags":["Solid"],"__pivot":[0,0],"px":[0,0],"width":16,"height":16,
        "fieldInstances":[{"__identifier":"key","__type":"String","__value":"red"}]}]}]}]}"#;
    assert_eq!(
        ignored("fields.ldtk", text),
        [
            "properties of the level: 'biome': no output has them",
            "properties of solid objects of layer 'E': 'key': no output has them",
        ]
    );
}
