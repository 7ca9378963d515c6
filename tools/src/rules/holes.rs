//! Holes that are cut out of nothing. Their edges would block bodies from within. Some games have
//! holes of another kind, such as golf.

use super::kind::Kind;
use super::layers::Layers;
use super::left_out;
use super::outline::{LeftOut, Outline};
use super::stood_on;
use crate::model::map::{Content, Layer};
use crate::model::object::Object;

impl<'a> Layers<'a> {
    /// Takes the holes of objects away that no solid polygon surrounds, unless the property `kind`
    /// asks for them. The game gets them.
    pub(super) fn stray_holes(&mut self, outlines: &mut Vec<Outline>, left_out: &mut Vec<LeftOut>) {
        let is_hole = |outline: &&Outline| outline.kind == Kind::Hole && outline.closed && !outline.title.is_tiles();
        let solid = |outline: &&Outline| outline.kind == Kind::Solid && outline.closed;
        let surrounded = |hole: &Outline| {
            let places = stood_on::places(hole);
            let around = |solid: &Outline| places.iter().any(|point| stood_on::is_within(*point, solid));
            outlines.iter().filter(solid).any(around)
        };
        let alone = outlines.iter().filter(is_hole).filter(|hole| !surrounded(hole));
        let stray: Vec<(&'a Layer, &'a Object)> = alone.filter_map(|hole| self.drawn(hole)).collect();
        for (layer, object) in stray {
            let why = "it is a hole, and no solid polygon is around it";
            let own = left_out::of(object, layer, self.unit, why.to_owned());
            outlines.retain(|outline| outline.title != own.title);
            self.notes.push(format!("{}: {why}, so it is for the game", own.title));
            self.ledger.take(&format!("objects of layer '{}'", layer.name));
            left_out.push(own);
        }
    }

    /// The object of an outline, and its layer.
    fn drawn(&self, outline: &Outline) -> Option<(&'a Layer, &'a Object)> {
        let objects = |layer: &'a Layer| match &layer.content {
            Content::Objects(objects) => objects.as_slice(),
            Content::Tiles(_) | Content::Image => &[],
        };
        let layers = self.all.iter().copied().filter(|layer| layer.name == outline.title.layer);
        let mut all = layers.flat_map(|layer| objects(layer).iter().map(move |object| (layer, object)));
        let asks = |object: &Object| object.properties.text("kind").is_some();
        all.find(|(_, object)| object.id == outline.title.id && !asks(object))
    }
}
