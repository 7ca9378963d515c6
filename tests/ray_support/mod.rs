//! Rays against levels of every shape, from the definitions: independent tables, exact numbers of any size, no walk.

#![allow(dead_code, reason = "each test file uses its own part")]

pub(crate) mod cast;
pub(crate) mod level;
pub(crate) mod moment;
#[path = "../oracle/random.rs"]
pub(crate) mod random;
pub(crate) mod rays;
pub(crate) mod solid;

/// The number of cases: the given one, or what the variable `TILESAT_CASES` says.
pub(crate) fn cases(default: u64) -> u64 {
    std::env::var("TILESAT_CASES").ok().and_then(|n| n.parse().ok()).unwrap_or(default)
}
