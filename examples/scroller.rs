//! A runner in a world of 40 000 pixels, on a chip or on a computer. It runs through rooms of one
//! screen, and through rooms of eight.
//!
//! ```text
//! cargo run --release --example scroller                               this computer
//! cargo run --release --example scroller --target thumbv6m-none-eabi   a Cortex-M0 (micro:bit, emulated)
//! ```
//!
//! Both print one line twice: no frame depends on where the world is cut.

#![cfg_attr(target_os = "none", no_std, no_main)]
#![cfg_attr(
    target_os = "none",
    allow(unsafe_code, reason = "entry points of a bare-metal program are unsafe by nature")
)]

use tilesat::{MoveError, Rooms};
use tilesat_games::scroller::{Outcome, run, world};

const SCREENS: Rooms<'static> = match world::rooms(25) {
    Ok(rooms) => rooms,
    Err(_) => panic!("no world"),
};
const HALLS: Rooms<'static> = match world::rooms(200) {
    Ok(rooms) => rooms,
    Err(_) => panic!("no world"),
};

fn runs() -> Result<[Outcome; 2], MoveError> {
    Ok([run(&SCREENS)?, run(&HALLS)?])
}

#[cfg(not(target_os = "none"))]
fn main() -> std::process::ExitCode {
    match runs() {
        Ok(runs) => {
            println!("{}\n{}", runs[0], runs[1]);
            std::process::ExitCode::from(u8::from(runs[0] != runs[1]))
        }
        Err(failure) => {
            eprintln!("no run: {failure}");
            std::process::ExitCode::FAILURE
        }
    }
}

#[cfg(target_os = "none")]
mod chip {
    use tilesat_chip::{entry, eprintln, println, process};

    #[entry]
    fn main() -> ! {
        match super::runs() {
            Ok([screens, halls]) => {
                println!("{screens}\n{halls}");
                process::exit(i32::from(screens != halls))
            }
            Err(failure) => {
                eprintln!("no run: {failure}");
                process::exit(1)
            }
        }
    }
}
