//! The checks of every input that the fuzzer makes. The judges of the crate's tests check the
//! contract.
//!
//! Each target is a function of bytes that panics if the library is wrong. The programs in
//! `fuzz_targets` pass it to libFuzzer. The program `replay` runs the committed corpus on any
//! toolchain.

mod accepted;
mod bodies;
mod convex;
mod files;
mod levels;
mod motion;
mod pairs;
mod ride;

type Target = fn(&[u8]);

/// All targets, by name.
pub const TARGETS: [(&str, Target); 22] = [
    ("overlap", pairs::overlap),
    ("contact", pairs::contact),
    ("distance", pairs::distance),
    ("cast_shape", pairs::cast_shape),
    ("cast_ray", pairs::cast_ray),
    ("tiles", levels::tiles),
    ("tile_shapes", levels::tile_shapes),
    ("tile_rays", levels::tile_rays),
    ("segments", levels::segments),
    ("segment_rays", levels::segment_rays),
    ("segment_bytes", files::segment_bytes),
    ("move_blocks", motion::blocks),
    ("move_shapes", motion::shapes),
    ("move_segments", motion::segments),
    ("convex_pairs", convex::pairs),
    ("convex_moves", convex::moves),
    ("turns", convex::turns),
    ("ride", ride::ride),
    ("broad", bodies::broad),
    ("scene", bodies::scene),
    ("tmx", files::tmx),
    ("ldtk", files::ldtk),
];

/// Runs a target on one input.
///
/// # Panics
///
/// If the library breaks its contract, or there is no such target.
pub fn check(target: &str, data: &[u8]) {
    let (_, run) = TARGETS.iter().find(|(name, _)| *name == target).expect("a target of this name");
    run(data);
}
