//! What an `IntGrid` value of `LDtk` means: its own name decides, then that of its group.

use super::options::Options;
use super::report::Rule;
use super::verdict::{Meaning, Solid, Verdict};
use super::{identifier, names, words};
use crate::model::map::Placed;

/// A value of a layer.
#[derive(Clone, Copy)]
pub(super) struct Value<'a> {
    layer: &'a str,
    pub(super) number: i64,
    pub(super) name: Option<&'a str>,
    group: Option<&'a str>,
}

impl<'a> Value<'a> {
    /// The value of a palette entry, if it is one.
    pub(super) fn of(placed: &'a Placed) -> Option<Self> {
        let Placed::Value { layer, number, name, group } = placed else { return None };
        Some(Self { layer, number: *number, name: name.as_deref(), group: group.as_deref() })
    }

    /// The names by which options know it.
    pub(super) fn names(&self) -> Vec<String> {
        let named = self.name.into_iter().chain(self.group);
        let own = named.flat_map(|name| [name.to_owned(), format!("{}:{name}", self.layer)]);
        own.chain([self.number.to_string(), format!("{}:{}", self.layer, self.number)]).collect()
    }

    /// Whether it is no solid, whatever its layer is called.
    pub(super) fn is_free(&self) -> bool {
        self.name.into_iter().chain(self.group).any(words::is_free)
    }

    /// Whether a guess by these words makes it full. A layer decides about values without a name.
    pub(super) fn fits(&self, list: &[&str], layer_says: bool) -> bool {
        let by_group = || self.group.is_some_and(|group| words::has(group, list));
        match self.name {
            Some(name) => words::has(name, list) || !self.is_free() && by_group(),
            None => !self.is_free() && (layer_says || by_group()),
        }
    }

    /// What it is by all rules except the guess.
    pub(super) fn meaning(&self, options: &Options) -> Meaning {
        let known = self.names();
        let own = self.name.map_or_else(|| format!("value {}", self.number), |name| format!("value '{name}'"));
        let shaped = |rule, shape, flags, title: &str| {
            let what = format!("{title} of layer '{}' is {}", self.layer, names::name(shape));
            Meaning { verdict: Some(Verdict { rule, what, solid: Solid::Shape(shape) }), flags }
        };
        if let Some((_, shape)) = options.shape(&known) {
            let flags = known.iter().find(|name| options.is_flag(name)).cloned();
            return shaped(Rule::Option, shape, flags.into_iter().collect(), &own);
        }
        if let Some(flag) = known.iter().find(|name| options.is_flag(name)) {
            return Meaning { verdict: None, flags: vec![self.name.unwrap_or(flag).to_owned()] };
        }
        if let Some((rule, shape, flags)) = self.name.and_then(identifier::meaning) {
            return shaped(rule, shape, flags, &own);
        }
        // What a value without a name means, its group decides, or its layer.
        let flags = self.name.map(str::to_owned).into_iter().collect();
        match self.group.filter(|_| !self.is_free()).and_then(|group| Some((group, identifier::meaning(group)?))) {
            Some((group, (rule, shape, _))) => shaped(rule, shape, flags, &format!("{own} (group '{group}')")),
            None => Meaning { verdict: None, flags },
        }
    }
}
