//! A level written down from the definitions, to judge the tile map by: no clamped indices, no walk, no incremental anything.

#![allow(dead_code, reason = "each test file uses its own part")]

pub(crate) mod bodies;
pub(crate) mod build;
pub(crate) mod level;
#[path = "../oracle/random.rs"]
pub(crate) mod random;
pub(crate) mod rays;

/// The number of cases: the given one, or what the variable `TILESAT_CASES` says.
pub(crate) fn cases(default: u64) -> u64 {
    std::env::var("TILESAT_CASES").ok().and_then(|n| n.parse().ok()).unwrap_or(default)
}
