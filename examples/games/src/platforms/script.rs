//! The player's keys, and how long they are held.

use super::game::{Game, Keys};
use super::machine::{CRUSHER, LIFT, SHELF};

const NONE: Keys = Keys { run: 0, jump: false, drop: false };
const RIGHT: Keys = Keys { run: 1, ..NONE };
const LEFT: Keys = Keys { run: -1, ..NONE };

/// Keys, and how long they are held.
pub type Stretch = (Keys, fn(&Game) -> bool);
pub const SCRIPT: [Stretch; 16] = [
    (RIGHT, |game| game.at().x > 280),
    (NONE, |game| game.at().x > 370), // the belt takes it there
    (RIGHT, |game| game.at().x > 436),
    (NONE, |game| game.is_back(&CRUSHER)),
    (RIGHT, |game| game.at().x > 530),
    (NONE, |game| game.is_back(&LIFT)),
    (RIGHT, |game| game.at().x > 568),
    (NONE, |game| game.at().y < 106),
    (RIGHT, |game| game.at().x > 728),
    (NONE, |game| game.is_back(&SHELF)),
    (Keys { jump: true, ..NONE }, |game| game.at().y < 88), // through it from below
    (NONE, |game| game.floor.is_some()),
    (NONE, |game| game.at().y < 26),
    (LEFT, |game| game.at().x < 520),
    (Keys { drop: true, ..NONE }, |game| game.floor.is_none()),
    (LEFT, |game| game.at().x < 420),
];
