//! The bullets on a chip: 240 bullets, 32 enemies and a player, with the level in flash. Prints the
//! hash of 600 frames and of 10 000.
//!
//! ```text
//! cargo run --release --example bullets_firmware                               this computer
//! cargo run --release --example bullets_firmware --target thumbv6m-none-eabi   a Cortex-M0 (micro:bit, emulated)
//!   ... thumbv7m-none-eabi, thumbv7em-none-eabihf, thumbv8m.main-none-eabihf   a Cortex-M3, M4F, M33 (emulated)
//!   ... riscv32imc-unknown-none-elf, riscv32imac-unknown-none-elf              RISC-V (virt, emulated)
//! ```
//!
//! All of them print the same two lines. `bullets` on a desktop prints the first one.

#![cfg_attr(target_os = "none", no_std, no_main)]
#![cfg_attr(
    target_os = "none",
    allow(unsafe_code, reason = "entry points of a bare-metal program are unsafe by nature")
)]

use tilesat::TileMapError;
use tilesat_games::bullets::{FRAMES, Game, Near, level};

/// The run of the desktop example, and the run of the golden hashes.
const RUNS: [u32; 2] = [FRAMES, 10_000];

/// Runs all frames. Calls `tell` with the game after each of the runs.
fn run(game: &mut Game, tell: impl Fn(&Game)) -> Result<(), TileMapError> {
    // By reference: a copy would lie on the stack below every frame of the game.
    let level = &level();
    let level = level.as_ref().map_err(|failure| *failure)?;
    game.start();
    for frames in RUNS {
        while game.frame < frames {
            game.step(level);
        }
        tell(game);
    }
    Ok(())
}

#[cfg(not(target_os = "none"))]
fn main() -> std::process::ExitCode {
    let mut game = Game::new(Near::new());
    match run(&mut game, |game| println!("{game}")) {
        Ok(()) => std::process::ExitCode::SUCCESS,
        Err(failure) => {
            eprintln!("no run: {failure}");
            std::process::ExitCode::FAILURE
        }
    }
}

#[cfg(target_os = "none")]
mod chip {
    use super::{Game, Near, TileMapError};
    use tilesat_chip::{entry, eprintln, println, process};

    /// A static takes most of the memory of a small chip. On the stack there would briefly be two
    /// of them.
    static mut GAME: Game = Game::new(Near::new());

    // A separate function: otherwise the stack for text would lie below every frame of the game.
    #[inline(never)]
    fn tell(game: &Game) {
        println!("{game}");
    }

    #[inline(never)]
    fn fail(failure: &TileMapError) -> ! {
        eprintln!("no run: {failure}");
        process::exit(1)
    }

    /// So many bytes of the stack are left at least. The game has as many bullets as that allows.
    #[cfg(target_arch = "arm")]
    const MARGIN: usize = 128;

    /// Ends the run if the stack came too close to the game.
    #[cfg(target_arch = "arm")]
    #[inline(never)]
    fn judge_stack() {
        let left = tilesat_chip::stack::left();
        eprintln!("{left} bytes of the stack were not used");
        if left < MARGIN {
            eprintln!("a game of {} bytes leaves fewer than {MARGIN} of the stack", size_of::<Game>());
            process::exit(1);
        }
    }

    #[entry]
    fn main() -> ! {
        #[cfg(target_arch = "arm")]
        tilesat_chip::stack::paint();
        let game = &raw mut GAME;
        // SAFETY: nothing else names it, and this runs once.
        let game = unsafe { &mut *game };
        match super::run(game, tell) {
            Ok(()) => {
                #[cfg(target_arch = "arm")]
                judge_stack();
                process::exit(0)
            }
            Err(failure) => fail(&failure),
        }
    }
}
