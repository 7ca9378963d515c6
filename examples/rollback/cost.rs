//! The cost of a snapshot on this computer.

use std::hint::black_box;
use std::time::Instant;

use tilesat::scene::SceneError;
use tilesat_games::rollback::{Arena, BODIES, Game, Keys, Saved};

const TIMES: u32 = 20_000;

/// Prints the size of a snapshot, and the time to make, copy and restore one.
pub(crate) fn print(arena: Arena) -> Result<(), SceneError> {
    let mut game = Game::new()?;
    for _ in 0..60 {
        game.step(&arena, [Keys::RIGHT, Keys::LEFT])?;
    }
    let saved = game.save();
    let mut copy = saved;
    let save = time(|| black_box(&mut copy).clone_from(&black_box(&game).save()));
    let twice = time(|| *black_box(&mut copy) = *black_box(&saved));
    let load = time(|| black_box(&mut game).load(black_box(&saved)));
    println!(
        "a snapshot of {BODIES} bodies: {} bytes, made in {save:.2} us, copied in {twice:.2} us, restored in {load:.2} us",
        size_of::<Saved>(),
    );
    Ok(())
}

#[allow(clippy::float_arithmetic, reason = "a time to print")]
fn time(mut run: impl FnMut()) -> f64 {
    let start = Instant::now();
    for _ in 0..TIMES {
        run();
    }
    start.elapsed().as_secs_f64() * 1e6 / f64::from(TIMES)
}
