//! The words in names that make tiles solid or one-way: of tiles, of layers, and those that count
//! only if nothing else is solid.

use crate::support::{Ran, rows, run, scratch};

/// The cells of a map: `#` solid, `=` one-way. Each layer has a name and its cells.
fn cells(layers: &[(&str, &str)], tile: &str, options: &[&str]) -> (String, String) {
    let drawn = |(name, cells): &(&str, &str)| {
        let row = rows(&[cells]);
        let from = row.find("<layer").unwrap();
        row[from..row.find("</layer>").unwrap() + 8].replace("World", name)
    };
    let text = rows(&[layers[0].1]).replace(r#"<tile id="0" type="Solid"/>"#, tile);
    let (from, to) = (text.find("<layer").unwrap(), text.find("</layer>").unwrap() + 8);
    let all: String = layers.iter().map(drawn).collect();
    let level = scratch("words", "level.tmx", format!("{}{all}{}", &text[..from], &text[to..]));
    let args = ["bake".to_owned(), level.display().to_string(), "--json".to_owned()];
    let Ran { status, out, err } =
        crate::support::tilesat(args.into_iter().chain(options.iter().map(|&option| option.to_owned())));
    if status != 0 {
        return (String::new(), err);
    }
    let line: serde_json::Value = serde_json::from_str(&out).unwrap();
    (format!("{} {}", line["solid"], line["one_way"]), err)
}

/// A tile without a meaning.
const PLAIN: &str = "";

#[test]
fn layers_of_collisions() {
    for name in ["collide", "Collides", "Collidable", "blocked", "Blocking", "blocked_tiles", "Collider", "solid"] {
        let (found, notes) = cells(&[(name, "##."), ("Trees", "..#")], PLAIN, &[]);
        assert_eq!((found.as_str(), notes.as_str()), ("2 0", ""), "{name}");
    }
    for name in ["collisionlayer", "COLLISIONMAP", "collisiontiles", "solidobjects", "SolidsLayer", "collisionboxes"] {
        assert_eq!(cells(&[(name, "##.")], PLAIN, &[]).0, "2 0", "{name}");
    }
    for name in ["not blocked", "no collide", "blockade", "Trees", "solidity", "boxlayer", "layer"] {
        assert_eq!(cells(&[(name, "##.")], PLAIN, &[]).0, "", "{name}");
    }
}

#[test]
fn one_way_layers() {
    for name in ["OneWay", "one-way platforms", "One_Ways", "oneway", "ONE WAY", "OneWayCollision"] {
        let (found, notes) = cells(&[("Collision", "##.."), (name, "..##")], PLAIN, &[]);
        assert_eq!((found.as_str(), notes.as_str()), ("2 2", ""), "{name}");
    }
    for name in ["one", "way one", "Stoneway", "not one-way"] {
        assert_eq!(cells(&[("Collision", "##.."), (name, "..##")], PLAIN, &[]).0, "2 0", "{name}");
    }
    let bridges = [("Collision", "##.."), ("Bridges", "..##")];
    assert_eq!(cells(&bridges, PLAIN, &["--one-way-layer", "bridges"]).0, "2 2");
    assert_eq!(cells(&bridges, PLAIN, &["--one-way-layer", "Collision"]).0, "0 2");
    let why = cells(&bridges, PLAIN, &["--one-way", "Bridges"]).1;
    assert!(why.contains("but a layer is: add --solid-layer 'Bridges' or --one-way-layer 'Bridges'"), "{why}");
    assert!(cells(&bridges, PLAIN, &["--one-way-layer", "Ropes"]).1.contains("there is no such layer"));
}

/// A map that is seen from above has a floor and walls.
#[test]
fn floors_and_boundaries_are_the_last_guess() {
    for name in ["Floor", "floors", "Boundaries", "boundary"] {
        let (found, notes) = cells(&[(name, "##..")], PLAIN, &[]);
        assert!(found == "2 0" && notes.contains(&format!("layer '{name}' is solid because of its name")), "{notes}");
        let (found, notes) = cells(&[(name, "##.."), ("Walls", "..#.")], PLAIN, &[]);
        assert_eq!(found, "1 0", "{name}");
        assert!(notes.contains(&format!("layer '{name}' is not solid")) && notes.contains("layer 'Walls' is solid"));
        let (found, notes) = cells(&[(name, "##.."), ("Collision", "..#.")], PLAIN, &[]);
        assert!(found == "1 0" && notes.contains(&format!("layer '{name}' is not solid")), "{notes}");
    }
}

/// Before 0.17, properties of Tiled had no types.
#[test]
fn properties_that_mean_true() {
    let tile = |name: &str, rest: &str| {
        format!(r#"<tile id="0"><properties><property name="{name}" {rest}/></properties></tile>"#)
    };
    for (name, rest) in [
        ("collider", r#"type="bool" value="true""#),
        ("collide", r#"value="true""#),
        ("collides", r#"value="1""#),
        ("solid", r#"value=" 1 ""#),
        ("collides", r#"type="int" value="1""#),
    ] {
        assert_eq!(cells(&[("a", "##.")], &tile(name, rest), &[]).0, "2 0", "{name} {rest}");
    }
    for rest in [r#"value="0""#, r#"value="nan""#, r#"value="one""#, r#"value="""#] {
        assert_eq!(cells(&[("a", "##.")], &tile("collides", rest), &[]).0, "", "{rest}");
    }
    assert_eq!(cells(&[("a", "##.")], r#"<tile id="0" type="Collider"/>"#, &[]).0, "2 0");
}

/// All commands and the project file know the option.
#[test]
fn one_way_layers_in_the_project_file() {
    let text = rows(&["##", ".."]).replace(r#"<tile id="0" type="Solid"/>"#, "");
    scratch("words", "tilesat.toml", "one-way-layer = [\"World\"]");
    let ran = run("bake", scratch("words", "file.tmx", text), "--json");
    assert!(ran.status == 0 && ran.out.contains("\"one_way\":2"), "{ran:?}");
}

/// The refusal has what settles it, ready to paste if there is one choice.
#[test]
fn nothing_solid_says_what_to_do() {
    let tile = |properties: &str| format!(r#"<tile id="0"><properties>{properties}</properties></tile>"#);
    let property = |name: &str, rest: &str| tile(&format!(r#"<property name="{name}" {rest}/>"#));
    let plain = [("Tile Layer 1", "##.")];
    for (layers, tile, part) in [
        (
            &plain[..],
            String::new(),
            "the tile layer is 'Tile Layer 1' (2 tiles): add --solid-layer 'Tile Layer 1' if all of it is solid",
        ),
        (
            &[("a", "#"), ("b", "#")],
            String::new(),
            "the tile layers are 'a' (1 tile), 'b' (1 tile): add --solid-layer NAME",
        ),
        (&plain, r#"<tile id="0" type="Grass"/>"#.to_owned(), "the name of tiles is 'Grass': add --solid 'Grass'"),
        (
            &plain,
            property("collides", r#"value="yes""#),
            "tiles have the property 'collides' = 'yes', a text: make it a bool that is true",
        ),
        (&plain, property("collision", r#"value="top""#), "or add --one-way 'collision:top'"),
        (&plain, property("solid", r#"value="""#), "tiles have the property 'solid' = '', a text"),
    ] {
        let why = cells(layers, &tile, &[]).1;
        assert!(why.contains(part), "{part} is not in {why}");
    }
    for rest in [r#"type="bool" value="false""#, r#"value="0""#] {
        let why = cells(&plain, &property("solid", rest), &[]).1;
        assert!(why.contains("nothing is solid") && !why.contains("have the property"), "{why}");
    }
    let group = r#"<objectgroup id="2" name="Things"><object id="1" x="0" y="0" width="9" height="9"/></objectgroup>"#;
    let text = rows(&["."]).replace(r#"<objectgroup id="2" name="L" class="Solid"></objectgroup>"#, group);
    let ran = run("bake", scratch("words", "things.tmx", text), "--json");
    assert!(ran.err.contains("the object layer is 'Things' (1 object): add --objects 'Things' if they are"), "{ran:?}");
}

/// The last guess of all: words of other languages.
#[test]
fn other_languages() {
    for name in [
        "Kollision",
        "Mauern",
        "W\u{e4}nde",
        "Plattformen",
        "Murs",
        "Plateformes",
        "Colisiones",
        "paredes_1",
        "Colis\u{e3}o",
        "\u{421}\u{442}\u{435}\u{43d}\u{44b}",
        "\u{78b0}\u{649e}\u{5c42}",
        "\u{5899}\u{58c1}",
        "\u{5f53}\u{305f}\u{308a}\u{5224}\u{5b9a}",
        "Boden",
        "Suelo",
        "Ch\u{e3}o",
        "\u{5730}\u{9762}",
        "\u{5e8a}",
    ] {
        let (found, notes) = cells(&[(name, "##."), ("Trees", "..#")], PLAIN, &[]);
        assert!(
            found == "2 0" && notes.contains(&format!("GUESS: nothing marks solid tiles, so layer '{name}'")),
            "{name}: {notes}"
        );
    }
    for name in [
        "Hintergrund Mauer",
        "Wanderung",
        "Sonne",
        "ohne Kollision",
        "pared de fondo",
        "\u{80cc}\u{666f}\u{306e}\u{58c1}",
        "\u{440}\u{430}\u{441}\u{442}\u{435}\u{43d}\u{438}\u{44f}",
    ] {
        assert_eq!(cells(&[(name, "##.")], PLAIN, &[]).0, "", "{name}");
    }
    // Walls are surer than ground, and English words are surer than others.
    let (found, notes) = cells(&[("Boden", "###"), ("Mauer", "#..")], PLAIN, &[]);
    assert!(
        found == "1 0" && notes.contains("layer 'Boden' is not solid, because a surer name of a layer is"),
        "{notes}"
    );
    assert_eq!(cells(&[("Mauer", "##."), ("Walls", "..#")], PLAIN, &[]).0, "1 0");
    let (found, notes) = cells(&[("Mauer", "##."), ("Collision", "..#")], PLAIN, &[]);
    assert!(found == "1 0" && notes.contains("layer 'Mauer' is not solid"), "{notes}");
}
