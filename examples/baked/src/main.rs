//! A firmware whose levels its build script bakes: `cargo run -p tilesat-baked`, or for a chip with
//! `--target thumbv6m-none-eabi`.
//!
//! `levels` has a cave drawn with Tiled and a tower drawn with `LDtk`. A ball falls in each. The
//! program prints where it comes to rest.

#![cfg_attr(target_os = "none", no_std, no_main)]
#![cfg_attr(
    target_os = "none",
    allow(unsafe_code, reason = "entry points of a bare-metal program are unsafe by nature")
)]

use tilesat::{Axis, Circle, MoveError, Mover, Vec2, World, fx};

include!(concat!(env!("OUT_DIR"), "/levels.rs"));

/// A minute.
const FRAMES: u32 = 3600;

/// The position at which a ball comes to rest.
fn fall(level: &impl World, from: Vec2) -> Result<Vec2, MoveError> {
    let mover = Mover::platformer(Axis::NEG_Y);
    let mut ball = Circle::new(from, fx!(5))?;
    let mut velocity = Vec2::ZERO;
    for _ in 0..FRAMES {
        let moved = mover.move_and_slide(level, &ball, velocity + Vec2::from_raw(0, 16_384))?;
        (ball, velocity) = (moved.body, moved.velocity);
    }
    Ok(ball.centre())
}

fn places() -> Result<[Vec2; 2], MoveError> {
    Ok([fall(&levels::cave::MAP, Vec2::from_ints(40, 24))?, fall(&levels::tower::MAP, Vec2::from_ints(40, 24))?])
}

#[cfg(not(target_os = "none"))]
fn main() -> std::process::ExitCode {
    match places() {
        Ok([cave, tower]) => {
            println!("cave ({}, {}), tower ({}, {})", cave.x, cave.y, tower.x, tower.y);
            std::process::ExitCode::SUCCESS
        }
        Err(failure) => {
            eprintln!("no level: {failure}");
            std::process::ExitCode::FAILURE
        }
    }
}

#[cfg(target_os = "none")]
mod chip {
    use tilesat_chip::{entry, eprintln, println, process};

    #[entry]
    fn main() -> ! {
        match super::places() {
            Ok([cave, tower]) => {
                println!("cave ({}, {}), tower ({}, {})", cave.x, cave.y, tower.x, tower.y);
                process::exit(0)
            }
            Err(failure) => {
                eprintln!("no level: {failure}");
                process::exit(1)
            }
        }
    }
}
