//! Guesses about objects: by the names of their layers, or by their own classes and names.

use super::layers::Layers;
use super::words::{self, COLLISION, GUESS, LAST};
use crate::model::map::Layer;
use crate::model::object::Object;

/// Words in the classes and names of objects, the surest first. They count last of all.
pub(super) const STEPS: [&[&str]; 3] = [COLLISION, GUESS, LAST];

/// The most names that a note has.
const MOST: usize = 6;

/// The objects that a guess makes solid.
#[derive(Clone, Copy)]
pub(super) enum Guess<'a> {
    /// Those of layers with such a name. If tiles are solid, only the plain ones: others are things
    /// of the game that move.
    Layers { list: &'a [&'a str], only_plain: bool },
    /// Those with such a class or name, in any layer.
    Objects(&'a [&'a str]),
}

impl Guess<'_> {
    /// Whether a layer has some of these objects.
    pub(super) fn fits(&self, layer: &str, objects: &[Object]) -> bool {
        match self {
            Self::Layers { list, .. } => words::has(layer, list),
            Self::Objects(_) => objects.iter().any(|object| self.takes(object)),
        }
    }

    /// Whether an object of such a layer is one of them.
    pub(super) fn takes(&self, object: &Object) -> bool {
        match self {
            Self::Layers { only_plain, .. } => !only_plain || object.is_plain(),
            Self::Objects(list) => called(object, list).is_some(),
        }
    }
}

/// The class or the name of an object that has one of these words.
fn called<'a>(object: &'a Object, list: &[&str]) -> Option<&'a str> {
    let own = [object.class.trim(), object.name.trim()];
    own.into_iter().find(|name| words::has(name, list) && !words::is_free(name))
}

impl Layers<'_> {
    /// Notes a guess by the classes and names of objects.
    pub(super) fn guessed_objects(&mut self, layer: &Layer, objects: &[Object], list: &[&str]) {
        let mut names: Vec<&str> = objects.iter().filter_map(|object| called(object, list)).collect();
        names.sort_unstable();
        names.dedup();
        let more = if names.len() > MOST { ", .." } else { "" };
        let shown: Vec<String> = names.iter().take(MOST).map(|name| format!("'{name}'")).collect();
        let (shown, layer) = (shown.join(", ") + more, &layer.name);
        self.note(format!(
            "GUESS: nothing marks anything solid, so objects of layer '{layer}' are solid because of their classes or \
             names {shown}; the class Solid in Tiled confirms it, --no-guess '{layer}' refuses it"
        ));
    }
}
