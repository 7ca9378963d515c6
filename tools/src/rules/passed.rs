//! Notes about layers that a guess would have made solid, if nothing surer had been found. Whoever
//! misses them in the level reads why, and which option adds them.

use super::cells::Sheet;
use super::guess::{STEPS, is_settled};
use super::layers::Layers;
use super::objects::{self, Says};
use super::options::listed;
use super::outline::{LeftOut, Outline};
use super::report::Rule;
use super::{marked, names, words};
use crate::model::map::{Content, Layer, Placed};

impl Layers<'_> {
    /// Notes the layers whose names would have counted.
    pub(super) fn passed_over(&mut self, sheets: &[Sheet<'_>], outlines: &[Outline], left_out: &[LeftOut]) {
        // Whoever gives options has read the notes.
        if self.ledger.0.iter().any(|applied| applied.rule == Rule::Option) {
            return;
        }
        let by_mark = sheets.iter().any(|sheet| sheet.shapes.values().any(|shape| names::is_solid(*shape)));
        let any = by_mark || sheets.iter().any(|sheet| !sheet.pieces.is_empty());
        for sheet in sheets {
            let (layer, name) = (sheet.layer, &sheet.layer.name);
            let is_known =
                self.notes.iter().any(|note| note.starts_with(&format!("GUESS: layer '{name}' is not solid")));
            // The search for layers with few collision shapes has its own notes.
            let few = !by_mark && any && words::has(name, words::GUESS);
            if is_known || few || !is_named(layer) || sheet.tiles.derived || is_settled(layer, self.options) {
                continue;
            }
            let (bare, all) = self.bare(sheet);
            if bare * 2 <= all {
                continue;
            }
            let why = if is_behind(layer) {
                "its name says that it is drawn behind"
            } else if !sheet.pieces.is_empty() {
                "other tiles of it are marked"
            } else if !any {
                "tiles of other levels are"
            } else if self.ledger.0.iter().any(|applied| matches!(applied.rule, Rule::C | Rule::D)) {
                "a surer name of a layer is"
            } else {
                "tiles of other layers are marked"
            };
            self.refused(name, why, "--solid-layer");
        }
        let marked = outlines.iter().any(|outline| outline.kind.is_solid());
        for layer in self.all.clone() {
            let guessed = matches!(layer.content, Content::Objects(_)) && !self.map.values && is_named(layer);
            let unsaid = objects::layer_says(layer, self.options) == Says::Nothing;
            let has_area = |object: &&LeftOut| object.area.is_some_and(|[from, to]| from != to);
            let mut left = left_out.iter().filter(|object| object.title.layer == layer.name).filter(has_area);
            if !guessed || !unsaid || listed(&self.options.unguessed_layers, &layer.name) || left.next().is_none() {
                continue;
            }
            let why = if is_behind(layer) {
                "its name says that it is drawn behind"
            } else if marked {
                "other objects are"
            } else {
                "its objects have a name, a class, properties or a picture, as things of the game have"
            };
            self.refused(&layer.name, why, "--objects");
        }
    }

    /// The tiles of a layer that are not solid and do not say why, and all.
    fn bare(&self, sheet: &Sheet<'_>) -> (u64, u64) {
        let is_bare = |entry: u32| {
            let is_tile = matches!(self.map.palette[entry as usize], Placed::Tile { .. });
            is_tile && !sheet.pieces.contains_key(&entry) && !marked::is_free(self.map, entry, self.options)
        };
        let count = |bare: bool| {
            let counted = sheet.used.iter().filter(|(entry, _)| !bare || is_bare(*entry));
            counted.map(|(_, times)| times).sum()
        };
        (count(true), count(false))
    }
}

/// Whether a guess looks at the layer: its name has a word for a solid, and nothing denies it.
fn is_named(layer: &Layer) -> bool {
    says(layer, words::mentions) && marked::denial(layer).is_none()
}

fn is_behind(layer: &Layer) -> bool {
    !says(layer, words::has)
}

fn says(layer: &Layer, has: fn(&str, &[&str]) -> bool) -> bool {
    let mut own = [&layer.name, &layer.class].into_iter().chain(&layer.marks);
    own.any(|name| STEPS.iter().any(|list| has(name, list)))
}
