//! The pictures of the guide are drawn from the library's answers. The committed files are equal to
//! what this draws.
//!
//! `TILESAT_BLESS=1 cargo test -p tilesat-guide --test pictures` draws them again.

#![allow(clippy::cast_precision_loss, reason = "drawing")]

mod draw;
mod game;
mod rays;
mod slides;
mod tiles;
mod walks;

use std::error::Error;
use std::fs;
use std::path::Path;

use tilesat_tools::picture::marks::Scene;
use tilesat_tools::picture::svg;

/// Compares a picture with its file, and checks that a chapter shows it.
fn shown(chapter: &str, picture: Result<Scene, Box<dyn Error>>) {
    let guide = Path::new(env!("CARGO_MANIFEST_DIR"));
    let drawn = svg::text(&picture.unwrap());
    assert!(drawn.len() < 12_000, "{} bytes", drawn.len());
    let page = fs::read_to_string(guide.join(format!("{chapter}.md"))).unwrap();
    assert!(page.contains(&format!("](pictures/{chapter}.svg)\n")), "{chapter}.md does not show its picture");
    let file = guide.join(format!("pictures/{chapter}.svg"));
    if std::env::var_os("TILESAT_BLESS").is_some() {
        fs::write(file, drawn).unwrap();
    } else {
        let committed = fs::read_to_string(file).unwrap();
        assert!(committed == drawn, "pictures/{chapter}.svg is another picture: see guide/tests/pictures/main.rs");
    }
}

#[test]
fn the_shapes_of_tiles() {
    shown("tile_levels", tiles::picture());
}

#[test]
fn floor_wall_and_ceiling() {
    shown("move_and_slide", slides::picture());
}

#[test]
fn snap_step_and_slope_limit() {
    shown("walker", walks::picture());
}

#[test]
fn a_laser_a_guard_and_a_ball() {
    shown("rays_and_casts", rays::picture());
}

#[test]
fn the_path_of_the_first_hero() {
    shown("first_platformer", game::picture());
}
