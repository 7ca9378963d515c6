//! Written by `tilesat bake LEVEL -o OUT.rs`. Do not edit it.
#![allow(unreachable_pub, reason = "a level is a module of a program")]
#![allow(dead_code, reason = "a game may use only a part")]
#![allow(clippy::unreadable_literal, reason = "raw coordinates")]

/// Add this to a position of the map to get it here, in pixels.
pub const SHIFT: [i32; 2] = [-999744, 0];

use ::tilesat::{Fx, Path, PathKind, Vec2, segment_map};

#[rustfmt::skip]
const POINTS_0: [Vec2; 3] = [
    Vec2::from_ints(16, 11),
    Vec2::from_ints(16, 16),
    Vec2::from_ints(0, 16),
];

segment_map!(
    #[allow(long_running_const_eval, reason = "it ends, because the level is finite")]
    pub static SEGMENTS: [
        Path::new(PathKind::Solid, &POINTS_0),
    ],
    Fx::lit("16")
);
