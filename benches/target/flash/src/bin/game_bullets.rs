//! The bullets as the firmware plays them: 256 bullets, 32 enemies and a player, found by a broad phase, with events and exceptions of pairs.
#![no_std]
#![no_main]
#[path = "../../../../../examples/bullets/game/mod.rs"]
mod game;
use game::{Game, Near, level};

tilesat_flash::game!(
    Game = Game::new(Near::new()),
    map = level(),
    |game| {
        game.start();
        game
    },
    |game| game.step(&map)
);
