//! The kind of a placed tile, at any position.

use tilesat::TileShape;

use super::marked::{denied, senses};
use super::options::Options;
use super::sides::Sides;
use super::{Rule, form, identifier, names, traits, words};
use crate::model::flip::Flip;
use crate::model::map::{Map, Placed};
use crate::model::tileset::{Tile, Tileset};

/// A kind, and the rule that gave it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Verdict {
    pub(super) rule: Rule,
    pub(super) what: String,
    pub(super) solid: Solid,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Solid {
    Shape(TileShape),
    /// The shapes of the collision editor.
    Drawn,
    /// The edges of these shapes that face the side of this one-way shape.
    Edges(TileShape),
}

/// The data of a palette entry.
#[derive(Debug, Clone, Default)]
pub(super) struct Meaning {
    pub(super) verdict: Option<Verdict>,
    pub(super) flags: Vec<String>,
}

/// The verdict on an entry of a map's palette.
///
/// # Errors
///
/// One line with the fix.
pub(super) fn of(map: &Map, placed: &Placed, options: &Options) -> Result<Meaning, String> {
    match placed {
        Placed::Nothing => Ok(Meaning::default()),
        Placed::Tile { tileset, id, flip, .. } => {
            let set = &*map.tilesets[*tileset];
            let nothing = Tile::default();
            let tile = set.tiles.get(id).unwrap_or(&nothing);
            let meaning = tile_of(set, *id, tile, *flip, options)
                .map_err(|why| format!("tile {id} of tileset '{}': {why}", set.name));
            // LDtk's tags of tiles serve its drawing rules, unless the user says otherwise.
            let kept = |flag: &String| !map.values || options.is_flag(flag);
            meaning.map(|meaning| Meaning { flags: meaning.flags.into_iter().filter(kept).collect(), ..meaning })
        }
        Placed::Value { layer, number, name } => Ok(value(layer, *number, name.as_deref(), options)),
    }
}

fn tile_of(set: &Tileset, id: u32, tile: &Tile, flip: Flip, options: &Options) -> Result<Meaning, String> {
    let properties = &tile.properties;
    let text = |name| properties.text(name);
    let by_property = traits::by_property(text(SHAPE).as_deref(), text(NPP).as_deref())?;
    let class = Some(tile.class.trim()).filter(|class| !class.is_empty());
    // Sorted, so that the order of flags does not depend on that of the file.
    let mut marks: Vec<&str> = properties.marks().map(str::trim).filter(|name| !name.is_empty()).collect();
    marks.sort_unstable();
    let own: Vec<&str> = class.into_iter().chain(marks).collect();
    let mut known: Vec<String> = own.iter().copied().chain(properties.ones()).map(str::to_owned).collect();
    // Of several sides, one alone says nothing.
    let several = Sides::of(tile, options).is_some_and(|sides| sides.names.len() > 1);
    let is_side = |name: &str| several && words::blocked_side(name).is_some();
    let free = |name: &&str| !options.is_flag(name) && !is_side(name);
    let by_name = traits::named(own.iter().copied().chain(properties.ones()).filter(free));
    let mut flags: Vec<String> = Vec::new();
    for name in own.iter().filter(|name| options.is_flag(name) || traits::shape(name).is_none()) {
        if !flags.iter().any(|flag| flag.eq_ignore_ascii_case(name)) {
            flags.push((*name).to_owned());
        }
    }
    known.push(format!("{}:{id}", set.name));
    known.extend(properties.valued());
    let shaped = |rule, what, shape| Some(Verdict { rule, what, solid: Solid::Shape(flip.of(shape)) });
    let has_shapes =
        tile.shapes.iter().any(|shape| form::has_extent(shape) && !senses(&shape.class, &shape.properties));
    let verdict = if let Some((name, shape)) = options.shape(&known) {
        flags.retain(|flag| options.is_flag(flag) || !words::same(flag, name));
        shaped(Rule::Option, format!("{name} is {}", names::name(shape)), shape)
    } else if let Some(shape) = by_property {
        shaped(Rule::A, format!("property shape or npp is {}", names::name(shape)), shape)
    } else if senses(&tile.class, properties) {
        None
    } else if let Some((name, shape)) = by_name {
        let kind = if class == Some(name) { "class" } else { "property" };
        if has_shapes {
            // The mark says that it is solid, and its shapes say where.
            let solid = match flip.of(shape) {
                TileShape::Full => Solid::Drawn,
                side => Solid::Edges(side),
            };
            Some(Verdict { rule: Rule::A, what: format!("{kind} {name}, whose collision shapes"), solid })
        } else {
            shaped(Rule::A, format!("{kind} {name} is {}", names::name(shape)), shape)
        }
    } else if senses("", &set.properties) || !has_shapes || denied(properties).is_some() {
        None
    } else {
        Some(Verdict {
            rule: Rule::B,
            what: format!("collision shapes of tileset '{}'", set.name),
            solid: Solid::Drawn,
        })
    };
    Ok(Meaning { verdict, flags })
}

/// The properties that name a shape.
const SHAPE: &str = "shape";
const NPP: &str = "npp";

/// The names by which options know a value.
pub(super) fn names_of_value(layer: &str, number: i64, name: Option<&str>) -> Vec<String> {
    let own = name.into_iter().flat_map(|name| [name.to_owned(), format!("{layer}:{name}")]);
    own.chain([number.to_string(), format!("{layer}:{number}")]).collect()
}

fn value(layer: &str, number: i64, name: Option<&str>, options: &Options) -> Meaning {
    let known = names_of_value(layer, number, name);
    let title = name.map_or_else(|| format!("value {number}"), |name| format!("value '{name}'"));
    let shaped = |rule, shape, flags| {
        let verdict = Verdict {
            rule,
            what: format!("{title} of layer '{layer}' is {}", names::name(shape)),
            solid: Solid::Shape(shape),
        };
        Meaning { verdict: Some(verdict), flags }
    };
    if let Some((_, shape)) = options.shape(&known) {
        let flags = known.iter().find(|name| options.is_flag(name)).cloned();
        return shaped(Rule::Option, shape, flags.into_iter().collect());
    }
    if let Some(flag) = known.iter().find(|name| options.is_flag(name)) {
        return Meaning { verdict: None, flags: vec![name.unwrap_or(flag).to_owned()] };
    }
    // What a value without an identifier means, its layer decides.
    let Some(name) = name else { return Meaning::default() };
    match identifier::meaning(name) {
        Some((rule, shape, flags)) => shaped(rule, shape, flags),
        None => Meaning { verdict: None, flags: vec![name.to_owned()] },
    }
}
