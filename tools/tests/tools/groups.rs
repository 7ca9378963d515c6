//! Groups of the values of an `LDtk` `IntGrid`: a group decides about values whose own names say
//! nothing.

use serde_json::{Value, json};

use crate::support::{Ran, run, scratch};

/// A value: its name and the number of its group.
type Named<'a> = (Option<&'a str>, u32);

/// A level of one row, with each value once, in a layer of this name. Groups count from 1.
fn project(layer: &str, values: &[Named<'_>], groups: &[&str]) -> String {
    let values: Vec<Value> = values
        .iter()
        .zip(1..)
        .map(|((name, group), value)| json!({"value": value, "identifier": name, "groupUid": group}))
        .collect();
    let groups: Vec<Value> =
        groups.iter().zip(1..).map(|(name, uid)| json!({"uid": uid, "identifier": name})).collect();
    let (count, cells) = (values.len(), (1..=values.len()).collect::<Vec<_>>());
    json!({
        "defs": {"layers": [{"uid": 2, "intGridValues": values, "intGridValuesGroups": groups}]},
        "levels": [{"identifier": "One", "layerInstances": [{
            "__type": "IntGrid", "__identifier": layer, "__cWid": count, "__cHei": 1, "__gridSize": 16,
            "layerDefUid": 2, "intGridCsv": cells,
        }]}],
    })
    .to_string()
}

fn baked(name: &str, text: &str, options: &str) -> Ran {
    run("bake", scratch("groups", &format!("{name}.ldtk"), text), &format!("--json {options}"))
}

fn level(ran: &Ran) -> Value {
    assert_eq!(ran.status, 0, "{ran:?}");
    serde_json::from_str(ran.last()).unwrap()
}

#[test]
fn a_group_decides_about_names_that_say_nothing() {
    let values = [(Some("grass"), 1), (Some("wave"), 2), (Some("plank"), 3), (Some("Wall"), 2), (Some("lamp"), 0)];
    let text = project("Terrain", &values, &["Solids", "Water", "OneWay"]);
    let one = level(&baked("named", &text, ""));
    assert_eq!((&one["solid"], &one["one_way"]), (&json!(2), &json!(1)), "{one}");
    // Its own name stays a flag, as that of any value.
    assert_eq!(one["flags"]["grass"], 1);
    assert!(one["rules"].to_string().contains("value 'grass' (group 'Solids') of layer 'Terrain' is full"), "{one}");
}

#[test]
fn a_free_group_is_not_solid_whatever_its_layer_is_called() {
    let values = [(None, 1), (None, 2), (Some("foam"), 1), (None, 0)];
    let text = project("Collisions", &values, &["Liquids", "Ground"]);
    let one = level(&baked("free", &text, ""));
    assert_eq!(one["solid"], 2, "{one}");
    let text = project("Walls", &values, &["Liquids", "Sand"]);
    let one = level(&baked("guessed", &text, ""));
    assert_eq!(one["solid"], 2, "{one}");
    assert!(one["notes"].to_string().contains("values 2, 4 of layer 'Walls' are full"), "{one}");
    // The group is a name for options, and nobody is asked for another one.
    let text = project("Map", &values, &["Liquids", "Sand"]);
    let ran = baked("advice", &text, "");
    assert!(ran.status == 2 && ran.err.contains("values 2, 4 of layer 'Map' have no identifier"), "{ran:?}");
    assert_eq!(level(&baked("option", &text, "--solid Sand"))["solid"], 1);
    assert_eq!(level(&baked("place", &text, "--solid Map:Liquids"))["solid"], 2);
}

#[test]
fn a_group_that_is_not_there_says_nothing() {
    let text = project("Solid", &[(None, 7), (Some("mud"), 7)], &["Water"]);
    assert_eq!(level(&baked("gone", &text, ""))["solid"], 2);
}

#[test]
fn a_group_counts_in_a_guess() {
    // Nothing else is solid, so the last words of a guess count.
    let text = project("Map", &[(Some("oak"), 1), (Some("ice"), 2)], &["Floors", "Water"]);
    let one = level(&baked("floors", &text, ""));
    assert_eq!(one["solid"], 1, "{one}");
}
