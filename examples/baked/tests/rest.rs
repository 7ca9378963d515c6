//! Runs the program on the levels that its build script has baked.

#![cfg(not(target_os = "none"))]

use std::process::Command;

/// In the cave it rolls down the slope to the floor. In the tower it stays on a plank.
#[test]
fn balls_come_to_rest() {
    let run = Command::new(env!("CARGO_BIN_EXE_tilesat-baked")).output().unwrap();
    assert!(run.status.success(), "{run:?}");
    assert_eq!(String::from_utf8(run.stdout).unwrap(), "cave (139, 139), tower (40, 59)\n");
}
