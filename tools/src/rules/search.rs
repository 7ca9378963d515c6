//! The search for what is solid in the levels of a project. Sure names come first. Then guesses
//! count for tiles if no tile of the project is solid, and for objects if no object is.
//!
//! All levels of a project are decided together: a layer means the same in each of them. What is
//! one-way does not end the search, because bodies fall past it.

use std::collections::BTreeMap;

use super::called::{self, Guess};
use super::cells::{self, Sheet};
use super::ground::Doubt;
use super::guess;
use super::layers::Layers;
use super::names;
use super::options::Options;
use super::outline::{LeftOut, Outline};
use super::piece::Piece;
use super::place::Unit;
use super::{stood_on, unread};
use crate::model::map::{Content, Map};

type Made<T> = std::result::Result<T, String>;

/// What is known about a level so far.
pub(super) struct Search<'a> {
    pub(super) map: &'a Map,
    pub(super) layers: Layers<'a>,
    pub(super) sheets: Vec<Sheet<'a>>,
    pub(super) outlines: Vec<Outline>,
    pub(super) left_out: Vec<LeftOut>,
    pub(super) doubts: Vec<Doubt>,
    /// The side of a cell, if the levels of the project decide about it.
    pub(super) side: Option<u16>,
}

impl<'a> Search<'a> {
    /// What all rules except guesses say.
    pub(super) fn of(map: &'a Map, options: &'a Options) -> Made<Self> {
        let mut layers = Layers::new(map, options, Unit::new(options.scale))?;
        let mut sheets = Vec::new();
        for layer in layers.all.clone() {
            match &layer.content {
                // LDtk lists each layer in each level, drawn or not.
                Content::Tiles(tiles) if map.values && tiles.cells.is_empty() => {}
                Content::Tiles(tiles) => sheets.push(layers.sheet(layer, tiles)?),
                Content::Objects(_) => {}
                Content::Image => layers.ignored.push(format!("image layer '{}'", layer.name)),
            }
        }
        let mut doubts = unread::templates(map, options)?;
        doubts.extend(unread::tilesets(map, &sheets)?);
        let (outlines, left_out) = layers.objects(None)?;
        Ok(Self { map, layers, sheets, outlines, left_out, doubts, side: None })
    }

    fn has_solid_tile(&self) -> bool {
        self.sheets.iter().flat_map(|sheet| sheet.pieces.values()).any(is_solid)
    }

    fn has_solid_object(&self) -> bool {
        self.outlines.iter().any(|outline| outline.kind.is_solid())
    }

    /// Makes the layers solid whose names have one of these words.
    fn guess(&mut self, list: &[&str], (tiles, objects): (bool, bool)) -> Made<()> {
        for sheet in self.sheets.iter_mut().filter(|_| tiles) {
            self.layers.guess(sheet, list);
        }
        if objects {
            let guess = Guess::Layers { list, only_plain: !tiles };
            (self.outlines, self.left_out) = self.layers.objects(Some(guess))?;
        }
        Ok(())
    }
}

/// Guesses in the levels of a project, the surest first, as long as nothing is solid.
///
/// # Errors
///
/// One line about the object that contradicts a guess.
pub(super) fn guess(levels: &mut [Search<'_>]) -> Made<()> {
    let tiles = |levels: &[Search<'_>]| levels.iter().any(Search::has_solid_tile);
    let objects = |levels: &[Search<'_>]| levels.iter().any(Search::has_solid_object);
    let marked = tiles(levels);
    if !marked {
        for level in &mut *levels {
            level.layers.guess_by_tiles(&mut level.sheets);
        }
        let of_solids = levels.iter().find_map(|level| level.layers.of_solids(&level.outlines));
        let of_solids = of_solids.map(str::to_owned);
        for level in &mut *levels {
            level.layers.stood_on = stood_on::layers(level.map, &level.sheets, &level.layers.all);
            level.layers.lain_on(&level.sheets, &level.outlines, of_solids.as_deref());
        }
        share(levels);
    }
    for list in guess::STEPS {
        let before = (tiles(levels), objects(levels));
        if before.0 && before.1 {
            break;
        }
        for level in &mut *levels {
            level.guess(list, (!before.0, !before.1))?;
        }
        if (tiles(levels), objects(levels)) != before {
            break;
        }
    }
    // Last of all, objects whose own names say it, in layers such as `Object Layer 1`.
    for list in called::STEPS {
        if tiles(levels) || objects(levels) {
            break;
        }
        for level in &mut *levels {
            (level.outlines, level.left_out) = level.layers.objects(Some(Guess::Objects(list)))?;
        }
    }
    if tiles(levels) || objects(levels) {
        for level in levels {
            level.layers.passed_over(&level.sheets, &level.outlines, &level.left_out);
        }
    }
    Ok(())
}

/// Gives all levels of a project of `LDtk` cells of one size: each has the same layers, and rooms
/// of several sizes do not fit together. A map of Tiled has the size of its own cells.
pub(super) fn decide_cells(levels: &mut [Search<'_>]) {
    if levels.len() > 1 && levels.iter().all(|level| level.map.values) {
        let side = cells::side(levels.iter().flat_map(|level| &level.sheets));
        for level in levels {
            level.side = side;
        }
    }
}

/// A layer that bodies walk on in one level is no solid in another one.
fn share(levels: &mut [Search<'_>]) {
    let known = levels.iter().flat_map(|level| &level.layers.stood_on);
    let known: BTreeMap<String, String> = known.map(|(layer, why)| (layer.name.clone(), why.clone())).collect();
    for Search { layers, sheets, .. } in levels {
        for sheet in sheets {
            let is_new = !layers.stood_on.iter().any(|(layer, _)| std::ptr::eq(*layer, sheet.layer));
            if let Some(why) = known.get(&sheet.layer.name).filter(|_| is_new) {
                layers.stood_on.push((sheet.layer, why.clone()));
            }
        }
    }
}

/// Whether it stops bodies from more than one side.
fn is_solid(piece: &Piece) -> bool {
    match piece {
        Piece::Shape(shape) => names::is_solid(*shape),
        Piece::Cells { .. } => true,
        Piece::Paths(paths) => paths.iter().any(|path| path.kind.is_solid()),
    }
}
