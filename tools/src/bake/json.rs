//! A baked level as one line of JSON, for programs.

use std::collections::BTreeMap;

use serde::{Serialize, Serializer};
use tilesat::{TileKinds, TileShape};

use super::{Baked, things};
use crate::fail::{Fail, Result};
use crate::rules::names;
use crate::rules::outline::LeftOut;

#[derive(Serialize)]
struct Line<'a> {
    level: &'a str,
    cell: u16,
    width: u16,
    height: u16,
    solid: u64,
    one_way: u64,
    shapes: BTreeMap<String, u64>,
    segments: u16,
    /// Tiles of each flag, bit 0 first.
    #[serde(serialize_with = "in_order")]
    flags: Vec<(&'a str, u64)>,
    rules: Vec<Used<'a>>,
    ignored: Vec<String>,
    unused: Vec<String>,
    warnings: Vec<String>,
    notes: &'a [String],
    /// Those for the game.
    objects: Vec<things::Thing<'a>>,
    flash_bytes: usize,
}

#[derive(Serialize)]
struct Used<'a> {
    rule: String,
    what: &'a str,
    tiles: u64,
}

fn told(object: &LeftOut) -> String {
    format!("{}: {}", object.title, object.why)
}

fn in_order<S: Serializer>(flags: &[(&str, u64)], to: S) -> std::result::Result<S::Ok, S::Error> {
    to.collect_map(flags.iter().copied())
}

impl Baked {
    /// The level in one line: its solid, and the rules that found it.
    ///
    /// # Errors
    ///
    /// The same as [`segments`](Self::segments).
    pub fn json(&self) -> Result<String> {
        let mut by_id = [0u64; 256];
        for &id in self.tiles.iter().flat_map(|level| &level.tiles) {
            by_id[usize::from(id)] += 1;
        }
        let mut line = Line {
            level: &self.ground.name,
            cell: self.ground.tile,
            width: self.ground.width,
            height: self.ground.height,
            solid: 0,
            one_way: 0,
            shapes: BTreeMap::new(),
            segments: self.segments()?.map_or(0, |map| map.count()),
            flags: self.flags.iter().map(|name| (name.as_str(), 0)).collect(),
            rules: Vec::new(),
            ignored: self.ignored(),
            unused: self.lost(),
            warnings: self.warnings(),
            notes: &self.ground.notes,
            objects: things::things(&self.ground.left_out),
            flash_bytes: self.flash(),
        };
        let kinds = self.tiles.iter().flat_map(|level| &level.ids);
        for (kind, count) in kinds.zip(by_id).filter(|(_, count)| *count > 0) {
            if kind.shape != TileShape::Empty {
                *line.shapes.entry(names::name(kind.shape)).or_default() += count;
                let slot = if names::is_solid(kind.shape) { &mut line.solid } else { &mut line.one_way };
                *slot += count;
            }
            for (bit, (_, tiles)) in line.flags.iter_mut().enumerate() {
                *tiles += count * u64::from(kind.flags >> bit & 1);
            }
        }
        let used = self.ground.applied.iter();
        line.rules =
            used.map(|used| Used { rule: used.rule.to_string(), what: &used.what, tiles: used.tiles }).collect();
        serde_json::to_string(&line).map_err(|e| Fail::new(e.to_string()))
    }

    /// Drawings that are not part of the level.
    pub fn ignored(&self) -> Vec<String> {
        self.left_out(|_| true)
    }

    /// The same, of the objects these.
    fn left_out(&self, wanted: impl Fn(&LeftOut) -> bool) -> Vec<String> {
        let objects = self.ground.left_out.iter().filter(|object| wanted(object)).map(told);
        self.ground.ignored.iter().cloned().chain(objects).collect()
    }

    /// The objects that are not solid and are in `OBJECTS`.
    pub fn listed(&self) -> Vec<String> {
        self.ground.left_out.iter().filter(|object| object.is_listed()).map(told).collect()
    }

    /// What the author probably did not intend: a line each.
    pub fn warnings(&self) -> Vec<String> {
        self.ground.warnings()
    }

    /// What a build script reports: what the author probably did not intend, and what is in no
    /// output. Images and skipped layers are no surprise.
    pub(crate) fn surprises(&self) -> Vec<String> {
        let objects = self.ground.left_out.iter().filter(|object| !object.is_listed() && !object.suspicious).map(told);
        let guesses = self.ground.notes.iter().filter(|note| note.starts_with("GUESS")).cloned();
        let lost = things::lost(&self.ground.left_out);
        self.warnings().into_iter().chain(objects).chain(lost).chain(guesses).collect()
    }

    /// Drawings and settings that are in no output.
    pub fn unused(&self) -> Vec<String> {
        let silent = self.left_out(|object| !object.is_listed() && !object.suspicious);
        silent.into_iter().chain(self.lost()).collect()
    }

    /// What the author has set, and no output holds.
    fn lost(&self) -> Vec<String> {
        let lost = things::lost(&self.ground.left_out);
        lost.into_iter().chain(self.ground.unused.iter().cloned()).collect()
    }

    /// Bytes of tiles, of the table of kinds and of segments.
    fn flash(&self) -> usize {
        let tiles = self.tiles.as_ref().map_or(0, |level| level.tiles.len() + size_of::<TileKinds>());
        tiles + self.objects.as_ref().map_or(0, |(_, bytes, _)| bytes.len())
    }
}
