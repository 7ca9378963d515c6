//! The surface of levels of all shapes, written down from polygons, to judge the tile map's by: no sectors, no tables, no cursor.

#![allow(dead_code, reason = "each test file uses its own part")]

pub(crate) mod mosaic;
pub(crate) mod piece;
pub(crate) mod polygon;
#[path = "../oracle/random.rs"]
pub(crate) mod random;
pub(crate) mod surface;
pub(crate) mod turn;

/// The number of cases: the given one, or what the variable `TILESAT_CASES` says.
pub(crate) fn cases(default: u64) -> u64 {
    std::env::var("TILESAT_CASES").ok().and_then(|n| n.parse().ok()).unwrap_or(default)
}
