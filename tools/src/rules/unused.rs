//! Names what a user has set and no output holds: the report has a line for each owner.

use std::collections::{BTreeMap, HashSet};
use std::fmt::Write;

use super::options::Options;
use super::outline::{LeftOut, Outline, Title};
use super::words::{COLLISION, GUESS, LAST};
use super::{kind::Kind, marked, traits, words};
use crate::model::decimal::Decimal;
use crate::model::map::{Content, Layer, Map, Placed};
use crate::model::object::{Form, Object};
use crate::model::property::{CUSTOM_DATA, Value};
use crate::model::tileset::Tileset;

/// The most names of a line.
const MOST: usize = 12;

/// How often each name occurs.
type Counts<'a> = BTreeMap<&'a str, usize>;
/// Objects, by their layer and id.
type Titles<'a> = HashSet<(&'a str, u32)>;

fn key(title: &Title) -> (&str, u32) {
    (&title.layer, title.id)
}

/// A line for each owner of properties that are in no output, for each layer whose objects lose a
/// text or a rotation, and for each tileset with points or texts among its collision shapes.
pub(super) fn lines(map: &Map, options: &Options, outlines: &[Outline], left_out: &[LeftOut]) -> Vec<String> {
    let mut lines = Vec::new();
    for (owner, properties) in &map.properties {
        let counts = counted(properties.0.iter().filter(|(name, value)| !is_rule(name, value)));
        lines.extend(line(&format!("of {owner}"), &counts));
    }
    let (placed, stamped) = (placed(map), stamped(map));
    for (index, set) in map.tilesets.iter().enumerate() {
        let of_set = counted(set.properties.0.iter().filter(|(_, value)| is_set(value)));
        lines.extend(line(&format!("of tileset '{}'", set.name), &of_set));
        let tiles = set.tiles.iter().filter(|(id, _)| placed.contains(&(index, **id)));
        let own = tiles.flat_map(|(_, tile)| &tile.properties.0);
        // `LDtk` has tags only, which serve its drawing rules.
        let lost = |(name, value): &&(String, Value)| {
            let is_tag = traits::shape(name).is_none() && !options.names(name);
            if map.values { is_tag } else { !of_tile(name, value) }
        };
        let (what, fix) = if map.values { ("tags", "; --flag NAME keeps one") } else { ("properties", "") };
        let owner = format!("of tiles of tileset '{}'", set.name);
        let (texts, own): (Vec<_>, Vec<_>) = own.filter(lost).partition(|(name, _)| map.values && name == CUSTOM_DATA);
        lines.extend(named(what, &owner, &counted(own.into_iter())).map(|line| line + fix));
        if !texts.is_empty() {
            let tiles = words::several(texts.len(), "tile");
            lines.push(format!("the custom data of {tiles} of tileset '{}': no output has it", set.name));
        }
        lines.extend(of_shapes(set, |id| placed.contains(&(index, id)) || stamped.contains(&(index, id))));
    }
    let solid: Titles<'_> = outlines.iter().map(|outline| key(&outline.title)).collect();
    let listed = left_out.iter().filter(|object| object.is_listed());
    let listed: Titles<'_> = listed.map(|object| key(&object.title)).collect();
    for layer in &map.layers {
        let own = layer.properties.clone().with_class(&layer.class);
        let own = counted(own.0.iter().filter(|(name, value)| !is_rule(name, value)));
        lines.extend(line(&format!("of layer '{}'", layer.name), &own));
        let Content::Objects(objects) = &layer.content else { continue };
        let among = |titles: &Titles<'_>| -> Vec<&Object> {
            objects.iter().filter(|object| titles.contains(&(layer.name.as_str(), object.id))).collect()
        };
        let of_solid = among(&solid);
        let properties = of_solid.iter().flat_map(|object| object.properties.0.iter().chain(&object.fields.0));
        let counts = counted(properties.filter(|(name, value)| !of_object(name, value)));
        lines.extend(line(&format!("of solid objects of layer '{}'", layer.name), &counts));
        lines.extend(forms(layer, &among(&listed)));
    }
    lines
}

/// Texts and rotations of listed objects.
fn forms(layer: &Layer, objects: &[&Object]) -> Vec<String> {
    let texts = objects.iter().filter(|object| object.form == Form::Text).count();
    let is_turned = |object: &&&Object| {
        let boxed = matches!(object.form, Form::Rectangle | Form::Ellipse | Form::Capsule | Form::Tile(_));
        boxed && object.rotation != Decimal::ZERO
    };
    let turned = objects.iter().filter(is_turned).count();
    let of = |what: &str, count: usize| {
        format!("the {what} of {} of layer '{}'", words::several(count, "object"), layer.name)
    };
    let mut lines = Vec::new();
    if texts > 0 {
        lines.push(format!("{}: no output has it; give it as a property", of("text", texts)));
    }
    if turned > 0 {
        lines.push(format!("{}: OBJECTS has the box around each; give it as a property", of("rotation", turned)));
    }
    lines
}

