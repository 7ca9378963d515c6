//! Bakes the levels of a project together, with one table of tile kinds and one list of flags.

use std::collections::HashSet;
use std::path::{Path, PathBuf};

use tilesat::{Fx, TileKind, TileKinds};

use super::level::{Ids, Level};
use super::segments::{self, Shapes};
use super::{Baked, source};
use crate::fail::{Fail, Result};
use crate::model::map::{Content, Map};
use crate::rules::flags::Flags;
use crate::rules::ground::{Drawn, Ground};
use crate::rules::kind::Kind;
use crate::rules::options::{Options, listed, together};
use crate::rules::outline::Outline;
use crate::rules::union;

/// The settings that do not come from a project.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Settings {
    /// The solid.
    pub options: Options,
    /// Side of the cells that index objects. By default, that of a tile.
    pub cell: Option<Fx>,
}

/// Baked levels.
#[derive(Debug, Clone)]
pub struct Bundle {
    pub levels: Vec<Baked>,
    /// The meaning of the ids of all levels.
    pub kinds: Vec<TileKind>,
    /// The name of each flag bit, bit 0 first.
    pub flags: Vec<String>,
    /// Flags beyond the eight that stay.
    pub dropped: Vec<String>,
    /// What the authors probably did not intend, of all levels together.
    pub warnings: Vec<String>,
}

/// Bakes levels, the tiles and the objects of each.
///
/// # Errors
///
/// If nothing is solid in any level. Otherwise one line names the layer or object that the library
/// refuses, and the reason.
pub fn bake(maps: &[Map], settings: &Settings) -> Result<Bundle> {
    let is_solid = |bundle: &Bundle| bundle.levels.iter().any(Baked::is_solid);
    let count = maps.iter().filter(|map| !listed(&settings.options.ignored_levels, &map.name)).count();
    let bundle = together(count, &settings.options, |options| all(maps, options, settings.cell), is_solid)?;
    if !settings.options.bare && !is_solid(&bundle) {
        return Err(Fail::new("nothing is solid: nothing is drawn"));
    }
    Ok(bundle)
}

fn all(maps: &[Map], options: &Options, cell: Option<Fx>) -> Result<Bundle> {
    let mut flags = Flags::new(&options.flags).map_err(Fail::new)?;
    let mut ids = Ids::default();
    let mut levels = Vec::new();
    let of_level = |map: &Map, fail: Fail| fail.of_level(&map.name, maps.len() > 1);
    let baked: Vec<&Map> = maps.iter().filter(|map| !listed(&options.ignored_levels, &map.name)).collect();
    for (map, drawn) in baked.iter().zip(Drawn::all(&baked, options, of_level)?) {
        let ground = drawn.ground(&mut flags).map_err(|fail| of_level(map, fail))?;
        levels.push(level(map, ground, cell, (&mut flags, &mut ids)).map_err(|fail| of_level(map, fail))?);
    }
    if levels.is_empty() {
        return Err(Fail::new("every level is skipped: remove an --ignore-level"));
    }
    let table = (0..=u8::MAX).zip(ids.kinds()).fold(TileKinds::EMPTY, |table, (id, kind)| table.with(id, *kind));
    for baked in &mut levels {
        baked.kinds = table;
        baked.flags.clone_from(&flags.names);
        if let Some(tiles) = &mut baked.tiles {
            tiles.ids = ids.kinds().to_vec();
            tiles.flags.clone_from(&flags.names);
        }
    }
    let warnings = flags.warning().into_iter().collect();
    Ok(Bundle { levels, kinds: ids.kinds().to_vec(), flags: flags.names, dropped: flags.dropped, warnings })
}

fn level(map: &Map, mut ground: Ground, cell: Option<Fx>, (flags, ids): (&mut Flags, &mut Ids)) -> Result<Baked> {
    let repeated = segments::once(&mut ground.outlines);
    segments::refuse_crossed(&ground.outlines)?;
    let tiles = Level::with(&ground, &flags.names, ids)?;
    let mut objects = None;
    ground.notes.extend(repeated);
    let hidden = hidden(map, &ground.outlines);
    ground.notes.extend(hidden);
    if !ground.outlines.is_empty() {
        let outlines = distinct(&ground.outlines);
        let twice = ground.outlines.len() - outlines.len();
        if twice > 0 {
            ground.notes.push(format!("{twice} polygons are skipped: each repeats another one"));
        }
        if pile(&outlines) > segments::MOST_PILED {
            return Err(Fail::new(segments::piled(&outlines)));
        }
        let shapes = Shapes::of(&outlines, flags)?;
        let cell = cell.unwrap_or_else(|| shapes.cell(ground.tile));
        let bytes = shapes.build(&outlines, cell)?;
        objects = Some((shapes, bytes, cell));
    }
    // The level's tiles now hold them as one byte each instead of two.
    ground.cells = Vec::new();
    Ok(Baked { ground, tiles, kinds: TileKinds::EMPTY, objects, flags: Vec::new() })
}

