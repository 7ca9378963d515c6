//! A whole platformer among blocks: one hero, its keys, its level.
#![cfg_attr(target_os = "none", no_std, no_main)]
use tilesat::{Blocks, Character};
use tilesat_flash::Later;
use tilesat_flash::hero::{begin, input, level};

tilesat_flash::game!(
    Later<Character> = Later::NONE,
    map = level::<Blocks>(),
    |state| state.begin(begin()),
    |hero| hero.step(&map, input())
);
