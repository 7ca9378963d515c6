//! Levels of line segments and what must hold for them, from the definitions: all pairs, no walks, no tables.

#![allow(dead_code, reason = "each test file uses its own part")]

pub(crate) mod generate;
pub(crate) mod level;
pub(crate) mod oracle;
#[path = "../oracle/random.rs"]
pub(crate) mod random;
pub(crate) mod vertices;

/// The number of cases: the given one, or what the variable `TILESAT_CASES` says.
pub(crate) fn cases(default: u64) -> u64 {
    std::env::var("TILESAT_CASES").ok().and_then(|n| n.parse().ok()).unwrap_or(default)
}
