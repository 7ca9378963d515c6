#!/usr/bin/env bash
# rustc.sh RUSTC ARGUMENT...: a RUSTC_WRAPPER that makes the same program wherever the clone lies.
# Cargo hashes the absolute path of a dependency outside the workspace into every symbol; by their names functions are ordered, and by that
# order inlined: 33 of 3390 reviewed numbers moved by more than 2 % from one directory to another, stack frames by up to 23 %.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
arguments=(--remap-path-prefix "$here=/tilesat" --remap-path-prefix "${CARGO_HOME:-$HOME/.cargo}=/cargo")
rustc=$1
shift
for argument; do
    [[ $argument == metadata=* ]] && argument="metadata=${CARGO_PKG_NAME:-}-${CARGO_PKG_VERSION:-}"
    arguments+=("$argument")
done
exec "$rustc" "${arguments[@]}"
