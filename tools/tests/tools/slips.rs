//! Solid objects without an inside or a length: a slip of the mouse, and lines drawn as rectangles.
//! The level is read without them, and a line names each.

use serde_json::Value;

use crate::support::{folder, map, run, scratch};

/// A solid object beside the one in question.
const BOX: &str = r#"<object id="9" x="16" y="16" width="16" height="16"/>"#;

/// The file of a map of a row of solid tiles with these objects, solid because of their layer.
fn file(objects: &str) -> std::path::PathBuf {
    scratch("slips", "level.tmx", map(4, 3, "1,1,1,1,0,0,0,0,0,0,0,0", objects))
}

fn baked(objects: &str, options: &str) -> Value {
    let ran = run("bake", file(objects), &format!("--json {options}"));
    assert_eq!(ran.status, 0, "{objects}: {ran:?}");
    serde_json::from_str(ran.last()).unwrap()
}

/// The other solid is read, and a warning of `bake`, `rooms` and `lint` gives the reason.
fn named(object: &str, why: &str) {
    let line = format!("object 1 of layer 'L' at (10, 30): {why}, so it is not solid: ");
    let level = baked(&format!("{BOX}{object}"), "");
    assert_eq!((&level["solid"], &level["segments"]), (&4.into(), &4.into()), "{object}");
    let warnings = level["warnings"].as_array().unwrap();
    assert!(warnings.len() == 1 && warnings[0].as_str().unwrap().starts_with(&line), "{object}: {warnings:?}");
    let out = folder("slips").join("rooms.rs");
    let rooms = run("rooms", file(&format!("{BOX}{object}")), &format!("--room 2x2 -o {}", out.display()));
    assert!(rooms.status == 0 && (rooms.out + &rooms.err).contains(&line), "{object}");
    let lint = run("lint", file(&format!("{BOX}{object}")), "");
    assert!(lint.out.contains("left-out") && lint.out.contains(why), "{object}: {lint:?}");
}

#[test]
fn smaller_than_a_unit() {
    let tiny = "it is smaller than 1/65536 of a pixel";
    for (object, why) in [
        (r#"<object id="1" x="10" y="30" width="0.000001" height="0.000001"/>"#, tiny),
        (r#"<object id="1" x="10" y="30"><polygon points="0,0 0.000001,0 0,0.000001"/></object>"#, tiny),
        (r#"<object id="1" x="10" y="30"><polyline points="0,0 0.000001,0"/></object>"#, tiny),
        (r#"<object id="1" x="10" y="30"><polyline points="0,0"/></object>"#, "it has no second point"),
        (r#"<object id="1" x="10" y="30"><polygon points="0,0 5,5"/></object>"#, "it has 2 corners"),
    ] {
        named(object, why);
    }
    // Smaller than a pixel is something.
    let small = format!(r#"{BOX}<object id="1" x="10" y="30" width="0.3" height="0.2"/>"#);
    let level = baked(&small, "");
    assert!(level["segments"] == 8 && level["warnings"] == serde_json::json!([]), "{level}");
    let scaled = |scale: &str| {
        let small = format!(r#"{BOX}<object id="1" x="8" y="24" width="0.0001" height="0.0001"/>"#);
        baked(&small, scale)["warnings"].to_string().contains("object 1 of layer 'L'")
    };
    assert!(!scaled("--scale 1/1") && scaled("--scale 1/16"));
}

#[test]
fn flat() {
    for (object, why) in [
        (r#"<object id="1" x="10" y="30" width="16" height="0"/>"#, "its height is 0"),
        (r#"<object id="1" x="10" y="30" width="0" height="16"/>"#, "its width is 0"),
        (r#"<object id="1" x="10" y="30" width="16" height="0" rotation="30"/>"#, "it has no area"),
        (r#"<object id="1" x="10" y="30" width="16"><ellipse/></object>"#, "its height is 0"),
        (r#"<object id="1" x="10" y="30"><polygon points="0,0 8,0 16,0"/></object>"#, "its height is 0"),
        (r#"<object id="1" x="10" y="30"><polygon points="0,0 8,0 16,8 8,0"/></object>"#, "it has no area"),
    ] {
        named(object, why);
    }
    // The halves of a bow cancel, but each is something.
    let bow = r#"<object id="1" x="10" y="30"><polygon points="0,0 8,0 0,8 8,8"/></object>"#;
    let ran = run("bake", file(bow), "--json");
    assert!(ran.status == 2 && ran.err.contains("object 1 of layer 'L': it crosses itself"), "{ran:?}");
}

/// A flat rectangle that is one-way is a floor, and not a wall.
#[test]
fn flat_and_one_way() {
    let flat = |height: u32| format!(r#"<object id="1" type="OneWay" x="16" y="32" width="16" height="{height}"/>"#);
    let level = baked(&flat(0), "");
    assert!(level["segments"] == 1 && level["warnings"] == serde_json::json!([]), "{level}");
    assert_eq!(baked(&flat(4), "")["segments"], 1);
}

/// Alone it makes nothing solid.
#[test]
fn nothing_else() {
    let text = map(4, 3, "0,0,0,0,0,0,0,0,0,0,0,0", r#"<object id="1" x="1" y="1" width="16" height="0"/>"#);
    let ran = run("bake", scratch("slips", "alone.tmx", text), "--json");
    let why = "object 1 of layer 'L': its height is 0, so it is not solid";
    assert!(ran.status == 2 && ran.err.contains("nothing is solid") && ran.err.contains(why), "{ran:?}");
}

/// In the collision editor, a chain of one point is a slip, too.
#[test]
fn shapes_of_tiles() {
    let shape = |points: &str| {
        let drawn = format!(
            r#"<tile id="0"><objectgroup><object id="1" x="0" y="8" width="16" height="4"/><object id="2" x="2" y="2"><polyline points="{points}"/></object></objectgroup></tile>"#
        );
        let text = map(2, 1, "1,1", "").replace(r#"<tile id="0" type="Solid"/>"#, &drawn);
        run("bake", scratch("slips", "shape.tmx", text), "--json")
    };
    let ran = shape("0,0 0.000001,0");
    let note =
        "2 collision shapes of tiles in layer 'World', the first at (2, 2): it is smaller than 1/65536 of a pixel";
    assert!(ran.status == 0 && ran.err.contains(note), "{ran:?}");
    assert!(!shape("0,0 8,0").err.contains("collision shapes of tiles"));
}
