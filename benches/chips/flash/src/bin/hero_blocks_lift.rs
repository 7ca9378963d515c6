//! A whole platformer among blocks with a lift: one hero, its keys, its level.
#![cfg_attr(target_os = "none", no_std, no_main)]
use tilesat::{Blocks, Character, Solid};
use tilesat_flash::Later;
use tilesat_flash::hero::{begin, input, level, lift, moved};

tilesat_flash::game!(
    Later<(Character, [Solid; 1])> = Later::NONE,
    map = level::<Blocks>(),
    |state| state.begin(begin().zip(lift())),
    |game| {
        game.1 = moved(game.1);
        game.0.step_on(&map, &mut game.1, input())
    }
);
