//! The invariants P1 to P27 as properties: scenes that shrink, and scenes of the classes in which collision code goes wrong.
//!
//! The names of the tests are those of the invariants; `../README.md` has the list. Seeds are fixed, so a run is the same everywhere. `TILESAT_CASES`
//! sets the number of cases of each pair property (default 4000; the others take a part of it). What has failed once is kept in the files
//! `*.regressions` beside the sources, and is asked again first.

#![cfg(not(target_os = "none"))]
#![allow(clippy::indexing_slicing, clippy::unwrap_used, clippy::panic, reason = "tests stop at the first surprise")]
#![allow(clippy::duplicate_mod, reason = "judges that share their random numbers")]

#[path = "../cast_support/mod.rs"]
mod cast_support;
#[path = "../motion_shape_support/mod.rs"]
mod motion_shape_support;
#[path = "../oracle/mod.rs"]
mod oracle;
#[path = "../oracle/rational.rs"]
mod rational;
#[path = "../segment_support/mod.rs"]
mod segment_support;
#[path = "../torture_support/mod.rs"]
mod torture_support;

mod casts;
mod copies;
mod floors;
mod motion;
mod pairs;
mod scenes;
mod views;
mod walks;

use proptest::prelude::ProptestConfig;
use proptest::test_runner::{FileFailurePersistence, RngSeed};

/// A part of the number of cases that is asked for.
pub(crate) fn config(divisor: u32) -> ProptestConfig {
    let all: u32 = std::env::var("TILESAT_CASES").ok().and_then(|n| n.parse().ok()).unwrap_or(4000);
    ProptestConfig {
        cases: (all / divisor).max(1),
        rng_seed: RngSeed::Fixed(27),
        failure_persistence: Some(Box::new(FileFailurePersistence::WithSource("regressions"))),
        ..ProptestConfig::default()
    }
}
