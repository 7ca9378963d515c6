#!/usr/bin/env bash
# lint.sh OPTION...: clippy on a package whose build script needs other packages of the workspace.
# `cargo clippy` compiles those with clippy too, and so once more than the build does: 33 s of a
# core for the tools that bake levels. This is `cargo check` with a wrapper that calls clippy for
# what is only checked. The options are those of `cargo check`, with a target.
set -euo pipefail

if [[ ${TILESAT_LINT:-} ]]; then
    # As RUSTC_WRAPPER: RUSTC ARGUMENT... Builds, questions and foreign packages have no lints here.
    [[ " $* " == *' --emit=dep-info,metadata '* && ${CARGO_MANIFEST_DIR:-} == "$TILESAT_LINT"* ]] || exec "$@"
    exec clippy-driver "$@"
fi
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# With this flag cargo does not take what a common check has left. Flags are not for build scripts
# and what they need, because there is a target.
export TILESAT_LINT=$PWD RUSTC_WRAPPER=$PWD/.ci/lint.sh RUSTFLAGS='--cfg linted'
export CLIPPY_ARGS=-D__CLIPPY_HACKERY__warnings__CLIPPY_HACKERY__
exec cargo check "$@"