fn counted<'a>(properties: impl Iterator<Item = &'a (String, Value)>) -> Counts<'a> {
    let mut counts = Counts::new();
    for (name, _) in properties {
        *counts.entry(name).or_default() += 1;
    }
    counts
}

fn line(owner: &str, counts: &Counts<'_>) -> Option<String> {
    named("properties", owner, counts)
}

fn named(what: &str, owner: &str, counts: &Counts<'_>) -> Option<String> {
    if counts.is_empty() {
        return None;
    }
    let mut text = format!("{what} {owner}:");
    for (i, (name, count)) in counts.iter().take(MOST).enumerate() {
        // Writing to a string cannot fail.
        let _ = write!(text, "{} '{name}'", if i == 0 { "" } else { "," });
        if *count > 1 {
            let _ = write!(text, " ({count} times)");
        }
    }
    if counts.len() > MOST {
        let _ = write!(text, " and {} more", counts.len() - MOST);
    }
    Some(text + ": no output has them")
}

/// Points, texts and sensors in the collision editor of these tiles, and what its other shapes say.
fn of_shapes(set: &Tileset, used: impl Fn(u32) -> bool) -> Vec<String> {
    let tiles = set.tiles.iter().filter(|(id, _)| used(**id)).map(|(_, tile)| tile);
    let shapes: Vec<&Object> = tiles.flat_map(|tile| &tile.shapes).collect();
    let of = |what: &str, is: &dyn Fn(&Object) -> bool| {
        let count = shapes.iter().filter(|shape| is(shape)).count();
        let them = if count == 1 { "it" } else { "them" };
        let whose = format!("{} in the collision editor of tileset '{}'", words::several(count, what), set.name);
        (count > 0).then(|| format!("{whose}: no output has {them}; draw {them} in an object layer"))
    };
    let form = |form: Form| move |shape: &Object| shape.form == form;
    let senses = |shape: &Object| marked::senses(&shape.class, &shape.properties);
    let mut said = Counts::new();
    for shape in shapes.iter().filter(|shape| !senses(shape)) {
        let own = counted(shape.properties.0.iter().filter(|(_, value)| is_set(value))).into_keys();
        for name in own.chain([&*shape.class]).filter(|name| !name.is_empty() && Kind::from_name(name).is_none()) {
            *said.entry(name).or_default() += 1;
        }
    }
    let said = line(&format!("and classes of collision shapes of tileset '{}'", set.name), &said);
    let lost = [of("point", &form(Form::Point)), of("text", &form(Form::Text)), of("sensor", &senses), said];
    lost.into_iter().flatten().collect()
}

/// The tiles that are objects of a map.
fn stamped(map: &Map) -> HashSet<(usize, u32)> {
    let objects = map.layers.iter().filter_map(|layer| match &layer.content {
        Content::Objects(objects) => Some(objects),
        _ => None,
    });
    let stamps = objects.flatten().filter_map(|object| match &object.form {
        Form::Tile(stamp) => Some((stamp.tileset, stamp.id)),
        _ => None,
    });
    stamps.collect()
}

/// The tiles in the layers of a map.
fn placed(map: &Map) -> HashSet<(usize, u32)> {
    let entries = map.palette.iter().filter_map(|entry| match entry {
        Placed::Tile { tileset, id, .. } => Some((*tileset, *id)),
        Placed::Nothing | Placed::Value { .. } => None,
    });
    entries.collect()
}

/// False is the same as nothing.
fn is_set(value: &Value) -> bool {
    !matches!(value, Value::Bool(false)) && !matches!(value, Value::Text(text) if text.eq_ignore_ascii_case("false"))
}

/// Whether a property of a layer, a group or a map says nothing, or what is solid.
fn is_rule(name: &str, value: &Value) -> bool {
    match value {
        Value::Text(class) if name == "class" => says(class),
        _ => !is_set(value) || value.is_true() && says(name),
    }
}

/// Whether a name is one of those that make something solid or one-way.
fn says(name: &str) -> bool {
    [COLLISION, GUESS, LAST].iter().any(|list| words::has(name, list))
        || Kind::from_name(name).is_some()
        || traits::shape(name).is_some()
}

/// True properties of tiles are flags or rules.
fn of_tile(name: &str, value: &Value) -> bool {
    let shape = ["shape", "npp"].iter().any(|known| name.eq_ignore_ascii_case(known));
    let one = (matches!(value, Value::Number(_)) || value.is_one()) && traits::shape(name).is_some();
    !is_set(value) || value.is_true() || shape || one
}

fn of_object(name: &str, value: &Value) -> bool {
    !is_set(value) || value.is_true() || name.eq_ignore_ascii_case("kind")
}
