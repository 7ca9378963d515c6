//! The kind of a placed tile, at any position.

use tilesat::TileShape;

use super::marked::{denied, senses};
use super::options::Options;
use super::sides::Sides;
use super::value::Value;
use super::{Rule, form, names, traits, words};
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
        Placed::Value { .. } => Ok(Value::of(placed).map(|value| value.meaning(options)).unwrap_or_default()),
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
    let by_shapes = verdict.as_ref().is_some_and(|verdict| !matches!(verdict.solid, Solid::Shape(_)));
    if by_shapes && tile.shapes.iter().any(form::is_far) {
        return Err("a collision shape is a million pixels away or wide: draw it within the tile".to_owned());
    }
    Ok(Meaning { verdict, flags })
}

/// The properties that name a shape.
const SHAPE: &str = "shape";
const NPP: &str = "npp";