/// A note about the solid objects of each layer that the editor does not show.
fn hidden(map: &Map, outlines: &[Outline]) -> Vec<String> {
    const MOST_NAMED: usize = 5;
    let solid: HashSet<(&str, u32)> =
        outlines.iter().map(|outline| (outline.title.layer.as_str(), outline.title.id)).collect();
    let mut notes = Vec::new();
    for layer in &map.layers {
        let Content::Objects(objects) = &layer.content else { continue };
        let hidden = objects.iter().filter(|object| object.hidden && solid.contains(&(layer.name.as_str(), object.id)));
        let mut titles: Vec<String> = hidden
            .map(|object| match object.name.as_str() {
                "" => format!("object {}", object.id),
                name => format!("object {} '{name}'", object.id),
            })
            .collect();
        let (count, is) = (titles.len(), if titles.len() == 1 { "object" } else { "objects" });
        if count > MOST_NAMED {
            titles.truncate(MOST_NAMED);
            titles.push(format!("{} more", count - MOST_NAMED));
        }
        if count > 0 {
            notes.push(format!(
                "{count} {is} of layer '{}' {} hidden, and solid all the same: {}; delete what should not be solid",
                layer.name,
                if count == 1 { "is" } else { "are" },
                titles.join(", ")
            ));
        }
    }
    notes
}

/// Removes outlines without polygons that repeat another one.
fn distinct(outlines: &[Outline]) -> Vec<Outline> {
    let mut seen = HashSet::new();
    let mut kept = Vec::new();
    for outline in outlines {
        let key = (outline.kind, outline.points.as_slice(), outline.flags.as_slice());
        if !outline.kind.has_area() || seen.insert(key) {
            kept.push(outline.clone());
        }
    }
    kept
}

/// The greatest number of solids that share a border at one point of a line. The library would have
/// to compare all of them.
fn pile(outlines: &[Outline]) -> u32 {
    let solid = outlines.iter().filter(|outline| outline.kind == Kind::Solid && outline.closed);
    union::depth(&solid.map(|outline| outline.points.clone()).collect::<Vec<_>>())
}

impl Bundle {
    /// Rust source. For one level: its constants and statics. For several: a module each, and a
    /// table for all.
    pub fn source(&self) -> String {
        source::source(self)
    }

    /// The same for `include!` within a module. A build script writes it to `OUT_DIR`.
    pub fn items(&self) -> String {
        source::items(self)
    }

    /// The files for this path: source, or bytes and the source that describes them.
    pub fn files(&self, out: &Path, as_source: bool) -> Vec<(PathBuf, Vec<u8>)> {
        if as_source {
            return vec![(out.to_owned(), self.source().into_bytes())];
        }
        let mut files = Vec::new();
        for (level, place) in self.levels.iter().zip(self.places(out, "bin")) {
            let tiles = level.tiles.as_ref().map(|level| level.tiles.clone());
            let segments = level.objects.as_ref().map(|(_, bytes, _)| bytes.clone());
            let both = tiles.is_some() && segments.is_some();
            let named = |what: &str| if both { place.with_extension(format!("{what}.bin")) } else { place.clone() };
            let (at_tiles, at_segments) = (named("tiles"), named("segments"));
            let name = |path: &Path| path.file_name().unwrap_or_default().to_string_lossy().into_owned();
            let beside = source::beside(self, level, name(&at_tiles), name(&at_segments));
            files.extend(tiles.map(|bytes| (at_tiles, bytes)));
            files.extend(segments.map(|bytes| (at_segments, bytes)));
            files.push((place.with_extension("bin.rs"), beside.into_bytes()));
        }
        files
    }

    /// A path for each level: the output's, or one of several with their names.
    pub fn places(&self, out: &Path, extension: &str) -> Vec<PathBuf> {
        if self.levels.len() == 1 {
            return vec![out.to_owned()];
        }
        source::modules(self).iter().map(|module| out.with_extension(format!("{module}.{extension}"))).collect()
    }
}
