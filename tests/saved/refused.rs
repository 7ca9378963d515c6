//! A wrong state is refused, with the fault and its place.

use crate::values::{EDGE, Near, bouncer, convex_solids, grid, heroes, lists, rope, rubber, scene, solids, walker};
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::{Value, json, to_value};
use tilesat::broad::Exceptions;
use tilesat::motion::response::{Masses, Stick};
use tilesat::motion::{Acceleration, Carry};
use tilesat::shape::AnyShape;
use tilesat::{
    Aabb, Capsule, Character, Circle, ConvexPolygon, Mover, OrientedBox, Ratio, Scene, Segment, Solid, Surface, Toi,
    Walker,
};
use tilesat_judge::scenes::BODIES;

/// A correct value with one wrong part is refused with these words.
fn refused<T: Serialize + DeserializeOwned>(value: &T, path: &str, to: Value, words: &[&str]) {
    // By way of text, as from a file.
    let fault = |text: &str| serde_json::from_str::<T>(text).err().map(|error| error.to_string());
    says(to_value(value).unwrap(), (path, to), words, &fault);
}

/// `fault` is why a text is refused.
fn says(mut form: Value, (path, to): (&str, Value), words: &[&str], fault: &dyn Fn(&str) -> Option<String>) {
    let whole = form.clone();
    let place = form.pointer_mut(path).unwrap_or_else(|| panic!("no {path}: {whole:?}"));
    assert_ne!(*place, to, "{path} is not changed");
    *place = to;
    let error = fault(&form.to_string()).unwrap_or_else(|| panic!("{form} is read"));
    for word in words {
        assert!(error.contains(word), "{path}: {error:?} does not say {word:?}");
    }
}

#[test]
fn shapes_of_any_kind() {
    let (aabbs, circles, segments, capsules, turned, polygons) = crate::values::shapes();
    refused::<Aabb>(&aabbs[2], "/min/x/bits", json!(-6), &["Aabb", "Width"]);
    refused::<Aabb>(&aabbs[2], "/max/y/bits", json!(2), &["Aabb", "Height"]);
    refused::<Aabb>(&aabbs[1], "/max/y/bits", json!(EDGE + 1), &["Aabb", "Y is out of range"]);
    refused::<Circle>(&circles[3], "/radius/bits", json!(-1), &["Circle", "Radius", "-1 raw"]);
    refused::<Circle>(&circles[1], "/centre/x/bits", json!(1), &["Circle", "X is out of range"]);
    refused::<Segment>(&segments[0], "/b/x/bits", json!(i32::MIN), &["Segment", "X does not fit"]);
    refused::<Capsule>(&capsules[0], "/radius/bits", json!(-5), &["Capsule", "Radius"]);
    refused::<OrientedBox>(&turned[1], "/across/x/bits", json!(40_000), &["OrientedBox", "direction"]);
    refused::<OrientedBox>(&turned[1], "/along/x/bits", json!(i32::MIN), &["OrientedBox", "HalfExtent"]);
    refused::<OrientedBox>(&turned[3], "/radius/bits", json!(-1), &["OrientedBox", "Radius"]);
    refused::<ConvexPolygon<5>>(
        &polygons[1],
        "/corners/2",
        json!({"x": {"bits": 1}, "y": {"bits": 1}}),
        &["ConvexPolygon"],
    );
    refused::<ConvexPolygon<5>>(&polygons[1], "/radius/bits", json!(-1), &["ConvexPolygon", "Radius"]);
    refused::<ConvexPolygon<5>>(&polygons[0], "/corners", json!([]), &["ConvexPolygon", "0 corners", "needs three"]);
    let six = json!([0, 1, 2, 3, 4, 5].map(|k| json!({"x": {"bits": k}, "y": {"bits": k * k}})));
    refused::<ConvexPolygon<5>>(&polygons[0], "/corners", six, &["invalid length"]);
}

