//! The progress of a long run, in a small text file from which a later run continues.

use crate::convex;
use crate::frames::{self, WORLDS};
use crate::queries::{self, ROWS, class_of, pair_of};
use std::fmt::Write;
use std::path::Path;

#[derive(Clone, Debug)]
pub struct State {
    pub seed: u64,
    pub seconds: f64,
    /// Numbers of the next batches of each row.
    pub next_queries: Vec<u64>,
    pub next_frames: Vec<u64>,
    pub next_pairs: Vec<u64>,
    /// The number of the next level, which is also the number of levels done.
    pub next_level: u64,
    pub queries: Vec<queries::Tally>,
    /// Pairs of all six shapes.
    pub pairs: Vec<queries::Tally>,
    pub frames: Vec<frames::Tally>,
    /// Frames in levels that were read from files.
    pub levels: frames::Tally,
}

/// The first line. It tells this program's counters from another's.
const HEAD: &str = "tilesat-soak 2";

impl State {
    pub fn new(seed: u64) -> Self {
        Self {
            seed,
            seconds: 0.0,
            next_queries: vec![0; ROWS],
            next_frames: vec![0; WORLDS.len()],
            next_pairs: vec![0; convex::ROWS],
            next_level: 0,
            queries: vec![queries::Tally::default(); ROWS],
            pairs: vec![queries::Tally::default(); convex::ROWS],
            frames: vec![frames::Tally::default(); WORLDS.len()],
            levels: frames::Tally::default(),
        }
    }

    pub fn answers(&self) -> u64 {
        self.queries.iter().map(|t| t.answers).sum()
    }

    pub fn all_pairs(&self) -> u64 {
        self.pairs.iter().map(|t| t.pairs).sum()
    }

    pub fn all_frames(&self) -> u64 {
        self.frames.iter().map(|t| t.frames).sum::<u64>() + self.levels.frames
    }

    fn text(&self) -> String {
        let mut out = format!("{HEAD}\nseed {}\nseconds {}\nlevel {}", self.seed, self.seconds, self.next_level);
        let line = |out: &mut String, name: &str, numbers: &[u64]| {
            let list: Vec<String> = numbers.iter().map(u64::to_string).collect();
            let _ = write!(out, "\n{name} {}", list.join(" "));
        };
        line(&mut out, "levels", &self.levels.numbers());
        for (row, tally) in self.frames.iter().enumerate() {
            line(&mut out, &format!("frames {} {}", WORLDS[row].0, self.next_frames[row]), &tally.numbers());
        }
        for (row, tally) in self.queries.iter().enumerate() {
            line(&mut out, &format!("queries {} {}", name(row), self.next_queries[row]), &tally.numbers());
        }
        for (row, tally) in self.pairs.iter().enumerate() {
            line(&mut out, &format!("pairs {} {}", convex::name(row), self.next_pairs[row]), &tally.numbers());
        }
        out.push('\n');
        out
    }

    fn parse(text: &str) -> Option<Self> {
        let mut lines = text.lines();
        let mut after = |name: &str| lines.next().and_then(|l| l.strip_prefix(name)).map(str::trim);
        after(HEAD)?;
        let mut state = Self::new(after("seed")?.parse().ok()?);
        state.seconds = after("seconds")?.parse().ok()?;
        state.next_level = after("level")?.parse().ok()?;
        let numbers = |text: &str| text.split(' ').map(|n| n.parse().ok()).collect::<Option<Vec<u64>>>();
        state.levels = frames::Tally::from(&numbers(after("levels ")?)?)?;
        for (row, world) in WORLDS.iter().enumerate() {
            let list = numbers(after(&format!("frames {} ", world.0))?)?;
            let (next, tally) = list.split_first()?;
            (state.next_frames[row], state.frames[row]) = (*next, frames::Tally::from(tally)?);
        }
        for row in 0..ROWS {
            let list = numbers(after(&format!("queries {} ", name(row)))?)?;
            let (next, tally) = list.split_first()?;
            (state.next_queries[row], state.queries[row]) = (*next, queries::Tally::from(tally)?);
        }
        for row in 0..convex::ROWS {
            let list = numbers(after(&format!("pairs {} ", convex::name(row)))?)?;
            let (next, tally) = list.split_first()?;
            (state.next_pairs[row], state.pairs[row]) = (*next, queries::Tally::from(tally)?);
        }
        Some(state)
    }

    /// The state of the file, if it has this seed. Otherwise a new one.
    pub fn load(path: &Path, seed: u64) -> Result<Self, String> {
        let text = match std::fs::read_to_string(path) {
            Ok(text) => text,
            Err(e) if e.kind() == std::io::ErrorKind::NotFound => return Ok(Self::new(seed)),
            Err(e) => return Err(format!("{}: {e}", path.display())),
        };
        let state = Self::parse(&text)
            .ok_or(format!("{}: not a state of this program; --fresh discards it", path.display()))?;
        if state.seed == seed { Ok(state) } else { Err(format!("{}: its seed is {}", path.display(), state.seed)) }
    }

    /// Writes a second file and then renames it, so that the file is never incomplete.
    pub fn save(&self, path: &Path) -> Result<(), String> {
        let fail = |e: std::io::Error| format!("{}: {e}", path.display());
        if let Some(folder) = path.parent() {
            std::fs::create_dir_all(folder).map_err(fail)?;
        }
        let new = path.with_extension("new");
        std::fs::write(&new, self.text()).map_err(fail)?;
        std::fs::rename(&new, path).map_err(fail)
    }
}

/// Such as `circle-box near`.
pub fn name(row: usize) -> String {
    let (a, b) = pair_of(row);
    format!("{a:?}-{b:?}/{}", class_of(row).0).to_lowercase()
}
