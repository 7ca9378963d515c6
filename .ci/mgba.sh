#!/usr/bin/env bash
# Cargo's runner for the Game Boy Advance: mgba.sh ELF [OPTION...] runs the program without a window (options: examples/gba/run/src/main.rs).
# The exit status is the program's own; 3 where there is no emulator, 124 where the program did not end in time.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
core=$("$root/.ci/get-emulators.sh" gba) || exit 3

# The front end is the host's, built by the stable compiler as it is, and as the tests are.
unset RUSTC_BOOTSTRAP RUSTC_WRAPPER
cargo build --quiet --profile test --manifest-path "$root/Cargo.toml" --package tilesat-gba-run
run=${CARGO_TARGET_DIR:-$root/target}/debug/tilesat-gba-run
LD_LIBRARY_PATH=$(dirname "$core")/.. exec timeout "${GBA_SECONDS:-120}" "$run" "$core" "$@" </dev/null