#[test]
fn parts_of_games() {
    refused::<Solid>(&solids()[1], "/version", json!(2), &["version 2 is unknown", "version 1"]);
    refused::<Solid>(&solids()[1], "/shape/max/x/bits", json!(0), &["Solid", "Width"]);
    refused::<Solid>(&solids()[1], "/motion/x/bits", json!(1 << 28), &["Solid", "MotionX"]);
    refused::<Solid>(&solids()[1], "/one_way", json!("Inside"), &["Inside"]);
    let [_, moves, turns] = convex_solids()[..] else { panic!("three") };
    refused(&moves, "/version", json!(2), &["version 2 is unknown"]);
    refused(&moves, "/change/Moves/x/bits", json!(1 << 28), &["ConvexSolid", "MotionX"]);
    refused(&moves, "/shape/Circle/radius/bits", json!(0), &["ConvexSolid", "no area"]);
    refused(&turns, "/change/Turns/OrientedBox/radius/bits", json!(9), &["ConvexSolid", "cannot have a radius"]);
    refused(
        &moves,
        "/change",
        json!({"Turns": to_value(moves.shape()).unwrap()}),
        &["ConvexSolid", "cannot have a radius"],
    );
    let triangle = AnyShape::from(crate::values::shapes().5[0]);
    refused(&turns, "/change/Turns", to_value(triangle).unwrap(), &["ConvexSolid", "must have 4"]);
    refused::<Walker>(&walker(), "/snap/bits", json!(-1), &["Walker", "Snap"]);
    refused::<Walker>(&walker(), "/step/bits", json!(1 << 28), &["Walker", "StepHeight"]);
    refused::<Walker>(&walker(), "/mover/version", json!(0), &["version 0 is unknown"]);
    refused::<Mover<Surface>>(&bouncer(), "/up", json!({"x": 0, "y": 0}), &["Mover", "no direction"]);
    refused::<Mover<Surface>>(&bouncer(), "/up", json!({"x": 1, "y": i32::MIN}), &["Mover", "i32::MIN"]);
    refused::<Surface>(&rubber(), "/friction", json!((1 << 30) + 1), &["Ratio", "above one"]);
    refused::<Surface>(&rubber(), "/rest", json!(1u32 << 31), &["Surface", "rest"]);
    let (hero, standing) = (heroes()[0], heroes().into_iter().find(Character::on_floor).unwrap());
    refused::<Character>(&hero, "/version", json!(255), &["version 255 is unknown"]);
    refused::<Character>(&hero, "/memory/wall", json!(2), &["Character", "wall"]);
    refused::<Character>(&hero, "/limits/min/x/bits", json!(EDGE), &["Aabb", "Width"]);
    refused::<Character>(&standing, "/floor/axis", json!({"x": 0, "y": 0}), &["Character", "no normal"]);
    refused::<Character>(&standing, "/floor/axis/y", json!(i32::MIN), &["Character", "i32::MIN"]);
    let (_, link, masses, gravity, carry, .., toi, ratio) = rope();
    refused::<Stick>(&link.stick, "/length/bits", json!(-1), &["Stick", "Length"]);
    refused::<Masses>(&masses, "/a", json!(6), &["Masses", "lowest terms"]);
    refused::<Masses>(&masses, "/a", json!(0), &["Masses", "lowest terms"]);
    refused::<Acceleration>(&gravity, "/frames", json!(0), &["Acceleration", "frames"]);
    refused::<Acceleration>(&gravity, "/by/x/bits", json!(1 << 29), &["Acceleration", "domain"]);
    refused::<Carry>(&carry, "/x", json!(i32::MIN), &["Carry", "parts"]);
    refused::<Toi>(&toi, "", json!(u32::MAX), &["Toi", "above one"]);
    refused::<Ratio>(&ratio, "", json!(-1), &["invalid value"]);
}

/// A carry has at most the parts of a raw unit, both ends included.
#[test]
fn a_whole_raw_unit_is_a_carry() {
    let carry = rope().4;
    for whole in [1_i32 << 30, -(1 << 30)] {
        let text = json!({"x": whole, "y": whole}).to_string();
        let read: Carry = serde_json::from_str(&text).unwrap();
        assert_eq!(to_value(read).unwrap().to_string(), text);
        refused::<Carry>(&carry, "/x", json!(whole + whole.signum()), &["Carry", "parts"]);
        refused::<Carry>(&carry, "/y", json!(whole + whole.signum()), &["Carry", "parts"]);
    }
}

#[test]
fn lists_of_pairs() {
    let (events, exceptions) = lists();
    let pairs = to_value(events).unwrap()["pairs"].clone();
    refused(&events, "/pairs/0", pairs[1].clone(), &["PairEvents", "slot 1", "ascending"]);
    refused(&events, "/pairs/0/0/a/generation", json!(2), &["Handle", "slot 0", "odd"]);
    refused(&events, "/version", json!(9), &["version 9 is unknown"]);
    let pair = to_value(exceptions).unwrap()["pairs"][0][0].clone();
    refused::<Exceptions<4>>(
        &exceptions,
        "/pairs/0/0",
        json!({"a": pair["b"], "b": pair["a"]}),
        &["Exceptions", "smaller"],
    );
}

