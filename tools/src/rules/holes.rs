//! Holes that are cut out of nothing. Their edges would block bodies from within. Some games have
//! holes of another kind, such as golf.

use std::collections::BTreeSet;

use super::kind::Kind;
use super::layers::Layers;
use super::left_out;
use super::outline::{LeftOut, Outline, Title};
use super::stood_on;
use crate::model::map::Content;

/// The most pairs of a hole and a corner of a solid. Beyond them all holes stay: each pair takes
/// time, and the linter finds the stray ones.
const MOST_PAIRS: usize = 1 << 20;

impl Layers<'_> {
    /// Takes the holes of objects away that no solid polygon surrounds, unless the property `kind`
    /// asks for them. The game gets them.
    pub(super) fn stray_holes(&mut self, outlines: &mut Vec<Outline>, left_out: &mut Vec<LeftOut>) {
        let stray = stray(outlines);
        let mut taken: BTreeSet<Title> = BTreeSet::new();
        for layer in self.all.clone() {
            let Content::Objects(objects) = &layer.content else { continue };
            for object in objects.iter().filter(|object| object.properties.text("kind").is_none()) {
                let title = Title { id: object.id, name: object.name.clone(), layer: layer.name.clone() };
                if !stray.contains(&title) {
                    continue;
                }
                let why = "it is a hole, and no solid polygon is around it";
                self.notes.push(format!("{title}: {why}, so it is for the game"));
                self.ledger.take(&format!("objects of layer '{}'", layer.name));
                left_out.push(left_out::of(object, layer, self.unit, why.to_owned()));
                taken.insert(title);
            }
        }
        outlines.retain(|outline| !taken.contains(&outline.title));
    }
}

/// The holes of objects that no solid polygon surrounds.
fn stray(outlines: &[Outline]) -> BTreeSet<Title> {
    let is_hole = |outline: &&Outline| outline.kind == Kind::Hole && outline.closed && !outline.title.is_tiles();
    let holes: Vec<&Outline> = outlines.iter().filter(is_hole).collect();
    let solids: Vec<&Outline> =
        outlines.iter().filter(|outline| outline.kind == Kind::Solid && outline.closed).collect();
    let corners: usize = solids.iter().map(|solid| solid.points.len()).sum();
    if holes.len().saturating_mul(corners) > MOST_PAIRS {
        return BTreeSet::new();
    }
    let surrounded = |hole: &Outline| {
        let places = stood_on::places(hole);
        solids.iter().any(|solid| places.iter().any(|point| stood_on::is_within(*point, solid)))
    };
    holes.iter().filter(|hole| !surrounded(hole)).map(|hole| hole.title.clone()).collect()
}
