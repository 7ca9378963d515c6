//! The search for what is solid: which finds end it, for which levels, and what it says of layers
//! that it passes over.

use crate::support::{layered, run, scratch};

/// The numbers of solid tiles, one-way tiles and segments, and the notes.
fn baked(text: &str) -> (String, String) {
    let ran = run("bake", scratch("search", "level.tmx", text), "--json");
    assert_eq!(ran.status, 0, "{ran:?}");
    let line: serde_json::Value = serde_json::from_str(&ran.out).unwrap();
    (format!("{} {} {}", line["solid"], line["one_way"], line["segments"]), ran.err)
}

const FLOOR: &str = "0,0,0,0,0,0,0,0,1,1,1,1";
const ABOVE: &str = "0,0,0,0,2,0,0,2,0,0,0,0";

fn object(layer: &str, own: &str, at: (u32, u32)) -> String {
    let (x, y) = at;
    format!(
        r#"<objectgroup id="9" name="{layer}"><object id="1" {own} x="{x}" y="{y}" width="16" height="16"/></objectgroup>"#
    )
}

/// Bodies fall past what is one-way.
#[test]
fn one_way_finds_do_not_end_the_search() {
    let one_way = r#"<tile id="1" class="OneWay"/>"#;
    let line = object("Things", r#"class="OneWay""#, (0, 0));
    for (layers, tiles, objects, wanted) in [
        (&[("Ground", FLOOR), ("OneWay", ABOVE)][..], "", "", "4 2 0"),
        (&[("Ground", FLOOR), ("Platforms", ABOVE)], one_way, "", "4 2 0"),
        (&[("Ground", FLOOR)], "", line.as_str(), "4 0 1"),
    ] {
        let (found, notes) = baked(&layered(layers, tiles, objects));
        assert!(found == wanted && notes.contains("layer 'Ground' is solid because of its name"), "{found} {notes}");
    }
}

/// One object does not say what tiles are, and tiles do not say what objects are.
#[test]
fn tiles_and_objects_are_searched_apart() {
    let wall = object("Things", r#"name="wall""#, (0, 0));
    assert_eq!(baked(&layered(&[("Ground", FLOOR)], "", &wall)).0, "4 0 4");
    let marked = r#"<tile id="0" class="Solid"/>"#;
    let (found, notes) = baked(&layered(&[("Map", FLOOR)], marked, &object("Obstacles", "", (0, 0))));
    assert!(
        found == "4 0 4" && notes.contains("nothing marks solid objects, so layer 'Obstacles' is solid"),
        "{notes}"
    );
    // A lift has a name, a class, properties or a picture.
    let lift = object("Platforms", r#"name="lift""#, (0, 0));
    assert_eq!(baked(&layered(&[("Map", FLOOR)], marked, &lift)).0, "4 0 0");
    let (found, notes) = baked(&layered(&[("Map", FLOOR)], marked, &object("Platforms", r#"class="Lift""#, (0, 0))));
    assert!(
        found == "4 0 0" && notes.contains("layer 'Platforms' is not solid, because its objects have a name"),
        "{notes}"
    );
}

/// Solid objects on a layer trace what is drawn there, or bodies walk on it.
#[test]
fn layers_that_objects_trace_are_not_solid() {
    for at in [(0, 32), (48, 32)] {
        let (found, notes) = baked(&layered(&[("Ground", FLOOR)], "", &object("Things", r#"class="Wall""#, at)));
        assert!(found == "0 0 4" && notes.contains("the solid objects of layer 'Things' lie on it"), "{notes}");
    }
    // Beside a layer of solid objects, ground is not guessed: bodies may walk on it.
    let aside = object("Collision", "", (0, 0));
    assert_eq!(baked(&layered(&[("Platforms", FLOOR)], "", &aside)).0, "4 0 4");
    let (found, notes) = baked(&layered(&[("Ground", FLOOR)], "", &aside));
    assert!(found == "0 0 4" && notes.contains("because layer 'Collision' has the solid objects"), "{notes}");
}

/// Whoever misses a layer reads why.
#[test]
fn layers_that_are_passed_over_are_noted() {
    let marked = r#"<tile id="1" class="Solid"/>"#;
    for (layers, tiles, why) in [
        (&[("Ground", FLOOR), ("Collision", ABOVE)][..], "", "because a surer name of a layer is"),
        (&[("Ground", FLOOR), ("Map", ABOVE)], marked, "because tiles of other layers are marked"),
        (&[("Ground", "0,0,2,0,0,0,0,0,1,1,1,1")], marked, "because other tiles of it are marked"),
        (&[("ground_deco", FLOOR), ("Walls", ABOVE)], "", "because its name says that it is drawn behind"),
    ] {
        let (_, notes) = baked(&layered(layers, tiles, ""));
        let name = layers[0].0;
        assert!(notes.contains(&format!("GUESS: layer '{name}' is not solid, {why}")), "{notes}");
    }
    let objects = object("Things", r#"class="Wall""#, (0, 0)) + &object("Obstacles", "", (32, 0));
    let (found, notes) = baked(&layered(&[], "", &objects));
    assert!(found == "0 0 4" && notes.contains("layer 'Obstacles' is not solid, because other objects are"), "{notes}");
}

/// The maps of a world are decided together.
#[test]
fn a_world_does_not_contradict_itself() {
    let marked = r#"<tile id="1" class="Solid"/>"#;
    scratch("search", "a.tmx", layered(&[("Ground", ABOVE)], marked, ""));
    scratch("search", "b.tmx", layered(&[("Ground", FLOOR)], marked, ""));
    let world = r#"{"type":"world","maps":[{"fileName":"a.tmx","x":0,"y":0},{"fileName":"b.tmx","x":64,"y":0}]}"#;
    for command in ["bake", "rooms"] {
        let out = scratch("search", "out.rs", "").display().to_string();
        let ran = run(command, scratch("search", "w.world", world), &format!("-o {out}"));
        let note = "layer 'Ground' is not solid, because tiles of other levels are; --solid-layer 'Ground'";
        assert!(ran.status == 0 && ran.out.contains(note) && !ran.out.contains("solid because of its name"), "{ran:?}");
    }
    // Walls stand on the ground of one map, so the ground of the other one is not solid.
    let everywhere = "1,1,1,1,1,1,1,1,1,1,1,1";
    scratch("search", "a.tmx", layered(&[("Ground", everywhere), ("Walls", ABOVE)], "", ""));
    scratch("search", "b.tmx", layered(&[("Ground", FLOOR), ("Walls", ABOVE)], "", ""));
    let ran = run("bake", scratch("search", "w.world", world), "--json");
    let solid = ran.out.lines().map(|line| serde_json::from_str::<serde_json::Value>(line).unwrap()["solid"].clone());
    assert_eq!(solid.collect::<Vec<_>>(), [2, 2], "{ran:?}");
    // Alone, the map is guessed.
    let ran = run("bake", scratch("search", "b.tmx", layered(&[("Ground", FLOOR)], marked, "")), "--json");
    assert!(ran.out.contains("\"solid\":4"), "{ran:?}");
}

/// A level that is skipped need not be readable.
#[test]
fn skipped_levels_are_not_read() {
    scratch("search", "a.tmx", layered(&[("Collision", FLOOR)], "", ""));
    let world = r#"{"type":"world","maps":[{"fileName":"a.tmx","x":0,"y":0},{"fileName":"gone.tmx","x":64,"y":0}]}"#;
    let file = || scratch("search", "skip.world", world);
    assert_eq!(run("bake", file(), "--json").status, 2);
    let ran = run("bake", file(), "--json --ignore-level gone");
    assert!(ran.status == 0 && ran.out.contains("\"solid\":4"), "{ran:?}");
}

/// A layer can have no name.
#[test]
fn options_name_layers_without_a_name() {
    let file = scratch("search", "bare.tmx", layered(&[], "", &object("", "", (0, 0))));
    let ran =
        crate::support::tilesat(["bake".into(), file.into_os_string(), "--json".into(), "--objects".into(), "".into()]);
    assert!(ran.out.contains("\"segments\":4"), "{ran:?}");
}
