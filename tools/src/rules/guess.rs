//! The meaning of what nothing else marks: of a level without anything solid, and of values of
//! `LDtk` without an identifier. The words in the names of layers decide. Each guess is a note with
//! the options that settle it.

use tilesat::TileShape;

use super::cells::Sheet;
use super::layers::Layers;
use super::options::{Options, listed};
use super::outline::Outline;
use super::report::Rule;
use super::value::Value;
use super::verdict::Solid;
use super::words::{self, GROUND_ABROAD, GUESS, LAST, WALLS_ABROAD};
use super::{marked, stood_on};
use crate::model::map::{Layer, Map, Placed};

/// Words in the names of layers, the surest first. The next ones count if nothing is solid so far.
pub(super) const STEPS: [&[&str]; 4] = [GUESS, LAST, WALLS_ABROAD, GROUND_ABROAD];

/// The most values that a line names.
const MOST: usize = 12;

/// Values of a layer: their numbers, and their identifiers.
pub(super) struct Values<'a> {
    layer: &'a str,
    all: Vec<(i64, Option<&'a str>)>,
}

impl<'a> Values<'a> {
    fn of(layer: &'a Layer) -> Self {
        Self { layer: &layer.name, all: Vec::new() }
    }

    /// `values 1 'grass', 2 of layer 'G'`.
    fn shown(&self) -> String {
        let name = |(number, name): &(i64, Option<&str>)| match name {
            Some(name) => format!("{number} '{name}'"),
            None => number.to_string(),
        };
        let mut names: Vec<String> = self.all.iter().take(MOST).map(name).collect();
        if self.all.len() > MOST {
            names.push(format!("{} more", self.all.len() - MOST));
        }
        let word = if self.all.len() == 1 { "value" } else { "values" };
        format!("{word} {} of layer '{}'", names.join(", "), self.layer)
    }

    /// All of them, and the verb for it.
    fn listed(all: &[Self]) -> (String, bool) {
        let one = matches!(all, [only] if only.all.len() == 1);
        (all.iter().map(Self::shown).collect::<Vec<_>>().join(", "), one)
    }

    /// The first one, as an option names it.
    fn first(&self) -> String {
        format!("{}:{}", self.layer, self.all.first().map_or(0, |(number, _)| *number))
    }
}