/// Every list of a scene describes all slots, and the lists must agree.
#[test]
fn scenes() {
    let one = scene(Near::new(), 3, 26);
    let form = to_value(one).unwrap();
    let slots = form["near"]["table"]["slots"].as_array().unwrap();
    let free = slots.iter().position(|slot| slot.get("Nobody").is_some()).expect("no slot is free");
    let taken = slots.iter().position(|slot| slot.get("Body").is_some()).unwrap();
    let bodies = form["bodies"].as_array().unwrap();
    let of =
        |mode: &str| bodies.iter().position(|body| body["mode"] == mode).unwrap_or_else(|| panic!("none is {mode}"));
    let (awake, fixed) = (of("Awake"), of("Fixed"));
    let first = form["awake"][0].clone();
    let say = |path: &str, to: Value, words: &[&str]| refused::<Scene<Near, BODIES>>(&one, path, to, words);
    say("/version", json!(2), &["version 2 is unknown"]);
    say("/near/version", json!(3), &["version 3 is unknown"]);
    say(&format!("/near/table/slots/{free}/Nobody/generation"), json!(3), &["SortSweep", "free", "odd"]);
    say(&format!("/near/table/slots/{taken}/Body/generation"), json!(2), &["SortSweep", "taken", "even"]);
    say(&format!("/near/table/slots/{free}/Nobody/next"), json!(free), &["SortSweep", "twice"]);
    say(&format!("/near/table/slots/{free}/Nobody/next"), json!(taken), &["SortSweep", "not free"]);
    say("/near/table/free", json!(u16::MAX), &["SortSweep", "leaves some out"]);
    say("/near/table/free", json!(900), &["SortSweep", "slot 900", "not free"]);
    let order = form["near"]["order"].clone();
    say("/near/order/0", order[1].clone(), &["SortSweep", "twice"]);
    say("/near/order/0", json!(99), &["SortSweep", "slot 99", "never taken"]);
    say("/near/sorted", json!(99), &["SortSweep", "more is sorted"]);
    say("/near/order", json!([0]), &["SortSweep", "other slots"]);
    say(&format!("/bodies/{awake}/slot"), json!(BODIES), &["Scene"]);
    say(&format!("/bodies/{awake}/mode"), json!("Asleep"), &["Scene", "slot", "filter, key or rest"]);
    say(&format!("/bodies/{awake}/mode"), json!("Free"), &["Scene", "slot"]);
    say(&format!("/bodies/{fixed}/body/mass"), json!(5), &["Scene", "no mass"]);
    say(&format!("/bodies/{awake}/body/mass"), json!(null), &["Scene", "no mass"]);
    say(&format!("/bodies/{awake}/body/key"), json!(777), &["Scene", "filter, key or rest"]);
    say(&format!("/bodies/{awake}/body/velocity/x/bits"), json!(1 << 30), &["Scene", "velocity"]);
    say(&format!("/bodies/{awake}/ground"), json!(BODIES), &["Scene", "carried"]);
    say("/awake/0", form["awake"][1].clone(), &["Scene", "twice"]);
    say("/awake/0", bodies[fixed]["slot"].clone(), &["Scene", "awake, and is not"]);
    say("/awake", json!([first]), &["Scene", "leaves one out"]);
    say("/sleep/still/bits", json!(-1), &["Scene", "negative"]);
    let mut fewer = bodies.clone();
    fewer.remove(fixed);
    say("/bodies", json!(fewer), &["Scene", "more bodies"]);
    // The box of one of the two.
    let (path, box_) = (bodies.iter().position(|body| body["body"]["shape"].get("Aabb").is_some()).unwrap(), 3);
    say(&format!("/bodies/{path}/body/shape/Aabb/min/x/bits"), json!(box_), &["Scene", "another box"]);
}

/// An order that is used unchanged must be one.
#[test]
fn orders_of_what_has_not_moved() {
    use tilesat::broad::{BroadPhase, SortSweep};
    let mut near = SortSweep::<8>::new();
    let at = |x| Aabb::new(tilesat::Vec2::from_ints(x, 0), tilesat::Vec2::from_ints(x + 8, 8)).unwrap();
    let all = [30, 20, 10].map(|x| near.insert(&at(x), ()).unwrap());
    let anything = to_value(near).unwrap();
    assert!(serde_json::from_value::<SortSweep<8>>(anything).is_ok(), "it will be sorted");
    near.pairs(|_| {});
    refused(&near, "/order", json!([0, 1, 2]), &["SortSweep", "left sides"]);
    refused(&near, "/sorted", json!(2), &["SortSweep", "not in the order"]);
    near.remove(all[1]).unwrap();
    refused(&near, "/stale", json!(false), &["SortSweep", "free, and in the order"]);
    refused(&near, "/sorted", json!(1), &["SortSweep", "not in the order"]);
}

#[test]
fn grids() {
    let one = scene(grid(), 3, 26);
    let near = *one.near();
    let order = to_value(near).unwrap()["order"].clone();
    refused(&near, "/cell/bits", json!(3), &["LooseGrid", "3"]);
    refused(&near, "/columns", json!(7), &["LooseGrid"]);
    refused(&near, "/order/0", order[1].clone(), &["LooseGrid", "twice"]);
    refused(&near, "/order", json!([order[0]]), &["LooseGrid", "more or fewer"]);
    refused(&near, "/origin/x/bits", json!(i32::MIN), &["LooseGrid"]);
    let free = to_value(near).unwrap()["table"]["free"].clone();
    refused(&near, "/order/0", free, &["LooseGrid", "it is free"]);
}
