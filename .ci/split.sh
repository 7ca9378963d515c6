#!/usr/bin/env bash
# split.sh RUSTC ARGUMENT...: a RUSTC_WORKSPACE_WRAPPER that compiles the workspace's crates as for
# cores without a long multiply.
exec "$@" --cfg tilesat_split
