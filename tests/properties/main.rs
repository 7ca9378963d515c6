//! The invariants P1 to P27 as properties: scenes that shrink, and scenes of the hard classes.
//!
//! The tests have the names of the invariants, which `../README.md` lists. Seeds are fixed, so a
//! run is the same everywhere. `TILESAT_CASES` sets the number of cases of each pair property
//! (default 4000; the others take a part of it). The files `*.regressions` beside the sources keep
//! earlier failures, and those run first.

#![cfg(not(target_os = "none"))]

mod casts;
mod conformance;
mod copies;
mod floors;
mod layers;
mod motion;
mod pairs;
mod scenes;
mod views;
mod walks;

use proptest::prelude::ProptestConfig;
use proptest::test_runner::{FileFailurePersistence, RngSeed};
use tilesat_judge::cases;

/// A part of the required number of cases.
pub(crate) fn config(divisor: u32) -> ProptestConfig {
    ProptestConfig {
        cases: (cases(4000) / divisor).max(1),
        rng_seed: RngSeed::Fixed(27),
        failure_persistence: Some(Box::new(FileFailurePersistence::WithSource("regressions"))),
        ..ProptestConfig::default()
    }
}
