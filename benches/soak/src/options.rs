//! The command line.

use std::path::PathBuf;

#[derive(Clone, Debug)]
pub struct Options {
    pub frames: u64,
    pub queries: u64,
    pub levels: u64,
    /// The cases of each pair of all six shapes.
    pub pairs: u64,
    /// Frames of each rest. Zero: no such run.
    pub rest: u64,
    /// The list of [`lattice`](crate::lattice) to run.
    pub lattice: Option<String>,
    pub minutes: u64,
    pub threads: u64,
    pub seed: u64,
    pub state: PathBuf,
    pub fresh: bool,
    /// Parts of the names of the classes to run. Empty: all classes.
    pub classes: Vec<String>,
}

const USAGE: &str = "\
usage: cargo run --profile checked -p tilesat-soak -- [OPTION]...
  --frames N    all frames of motion, with earlier runs; default 1000000000
  --queries N   all answers of pairs and casts; default 10000000000
  --levels N    all random TMX levels; default 10000
  --pairs N     all pairs of each two of the six shapes; default 10000000
  --minutes M   stop after M minutes; default 0: run to the end
  --threads T   default 2
  --seed S      default 1; another seed is another run with a separate state
  --class TEXT  only classes whose name contains this (repeatable)
  --state FILE  file of the counters; default soak/state-SEED.txt in the target directory
  --fresh       forget the state
  --list        the names of the classes
  --lattice NAME  instead: all pairs of polygons of a lattice, such as quads5
  --rest N        instead: N frames of each body and pile at rest
You can write numbers as 1e9. A run continues from the state file, and exits with 1 on the first wrong answer.";

fn number(text: &str) -> Option<u64> {
    match text.split_once('e') {
        None => text.parse().ok(),
        Some((digits, power)) => digits.parse::<u64>().ok()?.checked_mul(10u64.checked_pow(power.parse().ok()?)?),
    }
}

/// The options, or the message to print instead. `None` stands for the list of names.
pub fn parse(mut words: impl Iterator<Item = String>) -> Result<Option<Options>, String> {
    let mut state = None;
    let mut o = Options {
        frames: 1_000_000_000,
        queries: 10_000_000_000,
        levels: 10_000,
        pairs: 10_000_000,
        rest: 0,
        lattice: None,
        minutes: 0,
        threads: 2,
        seed: 1,
        state: PathBuf::new(),
        fresh: false,
        classes: Vec::new(),
    };
    while let Some(word) = words.next() {
        if word == "--list" {
            return Ok(None);
        }
        if word == "--fresh" {
            o.fresh = true;
            continue;
        }
        let value = words.next().ok_or_else(|| format!("{word}: unknown option, or its value is missing\n{USAGE}"))?;
        let count = || number(&value).ok_or_else(|| format!("{word} {value}: not a number"));
        match word.as_str() {
            "--frames" => o.frames = count()?,
            "--queries" => o.queries = count()?,
            "--levels" => o.levels = count()?,
            "--pairs" => o.pairs = count()?,
            "--rest" => o.rest = count()?,
            "--lattice" => o.lattice = Some(value),
            "--minutes" => o.minutes = count()?,
            "--threads" => o.threads = count()?.max(1),
            "--seed" => o.seed = count()?,
            "--class" => o.classes.push(value),
            "--state" => state = Some(PathBuf::from(value)),
            _ => return Err(USAGE.into()),
        }
    }
    let file = format!("soak/state-{}.txt", o.seed);
    o.state = state.unwrap_or_else(|| target().join(file));
    Ok(Some(o))
}

/// The build's own directory.
pub fn target() -> PathBuf {
    let own = || PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../target"));
    std::env::var_os("CARGO_TARGET_DIR").map_or_else(own, PathBuf::from)
}
