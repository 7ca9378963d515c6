//! All families, in groups.

use super::family::Run;
#[cfg(not(target_os = "none"))]
use super::games;
use super::{bodies, convex, motion, ninja, numbers, pairs, responses, scene_hero, scenes, worlds};

/// Families of some kinds.
pub type Part = fn(&mut Run<'_>);

// Groups that fit the flash of a small chip, even without optimisation.
pub const SHAPES: &[Part] = &[numbers::run, pairs::run, responses::run];
pub const BODIES: &[Part] = &[bodies::run];
pub const SCENES: &[Part] = &[scenes::run];
pub const PILLS: &[Part] = &[scenes::run_capsules];
pub const SCENE_HERO: &[Part] = &[scene_hero::run];
pub const LEVELS: &[Part] = &[worlds::run_tiles, worlds::run_blocks, worlds::run_slopes, worlds::run_shapes];
pub const SEGMENTS: &[Part] = &[worlds::run_segments, motion::run_segments];
pub const JOINED: &[Part] = &[worlds::run_joined];
pub const MOVING: &[Part] = &[worlds::run_moving];
pub const BLOCKS: &[Part] = &[motion::run_blocks];
pub const MOTION: &[Part] = &[motion::run_shapes];
pub const CAPSULES: &[Part] = &[motion::run_capsules];
pub const TURNED: &[Part] = &[motion::run_turned];
pub const CONVEX: &[Part] = &[convex::run];
pub const NINJA: &[Part] = &[ninja::run];
pub const GROUPS: [&[Part]; 15] = [
    SHAPES, BODIES, SCENES, PILLS, SCENE_HERO, LEVELS, SEGMENTS, JOINED, MOVING, BLOCKS, MOTION, CAPSULES, TURNED,
    CONVEX, NINJA,
];

/// Separate firmwares on chips.
#[cfg(not(target_os = "none"))]
pub const GAMES: &[Part] = &[games::run];
