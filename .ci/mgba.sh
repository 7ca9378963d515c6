#!/usr/bin/env bash
# Cargo's runner for the Game Boy Advance: mgba.sh ELF [OPTION...] runs the program without a
# window. For the options, see examples/gba/run/src/main.rs. Exits with the program's status, with 3
# without an emulator, or with 124 after a time-out.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
core=$("$root/.ci/get-emulators.sh" gba) || exit 3

# The stable compiler builds the front end for the host, as it builds the tests.
unset RUSTC_BOOTSTRAP RUSTC_WRAPPER
cargo build --quiet --profile test --manifest-path "$root/Cargo.toml" --package tilesat-gba-run
run=${CARGO_TARGET_DIR:-$root/target}/debug/tilesat-gba-run
LD_LIBRARY_PATH=$(dirname "$core")/.. exec timeout "${GBA_SECONDS:-120}" "$run" "$core" "$@" </dev/null
