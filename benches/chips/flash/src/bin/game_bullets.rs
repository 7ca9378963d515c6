//! The bullets, as in the firmware: 240 bullets, 32 enemies and a player. A broad phase finds them,
//! with events and exceptions of pairs.
#![cfg_attr(target_os = "none", no_std, no_main)]
use tilesat_games::bullets::{Game, Near, level};

tilesat_flash::game!(
    Game = Game::new(Near::new()),
    map = level(),
    |game| {
        game.start();
        game
    },
    |game| game.step(&map)
);