impl Layers<'_> {
    /// Makes the undecided tiles and values of a layer full, if its name has one of these words. Or
    /// only those values whose own names have one.
    pub(super) fn guess(&mut self, sheet: &mut Sheet<'_>, list: &[&str]) {
        let layer = sheet.layer;
        let says = [&layer.name, &layer.class].into_iter().chain(&layer.marks).any(|name| words::has(name, list));
        if sheet.tiles.derived || is_settled(layer, self.options) {
            return;
        }
        if let Some(why) = marked::denial(layer) {
            if says {
                self.note(marked::not_solid(&layer.name, &why));
            }
            return;
        }
        if let Some((_, why)) = self.stood_on.iter().find(|(ground, _)| std::ptr::eq(*ground, layer)) {
            if says {
                let why = why.clone();
                self.refused(&layer.name, &why, "--solid-layer");
            }
            return;
        }
        let (mut count, mut values) = (0, Values::of(layer));
        for (entry, times) in sheet.used.clone() {
            if sheet.pieces.contains_key(&entry) {
                continue;
            }
            if let Some(value) = Value::of(&self.map.palette[entry as usize]) {
                if !value.fits(list, says) || value.names().iter().any(|name| self.options.is_flag(name)) {
                    continue;
                }
                values.all.push((value.number, value.name));
            } else if !says || marked::is_free(self.map, entry, self.options) {
                continue;
            }
            count += times;
            self.put(sheet, entry, Solid::Shape(TileShape::Full));
        }
        if count == 0 {
            return;
        }
        self.ledger.add(Rule::D, &format!("layer '{}' is full", layer.name), count);
        if !says {
            self.assumed(&values, "full", if values.all.len() == 1 { "its name" } else { "their names" });
        } else if values.all.is_empty() {
            self.guessed("tiles", &layer.name, "--solid-layer");
        } else {
            self.assumed(&values, "full", "the layer's name");
        }
    }

    /// Notes the layers whose names say that they are solid, and most of whose tiles have no
    /// collision shape, if only such shapes make anything solid. Some authors draw them for ramps
    /// only. So tiles of platforms are full if bodies would fall through most of the surface.
    pub(super) fn forgotten(&mut self, sheets: &mut [Sheet<'_>], outlines: &[Outline]) {
        let solid = |sheet: &Sheet<'_>| sheet.shapes.values().any(|shape| super::names::is_solid(*shape));
        if sheets.iter().any(solid) || sheets.iter().all(|sheet| sheet.pieces.is_empty()) {
            return;
        }
        let (unit, points) = (self.unit, stood_on::points(outlines));
        for sheet in sheets.iter_mut().filter(|sheet| !stood_on::lies(&points, sheet, unit)) {
            let (name, cells, width) = (&sheet.layer.name, &sheet.tiles.cells, sheet.tiles.width as usize);
            let is_bare = |entry: &u32| !sheet.pieces.contains_key(entry) && !sheet.flags.contains_key(entry);
            let bare: Vec<(u32, u64)> = sheet.used.iter().copied().filter(|(entry, _)| is_bare(entry)).collect();
            let count = |used: &[(u32, u64)]| used.iter().map(|(_, times)| times).sum::<u64>();
            let most = count(&bare) * 2 > count(&sheet.used);
            let open = !sheet.tiles.derived && !is_settled(sheet.layer, self.options);
            if !most || !words::has(name, GUESS) || !open || marked::denial(sheet.layer).is_some() {
                continue;
            }
            let what = format!("{} of layer '{name}'", words::several(count(&bare) as usize, "tile"));
            let surface = (0..cells.len()).filter(|&at| cells[at] != 0 && (at < width || cells[at - width] == 0));
            let (open, shaped): (Vec<_>, Vec<_>) = surface.partition(|&at| is_bare(&cells[at]));
            if !words::has(name, &["platform"]) || open.len() <= shaped.len() {
                self.note(format!(
                    "GUESS: {what} are not solid: they have no collision shape, and other tiles have; \
                     --solid-layer '{name}' makes them full"
                ));
                continue;
            }
            self.ledger.add(Rule::D, &format!("layer '{name}' is full"), count(&bare));
            self.note(format!(
                "GUESS: {what} are full, but have no collision shape; --no-guess '{name}' refuses it, and --empty TILESET:ID \
                 refuses one tile"
            ));
            for (entry, _) in bare {
                self.put(sheet, entry, Solid::Shape(TileShape::Full));
            }
        }
    }

    /// Notes a guess by the name of a layer.
    pub(super) fn guessed(&mut self, what: &str, layer: &str, option: &str) {
        self.note(format!(
            "GUESS: nothing marks solid {what}, so layer '{layer}' is solid because of its name; {option} '{layer}' \
             confirms it, --ignore-layer '{layer}' refuses it"
        ));
    }

    /// Notes that a layer is not solid, although its name has a word of a guess.
    pub(super) fn refused(&mut self, layer: &str, why: &str, option: &str) {
        self.note(format!("GUESS: layer '{layer}' is not solid, because {why}; {option} '{layer}' makes it solid"));
    }

    /// Notes the values that have this shape because of a name.
    fn assumed(&mut self, values: &Values<'_>, shape: &str, whose: &str) {
        let (shown, first) = (values.shown(), values.first());
        let are = if values.all.len() == 1 { "is" } else { "are" };
        let option = if shape == "full" { "solid" } else { "one-way" };
        self.note(format!(
            "GUESS: {shown} {are} {shape} because of {whose}; --{option} '{first}' confirms it, --empty '{first}' refuses it"
        ));
    }

    /// A layer of `LDtk` with tiles over each other is several layers here, of one note.
    pub(super) fn note(&mut self, note: String) {
        if !self.notes.contains(&note) {
            self.notes.push(note);
        }
    }

    /// Notes the values that have a shape because of the name of their layer.
    pub(super) fn assume(&mut self, sheet: &Sheet<'_>, entries: &[u32], shape: &str) {
        let mut values = Values::of(sheet.layer);
        for entry in entries {
            if let Placed::Value { number, name, .. } = &self.map.palette[*entry as usize] {
                values.all.push((*number, name.as_deref()));
            }
        }
        if !values.all.is_empty() {
            self.assumed(&values, shape, "the layer's name");
        }
    }

    /// Notes the values that are empty because they have no identifier and other things are solid.
    pub(super) fn undecided(&mut self, sheets: &[Sheet<'_>]) {
        let all = undecided(self.map, sheets, self.options);
        if let Some(first) = all.first().map(Values::first) {
            let (shown, one) = Values::listed(&all);
            let (have, are) = if one { ("has", "is") } else { ("have", "are") };
            self.note(format!(
                "GUESS: {shown} {have} no identifier, and {are} empty because other things are solid; --solid '{first}' makes it full"
            ));
        }
    }
}

/// The drawn values without an identifier that no option and no rule decides.
fn undecided<'a>(map: &'a Map, sheets: &[Sheet<'a>], options: &Options) -> Vec<Values<'a>> {
    let of_sheet = |sheet: &Sheet<'a>| {
        let mut values = Values::of(sheet.layer);
        for (entry, _) in &sheet.used {
            let is_decided = sheet.pieces.contains_key(entry) || sheet.flags.contains_key(entry);
            let value = Value::of(&map.palette[*entry as usize]).filter(|value| value.name.is_none() && !is_decided);
            values.all.extend(value.filter(|value| !value.is_free()).map(|value| (value.number, None)));
        }
        values
    };
    let sheets = sheets.iter().filter(|sheet| !is_skipped(sheet.layer, options));
    sheets.map(of_sheet).filter(|values| !values.all.is_empty()).collect()
}

/// The advice about values without an identifier, if nothing is solid.
pub(super) fn advice(map: &Map, sheets: &[Sheet<'_>], options: &Options) -> Option<String> {
    let all = undecided(map, sheets, options);
    let first = all.first()?.first();
    let (shown, one) = Values::listed(&all);
    let (have, them) = if one { ("has", "it") } else { ("have", "them") };
    Some(format!(
        "{shown} {have} no identifier: name {them} in LDtk, or add --solid {first}, --one-way {first}, --flag {first} or --empty {first}"
    ))
}

/// Whether the user allows no guess about a layer.
pub(super) fn is_settled(layer: &Layer, options: &Options) -> bool {
    is_skipped(layer, options) || listed(&options.unguessed_layers, &layer.name)
}

/// Whether the user looks for solids in another layer only.
pub(super) fn is_skipped(layer: &Layer, options: &Options) -> bool {
    options.layer.as_ref().is_some_and(|name| *name != layer.name)
}
