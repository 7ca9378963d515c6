//! Exact judges and generators of scenes, for the tests and the benchmarks.
//!
//! The judges share no code with the library. Each computes from the definitions, in wide enough
//! integers.

pub mod blocks;
pub mod broad;
pub mod broad_twin;
pub mod casts;
pub mod convex;
pub mod drawing;
pub mod ground;
pub mod levels_cast;
pub mod motion;
pub mod oracle;
pub mod paths;
pub mod plain;
pub mod random;
pub mod rays;
pub mod rooms;
pub mod scenes;
pub mod segments;
pub mod shapes;
pub mod solids;
pub mod surface;

pub use random::Random;
use std::str::FromStr;
pub use {num_bigint, num_rational};

/// The number of cases of a test: the variable `TILESAT_CASES`, or else `default`.
pub fn cases<N: FromStr>(default: N) -> N {
    given("TILESAT_CASES", default)
}

/// The number `short`, or `long` if the variable `TILESAT_LONG` is set. For tests that take longer
/// than a second or two with all of their cases.
pub fn thorough<N>(short: N, long: N) -> N {
    if std::env::var_os("TILESAT_LONG").is_some() { long } else { short }
}

/// Whether a statement about many cases holds, in runs of many. Interpreters run too few
/// (`.ci/miri`).
pub fn enough(holds: bool) -> bool {
    holds || cases(100) < 100
}

/// The number of frames of a run: the variable `TILESAT_FRAMES`, or else `default`.
pub fn frames<N: FromStr>(default: N) -> N {
    given("TILESAT_FRAMES", default)
}

/// The greatest common divisor, not negative.
pub fn gcd(a: i64, b: i64) -> i64 {
    if b == 0 { a.abs() } else { gcd(b, a % b) }
}

fn given<N: FromStr>(name: &str, default: N) -> N {
    std::env::var(name).ok().and_then(|n| n.parse().ok()).unwrap_or(default)
}
