//! What a file says, and no output holds: classes of maps, layers and tilesets, members that a
//! class gives, the texts of `LDtk`'s tiles, and the properties of a world.

use std::fs;
use std::path::PathBuf;

use serde_json::{Value, json};

use crate::support::{folder, layered, map, rows, run, scratch, tilesat};

fn level(file: PathBuf) -> Value {
    let ran = run("bake", file, "--json");
    assert_eq!(ran.status, 0, "{ran:?}");
    serde_json::from_str(ran.out.lines().next().unwrap()).unwrap()
}

fn list(level: &Value, name: &str) -> Vec<String> {
    level[name].as_array().unwrap().iter().map(|line| line.as_str().unwrap().to_owned()).collect()
}

#[test]
fn classes_of_maps_tilesets_layers_and_groups() {
    let text = map(2, 1, "1,1", "")
        .replacen("orientation=", r#"class="Cave" orientation="#, 1)
        .replacen(r#"name="t""#, r#"name="t" class="Dungeon""#, 1)
        .replacen(r#"name="World""#, r#"name="World" class="Main""#, 1)
        .replacen("</map>", r#"<group name="G" class="Far"/><group name="H" class="Walls"/></map>"#, 1);
    let expected = [
        "properties of the map: 'class': no output has them",
        "properties of group 'G': 'class': no output has them",
        "properties of tileset 't': 'class': no output has them",
        "properties of layer 'World': 'class': no output has them",
    ];
    assert_eq!(list(&level(scratch("reported", "classes.tmx", &text)), "unused"), expected);
    let text = json!({"class": "Cave", "orientation": "orthogonal", "width": 1, "height": 1, "tilewidth": 16, "tileheight": 16,
        "layers": [{"type": "tilelayer", "name": "World", "class": "Main", "width": 1, "height": 1, "data": [1]}],
        "tilesets": [{"firstgid": 1, "name": "t", "class": "Dungeon", "tilewidth": 16, "tileheight": 16, "tilecount": 1,
            "columns": 1, "tiles": [{"id": 0, "type": "Solid"}]}]});
    let expected = [expected[0], expected[2], expected[3]];
    assert_eq!(list(&level(scratch("reported", "classes.tmj", text.to_string())), "unused"), expected);
    // A class that decides is not lost.
    let text = rows(&["#"]).replacen(r#"name="World""#, r#"name="World" class="Collision""#, 1);
    assert!(list(&level(scratch("reported", "rule.tmx", &text)), "unused").is_empty());
}

#[test]
fn members_that_a_class_gives() {
    let members = json!([
        {"name": "hp", "type": "int", "value": 3},
        {"name": "form", "type": "class", "propertyType": "Form", "value": {"round": true}},
        {"name": "drops", "type": "list", "value": [1, 2]},
        {"name": "empty", "type": "class", "propertyType": "Form", "value": {}},
        {"name": "owner", "type": "object", "value": 0},
    ]);
    let project =
        json!({"propertyTypes": [{"name": "Enemy", "type": "class", "useAs": ["object"], "members": members}]});
    let home = folder("reported").join("members");
    fs::create_dir_all(&home).unwrap();
    fs::write(home.join("game.tiled-project"), project.to_string()).unwrap();
    let text = map(1, 1, "1", "").replace(
        "</map>",
        r#"<objectgroup name="G"><object id="7" name="bat" type="Enemy" x="0" y="0" width="8" height="8"/></objectgroup></map>"#,
    );
    fs::write(home.join("members.tmx"), text).unwrap();
    let level = level(home.join("members.tmx"));
    assert_eq!(level["objects"][0]["properties"], json!({"hp": [3]}));
    assert_eq!(
        list(&level, "unused"),
        [
            "property 'form' of object 7 'bat' of layer 'G': a class: make its members properties of the object",
            "property 'drops' of object 7 'bat' of layer 'G': a list: make its values properties of the object",
        ]
    );
}

#[test]
fn a_number_without_a_value_is_0() {
    let own = r#"<properties><property name="n" type="int"/><property name="f" type="float" value=""/><property name="b" type="bool"/><property name="s"/></properties>"#;
    let text = map(1, 1, "1", "").replace(
        "</map>",
        &format!(r#"<objectgroup name="G"><object id="7" type="Lift" x="0" y="0" width="8" height="8">{own}</object></objectgroup></map>"#),
    );
    let level = level(scratch("reported", "numbers.tmx", text));
    assert_eq!(level["objects"][0]["properties"], json!({"b": [false], "f": [0], "n": [0], "s": [""]}));
}

#[test]
fn texts_of_tiles_in_ldtk() {
    let text = json!({
        "defs": {"layers": [{"uid": 2}], "tilesets": [{"uid": 1, "identifier": "T", "pxWid": 64, "pxHei": 16, "tileGridSize": 16,
            "enumTags": [{"enumValueId": "Solid", "tileIds": [0]}],
            "customData": [{"tileId": 0, "data": "loud"}, {"tileId": 1, "data": "wet"}, {"tileId": 3, "data": "x"}]}]},
        "levels": [{"identifier": "One", "layerInstances": [{
            "__type": "Tiles", "__identifier": "Main", "__cWid": 2, "__cHei": 1, "__gridSize": 16, "__tilesetDefUid": 1,
            "layerDefUid": 2, "gridTiles": [{"px": [0, 0], "t": 0}, {"px": [16, 0], "t": 1}],
        }]}],
    })
    .to_string();
    let file = scratch("reported", "texts.ldtk", &text);
    assert_eq!(list(&level(file.clone()), "unused"), ["the custom data of 2 tiles of tileset 'T': no output has it"]);
    // An option names a tile by its text.
    let ran =
        tilesat(["bake".into(), file.into_os_string(), "--json".into(), "--solid".into(), "custom data:wet".into()]);
    assert!(ran.status == 0 && ran.out.contains(r#""solid":2"#), "{ran:?}");
}

#[test]
fn properties_of_a_world() {
    let home = folder("reported").join("world");
    fs::create_dir_all(&home).unwrap();
    for name in ["a", "b"] {
        fs::write(home.join(format!("{name}.tmx")), rows(&["##"])).unwrap();
    }
    let world = json!({"type": "world", "maps": [{"fileName": "a.tmx", "x": 0, "y": 0}, {"fileName": "b.tmx", "x": 32, "y": 0}],
        "properties": [{"name": "music", "type": "string", "value": "a.ogg"}]});
    fs::write(home.join("w.world"), world.to_string()).unwrap();
    let ran = run("bake", home.join("w.world"), "--json");
    let levels: Vec<Value> = ran.out.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert_eq!(list(&levels[0], "unused"), ["properties of the world: 'music': no output has them"]);
    assert!(levels.len() == 2 && list(&levels[1], "unused").is_empty());
}

#[test]
fn the_offset_of_collision_shapes() {
    let group = r#"<objectgroup offsetx="4"><object x="0" y="8" width="16" height="8"/></objectgroup>"#;
    let text = layered(&[("Main", "0,0,0,0,1,1,1,1,0,0,0,0")], &format!(r#"<tile id="0">{group}</tile>"#), "");
    let level = level(scratch("reported", "offset.tmx", &text));
    assert_eq!(level["shapes"], json!({"half-bottom": 4}));
    let warned = "tileset 't': the layer of the collision shapes of tile 0 has an offset: Tiled ignores it";
    assert_eq!(list(&level, "warnings"), [warned]);
}

#[test]
fn rules_of_automapping() {
    let cells = "1,1,1,1,1,1,1,1,1,1,1,1";
    let warned = |name: &str, layers: &[(&str, &str)]| {
        let text = layered(layers, r#"<tile id="0" type="Solid"/>"#, "");
        list(&level(scratch("reported", name, &text)), "warnings").iter().any(|line| line.contains("automapping"))
    };
    assert!(warned("rule.tmx", &[("regions", cells), ("input_Ground", cells), ("output1_Deco", cells)]));
    assert!(warned("old.tmx", &[("Regions", cells), ("Input_Ground", cells), ("Output_Ground", cells)]));
    assert!(!warned("level.tmx", &[("input_Ground", cells), ("output_Deco", cells), ("Main", cells)]));
    assert!(!warned("regions.tmx", &[("regions", cells)]));
}
