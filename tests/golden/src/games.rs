//! The two games that are separate firmwares on chips: the platformer's bodies and the bullets, for
//! ten thousand frames.

use tilesat_games::bullets::{self, Game, Near};
use tilesat_games::platformer::flash;

use super::family::{Line, Run};
use super::hash::Hash;
use super::ninja::FRAMES;

pub(crate) fn run(run: &mut Run<'_>) {
    for count in FRAMES {
        if let Ok(outcome) = flash::run(count, |_, _| {}) {
            run.line(&Line { query: "frames", of: "platformer", count, hash: Hash::from(outcome.hash) });
        }
    }
    let Ok(level) = bullets::level() else { return };
    let mut game = Game::new(Near::new());
    game.start();
    for count in FRAMES {
        while game.frame < count {
            game.step(&level);
        }
        run.line(&Line { query: "frames", of: "bullets", count, hash: Hash::from(game.tally.hash) });
    }
}
