//! Pictures of what the library says about tiles: `cargo run --release --example sheet [-- FOLDER]`.
//!
//! - `sheet-shapes.png`: every shape with its faces, vertices and arcs;
//! - `sheet-mosaic.png`: random tiles, what is left of their surface, and rays from a point;
//! - `sheet-level.png`: the level `ninja`, rays, and the way of a ball.
//!
//! Everything is drawn from what the library answers: the solid from `overlaps` point by point, lines and arrows from `features`, rays
//! from `cast_ray`, the way from `move_and_slide`. What looks wrong here is wrong there.
#![allow(unreachable_pub, reason = "a program has no outside; `pub` marks what other files of it use")]
#![allow(clippy::std_instead_of_core, clippy::float_arithmetic, reason = "drawing, on a desktop")]
#![allow(clippy::indexing_slicing, clippy::cast_precision_loss, reason = "drawing")]

#[allow(dead_code, reason = "its reader of levels and its canvas are used here")]
#[path = "../platformer/main.rs"]
mod platformer;

mod glyphs;
mod scenes;
mod shapes;
mod solid;

use std::env;
use std::path::PathBuf;
use std::process::ExitCode;

use platformer::fail::{Fail, Result};
use platformer::picture::{Scene, write_png};

fn main() -> ExitCode {
    let folder = env::args_os().nth(1);
    if folder.as_ref().is_some_and(|folder| folder.to_string_lossy().starts_with('-')) {
        eprintln!("usage: sheet [FOLDER]    (default: the target folder)");
        return ExitCode::from(2);
    }
    match draw(folder.map(PathBuf::from)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(fail) => {
            eprintln!("sheet: {fail}");
            ExitCode::from(2)
        }
    }
}

fn draw(folder: Option<PathBuf>) -> Result<()> {
    let exe = env::current_exe().ok();
    let target = exe.as_ref().and_then(|exe| exe.ancestors().nth(3)).map(PathBuf::from);
    let folder = folder.or(target).ok_or_else(|| Fail::new("where should the pictures go?"))?;
    let pictures: [(&str, Scene); 3] = [
        ("sheet-shapes.png", shapes::sheet()?),
        ("sheet-mosaic.png", scenes::mosaic()?),
        ("sheet-level.png", scenes::level()?),
    ];
    for (name, scene) in &pictures {
        let file = folder.join(name);
        write_png(scene, &file)?;
        println!("picture {}", file.display());
    }
    Ok(())
}
