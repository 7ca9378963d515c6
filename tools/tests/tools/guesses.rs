//! Guesses about levels in which no rule marks what is solid: tiles whose own names or properties
//! say it in other words, and ground that walls stand on.

use crate::support::{Ran, layered, scratch, tilesat};

/// The number of solid cells and segments, the flags and the messages. Or the reason of a refusal.
fn baked(text: &str, options: &[&str]) -> (String, String) {
    let file = scratch("guesses", "level.tmx", text);
    let args = ["bake".to_owned(), file.display().to_string(), "--json".to_owned()];
    let Ran { status, out, err } = tilesat(args.into_iter().chain(options.iter().map(|&option| option.to_owned())));
    if status != 0 {
        return (String::new(), err);
    }
    let line: serde_json::Value = serde_json::from_str(&out).unwrap();
    let list = |name: &str| line[name].as_array().unwrap().iter().map(|text| text.as_str().unwrap().to_owned());
    let said: Vec<String> = list("warnings").chain(list("notes")).collect();
    (format!("{} {} {}", line["solid"], line["segments"], line["flags"]), said.join("\n"))
}

fn property(id: u32, name: &str, rest: &str) -> String {
    format!(r#"<tile id="{id}"><properties><property name="{name}" {rest}/></properties></tile>"#)
}

/// Five cells of the tile 0, six of the tile 3, and an empty one.
const MIXED: &str = "1,1,1,1,4,4,4,1,4,4,4,0";
const FULL: &str = "1,1,1,1,1,1,1,1,1,1,1,1";
const AROUND: &str = "4,4,4,4,4,0,0,4,4,4,4,4";

#[test]
fn tiles_that_say_it_in_other_words() {
    for name in ["isSolid", "is_solid", "hasCollision", "ge_collide", "impassable", "not_walkable", "isBlocked"] {
        for layer in ["Map", "Ground"] {
            let text = layered(&[(layer, MIXED)], &property(0, name, r#"type="bool" value="true""#), "");
            let (found, said) = baked(&text, &[]);
            assert_eq!(found, "5 0 {}", "{name} {layer}");
            assert!(
                said.contains(&format!("with the property '{name}' are full; --solid '{name}' confirms it")),
                "{said}"
            );
            assert_eq!(baked(&text, &["--solid", name]), ("5 0 {}".to_owned(), String::new()), "{name}");
            let (found, said) = baked(&text, &["--empty", name]);
            assert!(found.starts_with('6') || layer == "Map" && said.contains("nothing is solid"), "{found} {said}");
        }
    }
    let text = layered(&[("Ground", MIXED)], r#"<tile id="0" class="SolidBrick"/>"#, "");
    assert_eq!(baked(&text, &[]).0, "5 0 {}");
    for name in ["no_collision", "solidarity", "walkable", "passable", "Kill"] {
        let text = layered(&[("Map", MIXED)], &property(0, name, r#"type="bool" value="true""#), "");
        assert_eq!(baked(&text, &[]).0, "", "{name}");
    }
    // What a rule marks comes first, and a name that is only a flag says nothing.
    let both = property(0, "isSolid", r#"type="bool" value="true""#) + r#"<tile id="3" class="Wall"/>"#;
    assert_eq!(baked(&layered(&[("Map", MIXED)], &both, ""), &[]).0, r#"6 0 {"isSolid":5}"#);
    let text = layered(&[("Map", MIXED)], &property(0, "isSolid", r#"type="bool" value="true""#), "");
    assert!(baked(&text, &["--flag", "isSolid"]).1.contains("nothing is solid"));
}

#[test]
fn tiles_that_bodies_cannot_walk_on() {
    for (name, rest, value) in [
        ("walkable", r#"type="bool" value="false""#, "false"),
        ("isPassable", r#"type="bool" value="false""#, "false"),
        ("Passable", r#"value="False""#, "False"),
        ("walkable", r#"type="int" value="0""#, "0"),
    ] {
        let tiles = property(0, name, rest) + &property(3, name, r#"type="bool" value="true""#);
        for layer in ["Map", "Ground"] {
            let text = layered(&[(layer, MIXED)], &tiles, "");
            let (found, said) = baked(&text, &[]);
            assert_eq!(found, format!(r#"5 0 {{"{name}":6}}"#), "{name} {layer}");
            assert!(said.contains(&format!("--solid '{name}:{value}' confirms it")), "{said}");
            let option = format!("{name}:{value}");
            assert_eq!(baked(&text, &["--solid", &option]).1, "", "{option}");
        }
    }
}

/// Ground that bodies can walk on, say its tiles, is not solid. No message says that they are.
#[test]
fn tiles_that_bodies_can_walk_on() {
    let tiles = property(3, "walkable", r#"type="bool" value="true""#);
    assert_eq!(baked(&layered(&[("Ground", MIXED)], &tiles, ""), &[]).0, r#"5 0 {"walkable":6}"#);
    let why = baked(&layered(&[("Map", MIXED)], &tiles, ""), &[]).1;
    assert!(why.contains("'Map' (11 tiles): add --solid-layer") && !why.contains("add --solid 'walkable'"), "{why}");
}

/// A map that is seen from above has ground everywhere, and walls on it.
#[test]
fn ground_under_walls() {
    for (ground, walls) in [
        ("Ground", "Walls"),
        ("ground", "obstacles"),
        ("Terrain", "Blocks"),
        ("Ground", "Boundaries"),
        ("floor", "barriers"),
        ("floor", "boundary"),
    ] {
        let text = layered(&[(ground, FULL), (walls, AROUND)], "", "");
        let (found, said) = baked(&text, &[]);
        assert_eq!(found, "10 0 {}", "{ground} {walls}");
        let note =
            format!("layer '{ground}' is not solid, because layer '{walls}' stands on it; --solid-layer '{ground}'");
        assert!(said.contains(&note) && said.contains(&format!("layer '{walls}' is solid")), "{said}");
        assert_eq!(baked(&text, &["--solid-layer", walls]).1, "");
        assert_eq!(baked(&text, &["--solid-layer", ground]).0, "12 0 {}");
        assert_eq!(baked(&text, &["--ignore-layer", walls]).0, "12 0 {}");
    }
    let objects = |name: &str| {
        format!(
            r#"<objectgroup id="9" name="{name}"><object id="1" x="16" y="0" width="32" height="16"/></objectgroup>"#
        )
    };
    for name in ["Obstacles", "Blocks", "boundaries"] {
        let (found, said) = baked(&layered(&[("Ground", FULL)], "", &objects(name)), &[]);
        assert_eq!(found, "0 4 {}", "{name}");
        assert!(said.contains(&format!("because layer '{name}' stands on it")), "{said}");
    }
}

/// Seen from the side, walls stand beside the ground. Then both are solid.
#[test]
fn ground_beside_walls() {
    let much = "1,1,1,1,1,0,0,1,1,1,1,1";
    for (layers, cells) in [
        ([("Ground", much), ("Walls", "0,0,0,0,0,4,4,0,0,0,0,0")], 12),
        ([("Ground", "0,0,0,0,0,0,0,0,1,1,1,1"), ("Walls", "0,0,0,0,0,0,0,0,4,0,0,4")], 4),
        ([("Ground", much), ("Platforms", "4,0,0,0,0,0,0,0,0,0,0,0")], 10),
        ([("Walls", FULL), ("Blocks", AROUND)], 12),
    ] {
        assert_eq!(baked(&layered(&layers, "", ""), &[]).0, format!("{cells} 0 {{}}"), "{layers:?}");
    }
}

/// Bodies have no room in a level that is all ground.
#[test]
fn nothing_but_ground() {
    let warning =
        "every cell is solid because of the name of layer 'Ground'; if bodies walk on it, add --ignore-layer 'Ground'";
    let text = layered(&[("Ground", FULL), ("Trees", AROUND)], "", "");
    let (found, said) = baked(&text, &[]);
    assert!(found == "12 0 {}" && said.contains(warning), "{found} {said}");
    let remedy = ["--ignore-layer", "Ground", "--solid-layer", "Trees"];
    assert_eq!(baked(&text, &remedy), ("10 0 {}".to_owned(), String::new()));
    for options in [["--solid-layer", "Ground"], ["--solid-layer", "Trees"]] {
        assert!(!baked(&text, &options).1.contains("every cell"));
    }
    assert!(!baked(&layered(&[("Ground", MIXED)], "", ""), &[]).1.contains("every cell"));
    // Tiles have names, and one of them is that of the solid ones.
    let named = |tiles: &str| layered(&[("Ground", AROUND.replace('0', "1").as_str())], tiles, "");
    let text = named(&property(3, "obstacle", r#"type="bool" value="true""#));
    let said = baked(&text, &[]).1;
    assert!(said.contains("; if only the tiles 'obstacle' are solid, add --solid 'obstacle'"), "{said}");
    assert_eq!(baked(&text, &["--solid", "obstacle"]), ("10 0 {}".to_owned(), String::new()));
    let said = baked(&named(&property(3, "type", r#"value="wall""#)), &[]).1;
    assert!(said.contains("; tiles have the property 'type' = 'wall': add --solid 'type:wall'"), "{said}");
}

/// What a tile or an object says of itself counts more than the name of its layer.
#[test]
fn what_is_not_solid_in_a_solid_layer() {
    for (name, rest) in
        [("solid", r#"type="bool" value="false""#), ("isSolid", r#"value="0""#), ("collides", r#"value="false""#)]
    {
        let text = layered(&[("Ground", MIXED)], &property(3, name, rest), "");
        assert_eq!(baked(&text, &[]).0, "5 0 {}", "{name}");
        let object = |id: u32, properties: &str| {
            format!(r#"<object id="{id}" x="0" y="{}" width="16" height="16">{properties}</object>"#, (id - 1) * 32)
        };
        let own = format!(r#"<properties><property name="{name}" {rest}/></properties>"#);
        let objects = |layer: &str| {
            format!(r#"<objectgroup id="9" name="{layer}">{}{}</objectgroup>"#, object(1, ""), object(2, &own))
        };
        for layer in ["Collision", "Obstacles"] {
            assert_eq!(baked(&layered(&[], "", &objects(layer)), &[]).0, "0 4 {}", "{name} {layer}");
        }
        // The user has the last word.
        assert_eq!(baked(&layered(&[], "", &objects("Things")), &["--objects", "Things"]).0, "0 8 {}", "{name}");
        // Its class says the contrary, and comes first.
        let both = objects("Collision").replace(r#"<object id="2""#, r#"<object id="2" class="Solid""#);
        assert_eq!(baked(&layered(&[], "", &both), &[]).0, "0 8 {}", "{name}");
    }
    let file = scratch(
        "guesses",
        "left.tmx",
        layered(
            &[],
            "",
            r#"<objectgroup id="9" name="Collision"><object id="1" x="0" y="0" width="9" height="9"/><object id="2" x="0" y="0" width="9" height="9"><properties><property name="solid" type="bool" value="false"/></properties></object></objectgroup>"#,
        ),
    );
    let ran = tilesat(["bake".to_owned(), file.display().to_string(), "--json".to_owned()]);
    assert!(ran.out.contains("object 2 of layer 'Collision': its property 'solid' is false"), "{ran:?}");
}

/// Some games give each layer a property that says whether it is solid.
#[test]
fn layers_that_say_that_they_are_not_solid() {
    let no = r#"><properties><property name="collision" type="bool" value="false"/></properties>"#;
    let text = layered(&[("Ground", FULL), ("Platforms", MIXED)], "", "");
    let denied =
        text.replace(r#"name="Ground" width="4" height="3">"#, &format!(r#"name="Ground" width="4" height="3"{no}"#));
    assert_ne!(text, denied);
    assert_eq!((baked(&text, &[]).0, baked(&denied, &[]).0), ("12 0 {}".to_owned(), "11 0 {}".to_owned()));
    assert_eq!(baked(&denied, &["--solid-layer", "Ground"]).0, "12 0 {}");
    let objects =
        r#"<objectgroup id="9" name="Blocks"><object id="1" x="0" y="0" width="16" height="16"/></objectgroup>"#;
    let denied = layered(&[("Platforms", MIXED)], "", &objects.replacen('>', no, 1));
    assert_eq!(baked(&denied, &[]).0, "11 0 {}");
    assert_eq!(baked(&denied, &["--objects", "Blocks"]).0, "0 4 {}");
}

/// Bodies pass what a box of the collision editor, a tile or an object calls a sensor, and coins.
#[test]
fn sensors_and_coins_are_not_solid() {
    let boxed = |id: u32, own: &str, says: &str| {
        let object = format!(r#"<object id="1" x="0" y="0" width="16" height="16">{says}</object>"#);
        format!(r#"<tile id="{id}">{own}<objectgroup>{object}</objectgroup></tile>"#)
    };
    let is = |layers: &[(&str, &str)], tiles: &str, objects: &str, option: &[&str], count: &str| {
        let (found, said) = baked(&layered(layers, &(tiles.to_owned() + &boxed(3, "", "")), objects), option);
        assert!(found.starts_with(count), "{found} {said}, not {count}: {tiles}{objects}");
    };
    let map = [("Map", MIXED)];
    for (name, count) in [("sensor", "6 0"), ("unity:IsTrigger", "6 0"), ("no_trigger", "11 0")] {
        let own = format!(r#"<properties><property name="{name}" type="bool" value="true"/></properties>"#);
        is(&map, &boxed(0, "", &own), "", &[], count);
        is(&map, &boxed(0, &own, ""), "", &[], count);
        let (tile, layer) = (format!(r#"<tile id="0">{own}</tile>"#), [("Collision", MIXED)]);
        is(&layer, &tile, "", &[], count);
        is(&layer, &tile, "", &["--solid-layer", "Collision"], "11 0");
        let object = format!(r#"<object id="1" x="0" y="0" width="9" height="9">{own}</object>"#);
        let object = format!(r#"<objectgroup id="2" name="Solid">{object}</objectgroup>"#);
        is(&map, "", &object, &[], if count == "6 0" { count } else { "6 4" });
        is(&map, "", &object, &["--objects", "Solid"], "6 4");
        is(&map, "", &object, &["--solid", name], "6 4");
    }
    let layers = [("Coins", AROUND), ("Map", "0,0,0,0,0,0,0,0,1,1,1,1")];
    is(&layers, &boxed(0, "", ""), "", &[], "4 0");
    is(&layers, &boxed(0, "", ""), "", &["--solid-layer", "Coins"], "10 0");
}

/// Some authors draw shapes for ramps only. A bush without a shape on ground that has one stays
/// empty.
#[test]
fn platforms_with_few_collision_shapes() {
    let ramp = r#"<tile id="3"><objectgroup><object id="1" x="0" y="16"><polygon points="0,0 16,-16 16,0"/></object></objectgroup></tile>"#;
    let text = |name: &str, cells: &str| layered(&[(name, cells)], ramp, "");
    let (found, said) = baked(&text("Platforms", "0,0,0,0,0,4,1,1,1,1,1,1"), &[]);
    assert!(found == "7 0 {}" && said.contains("6 tiles of layer 'Platforms' are full"), "{found} {said}");
    let refused = baked(&text("Platforms", "0,0,0,0,0,4,1,1,1,1,1,1"), &["--no-guess", "Platforms"]).0;
    assert!(said.contains("--no-guess 'Platforms' refuses it") && refused == "1 0 {}", "{refused} {said}");
    assert_eq!(baked(&text("Platforms", "0,0,0,1,4,4,4,4,1,1,1,1"), &[]).0, "4 0 {}");
    assert_eq!(baked(&text("Ground", "0,0,0,0,0,4,1,1,1,1,1,1"), &[]).0, "1 0 {}");
}

/// Blocks and empty tiles that are called slopes.
#[test]
fn slopes_by_name_only() {
    let slope = r#"<property name="SlopeLeft" type="bool" value="true"/></properties>"#;
    for (more, count) in [(r#"<property name="solid" type="bool" value="true"/>"#, "11 0"), ("", "6 0")] {
        let tiles = format!(r#"<tile id="0"><properties>{more}{slope}</tile><tile id="3" class="Solid"/>"#);
        let (found, said) = baked(&layered(&[("Map", MIXED)], &tiles, ""), &[]);
        assert!(found.starts_with(count) && said.contains("tiles with 'SlopeLeft' are no slopes"), "{found} {said}");
        for option in [["--solid", "t:0=slope-bottom-left"], ["--flag", "slope left"]] {
            assert_eq!(baked(&layered(&[("Map", MIXED)], &tiles, ""), &option).1, "");
        }
    }
}

fn sides(id: u32, names: &[&str], value: &str) -> String {
    let property = |name: &&str| format!(r#"<property name="{name}" type="bool" value="{value}"/>"#);
    format!(r#"<tile id="{id}"><properties>{}</properties></tile>"#, names.iter().map(property).collect::<String>())
}

/// Engines that block from single sides name each side.
#[test]
fn tiles_that_block_from_sides() {
    let shapes = |names: &[&str]| {
        let file = scratch("guesses", "sides.tmx", layered(&[("Map", MIXED)], &sides(0, names, "true"), ""));
        let ran = tilesat(["bake".to_owned(), file.display().to_string(), "--json".to_owned()]);
        let line = ran.out.lines().last().map(|line| serde_json::from_str::<serde_json::Value>(line).unwrap());
        (line.map(|line| format!("{} {}", line["shapes"], line["flags"])), ran.err)
    };
    let all = [
        ["ge_collide_left", "ge_collide_right", "ge_collide_top", "ge_collide_bottom"],
        ["collideUp", "collideDown", "collideLeft", "collideRight"],
        ["solid_top", "solid_bottom", "solid_left", "solid_right"],
        ["collides_north", "collides_south", "collides_west", "collides_east"],
    ];
    for names in all {
        let (found, said) = shapes(&names);
        assert_eq!(found.as_deref(), Some(r#"{"full":5} {}"#), "{said}");
        assert!(said.contains("with the properties") && said.contains(" are full"), "{said}");
    }
    for (name, shape) in [
        ("ge_collide_top", "one-way-up"),
        ("collideUp", "one-way-up"),
        ("collideRight", "one-way-right"),
        ("blocked_down", "one-way-down"),
        ("collides_left", "one-way-left"),
    ] {
        let (found, said) = shapes(&[name]);
        assert_eq!(found, Some(format!(r#"{{"{shape}":5}} {{}}"#)), "{said}");
        assert!(said.contains(&format!("--solid '{name}={shape}' confirms it")), "{said}");
    }
    for names in [["collideUp", "collideLeft"], ["collides_left", "collides_right"]] {
        let (found, said) = shapes(&names);
        let why = format!(
            "tiles with the properties '{}', '{}' are not solid: they block from some sides",
            names[0], names[1]
        );
        assert!(found.is_none() && said.contains(&why), "{said}");
    }
    // A tile with another mark is as that says.
    assert_eq!(shapes(&["isSolid", "collideUp"]).0.as_deref(), Some(r#"{"full":5} {"collideUp":5}"#));
}

/// Neither does the name of a layer make them solid.
#[test]
fn sides_in_a_layer_of_ground() {
    let two = sides(0, &["collideUp", "collideLeft"], "true");
    let (found, said) = baked(&layered(&[("Ground", MIXED)], &two, ""), &[]);
    assert_eq!(found, r#"6 0 {"collideLeft":5,"collideUp":5}"#);
    assert!(
        said.contains("they block from some sides, and no shape does that; --solid 'collideUp' makes them full"),
        "{said}"
    );
    let none = sides(0, &["collideUp", "collideDown", "collideLeft", "collideRight"], "false");
    assert_eq!(baked(&layered(&[("Ground", MIXED)], &none, ""), &[]).0, "6 0 {}");
}

#[test]
fn a_layer_without_a_guess() {
    let text = layered(&[("Ground", MIXED), ("Walls", AROUND)], "", "");
    assert_eq!(baked(&text, &["--no-guess", "Ground"]).0, "10 0 {}");
    let why = baked(&layered(&[("Ground", MIXED)], "", ""), &["--no-guess", "ground"]).1;
    assert!(why.contains("nothing is solid"), "{why}");
    let why = baked(&text, &["--no-guess", "Grund"]).1;
    assert!(why.contains("--no-guess Grund: there is no such layer"), "{why}");
    let solid = property(0, "isSolid", r#"type="bool" value="true""#);
    assert!(baked(&layered(&[("Map", MIXED)], &solid, ""), &["--no-guess", "Map"]).1.contains("nothing is solid"));
    // What a rule says stays.
    let marked = layered(&[("Ground", MIXED)], r#"<tile id="0" class="Wall"/>"#, "");
    assert_eq!(baked(&marked, &["--no-guess", "Ground"]).0, "5 0 {}");
}
