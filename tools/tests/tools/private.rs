//! The private modules of the tools that have unit tests, compiled a second time with these tests.
//! Otherwise `cargo test` would compile the whole library a second time, for four tests.

#![allow(dead_code, reason = "the tests call a part of each module")]

#[path = "../../src/advice.rs"]
mod advice;
#[path = "../../src/rules/doubts.rs"]
mod doubts;
#[path = "../../src/rules/union.rs"]
mod union;
#[path = "../../src/rules/words.rs"]
mod words;
