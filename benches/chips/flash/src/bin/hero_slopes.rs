//! A whole platformer among slopes: one hero, its keys, its level.
#![cfg_attr(target_os = "none", no_std, no_main)]
use tilesat::{Character, Slopes};
use tilesat_flash::Later;
use tilesat_flash::hero::{begin, input, level};

tilesat_flash::game!(
    Later<Character> = Later::NONE,
    map = level::<Slopes>(),
    |state| state.begin(begin()),
    |hero| hero.step(&map, input())
);
