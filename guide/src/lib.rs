//! A guide to [`tilesat`]: each chapter has one complete program, which is a test.
//!
//! | chapter | what you learn |
//! |---|---|
//! | [`first_platformer`] | a whole game: run, jump, ride, collect, die |
//! | [`numbers`] | units, speeds, literals, overflow, conversions |
//! | [`tile_levels`] | bytes or text, shapes, flags, the outside, doors |
//! | [`move_and_slide`] | one body, one motion: every field of the answer |
//! | [`walker`] | slopes, steps, snap, speed on slopes |
//! | [`moving_platforms`] | lifts, conveyors, crushers, several characters |
//! | [`coins_and_spikes`] | coins, spikes, ladders, water |
//! | [`top_down`] | games without an "up" |
//! | [`segment_levels`] | polygons, walls, two levels as one |
//! | [`many_bodies`] | broad phases, pairs, scenes, ropes |
//! | [`rays_and_casts`] | lasers, guards, ledges |
//! | [`drawing_and_replays`] | interpolation, slow motion, replays, rollback |
//! | [`rollback`] | two machines: guesses, snapshots, replayed frames |
//! | [`errors`] | each error, its cause, and what a game does |
//! | [`guarantees`] | what is promised, how it is checked, and a check of your own level |
//! | [`a_board_from_zero`] | from an empty folder to a program for a Cortex-M0 |
//! | [`coming_from`] | bump, Godot, rapier, Celeste: their terms and ours |

#![allow(
    clippy::needless_doctest_main,
    clippy::doc_markdown,
    reason = "chapters show whole programs, and name other engines"
)]

// `build.rs` writes the pages with their pictures. A failing test names the file without.
macro_rules! chapters {
    ($($name:ident)+) => {
        $(#[cfg_attr(doctest, doc = include_str!(concat!("../", stringify!($name), ".md")))]
        #[cfg_attr(not(doctest), doc = include_str!(concat!(env!("OUT_DIR"), "/", stringify!($name), ".md")))]
        pub mod $name {})+
    };
}
chapters! {
    first_platformer
    numbers
    tile_levels
    move_and_slide
    walker
    moving_platforms
    coins_and_spikes
    top_down
    segment_levels
    many_bodies
    rays_and_casts
    drawing_and_replays
    rollback
    errors
    guarantees
    a_board_from_zero
    coming_from
}
