//! Objects whose own class or name says that they are solid, in layers that say nothing. They count
//! only if nothing else is solid.

use serde_json::Value;

use crate::support::{layered, run, scratch};

/// A map with these objects, and a row of tiles of this class.
fn file(name: &str, objects: &str, class: &str) -> std::path::PathBuf {
    let layer = format!(r#"<objectgroup id="2" name="Object Layer 1">{objects}</objectgroup>"#);
    let tiles = format!(r#"<tile id="0" type="{class}"/>"#);
    scratch("called", name, layered(&[("Tile Layer 1", "0,0,0,0,0,0,0,0,1,1,1,1")], &tiles, &layer))
}

fn object(id: u32, own: &str) -> String {
    format!(r#"<object id="{id}" {own} x="{}" y="0" width="4" height="4"/>"#, id * 8)
}

fn level(name: &str, objects: &str, class: &str) -> Value {
    let ran = run("bake", file(name, objects, class), "--json");
    assert_eq!(ran.status, 0, "{ran:?}");
    serde_json::from_str(ran.last()).unwrap()
}

/// The edges of the solid objects, if any is, without other notes than that of the guess.
fn edges(own: &str) -> Option<u64> {
    let ran = run("bake", file("one.tmx", &object(1, own), ""), "--json");
    if ran.status != 0 {
        assert!(ran.err.contains("nothing is solid"), "{ran:?}");
        return None;
    }
    let level: Value = serde_json::from_str(ran.last()).unwrap();
    assert!(level["notes"].to_string().contains("because of their classes or names"), "{level}");
    level["segments"].as_u64()
}

#[test]
fn classes_and_names_with_a_word() {
    for word in ["CollisionBox", "COLLISIONBOX", "collision_polygon", "BoxCollider", "Ground", "Obstacle 2", "Floor"] {
        for attribute in ["type", "class", "name"] {
            assert_eq!(edges(&format!(r#"{attribute}="{word}""#)), Some(4), "{word}");
        }
    }
    for word in ["Enemy", "PlatformSpawn", "GroundTrigger", "no collision box", "background_ground", "Boxer"] {
        assert_eq!(edges(&format!(r#"type="{word}""#)), None, "{word}");
    }
}

#[test]
fn the_surest_words_first() {
    let objects = [object(1, r#"type="Platform""#), object(2, r#"type="CollisionBox""#), object(3, r#"name="hero""#)];
    let both = level("surest.tmx", &objects.concat(), "");
    assert_eq!((&both["segments"], both["objects"].as_array().map(Vec::len)), (&4.into(), Some(2)), "{both}");
    assert_eq!(both["rules"].to_string(), r#"[{"rule":"d","tiles":1,"what":"objects of layer 'Object Layer 1'"}]"#);
    let note = "GUESS: nothing marks anything solid, so objects of layer 'Object Layer 1' are solid because of their \
                classes or names 'CollisionBox'; the class Solid in Tiled confirms it, --no-guess 'Object Layer 1' \
                refuses it";
    assert_eq!(both["notes"], serde_json::json!([note]));
    let ran = run("bake", file("refused.tmx", &objects.concat(), ""), "--json --no-guess ObjectLayer1");
    assert!(ran.status == 2 && ran.err.contains("nothing is solid"), "{ran:?}");
}

#[test]
fn not_beside_other_solids() {
    let tiles = level("tiles.tmx", &object(1, r#"type="Platform""#), "Solid");
    assert_eq!((&tiles["solid"], &tiles["segments"]), (&4.into(), &0.into()), "{tiles}");
    let objects = level("objects.tmx", &(object(1, r#"type="Platform""#) + &object(2, r#"type="Solid""#)), "");
    assert_eq!(objects["segments"], 4, "{objects}");
}

/// A round object has one note, however often the tools look.
#[test]
fn notes_are_not_repeated() {
    let round = r#"<object id="1" type="Ground" x="0" y="0" width="16" height="16"><ellipse/></object>"#;
    let one_way = r#"<object id="2" type="OneWay" x="32" y="0" width="16" height="16"><ellipse/></object>"#;
    let level = level("round.tmx", &format!("{round}{one_way}"), "");
    let notes = level["notes"].to_string();
    assert_eq!((notes.matches("object 1 of").count(), notes.matches("object 2 of").count()), (1, 1), "{notes}");
}
