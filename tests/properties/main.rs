//! The invariants P1 to P27 as properties: scenes that shrink, and scenes of the classes in which
//! collision code goes wrong.
//!
//! The names of the tests are those of the invariants; `../README.md` has the list. Seeds are
//! fixed, so a run is the same everywhere. `TILESAT_CASES` sets the number of cases of each pair
//! property (default 4000; the others take a part of it). What has failed once is kept in the files
//! `*.regressions` beside the sources, and is asked again first.

#![cfg(not(target_os = "none"))]

mod casts;
mod conformance;
mod copies;
mod floors;
mod golden;
mod layers;
mod motion;
mod pairs;
mod scenes;
mod views;
mod walks;

use proptest::prelude::ProptestConfig;
use proptest::test_runner::{FileFailurePersistence, RngSeed};
use tilesat_judge::cases;

/// A part of the number of cases that is asked for.
pub(crate) fn config(divisor: u32) -> ProptestConfig {
    ProptestConfig {
        cases: (cases(4000) / divisor).max(1),
        rng_seed: RngSeed::Fixed(27),
        failure_persistence: Some(Box::new(FileFailurePersistence::WithSource("regressions"))),
        ..ProptestConfig::default()
    }
}
