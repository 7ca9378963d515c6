#!/usr/bin/env bash
# Lists the functions that take the time of the game with 64 bodies, by an interrupt that samples
# the program counter. Columns: share of the time, all shares so far, bytes, RAM or ROM, name.
# The list is sorted by share per byte: what should be in fast RAM comes first.
#
#   profile.sh          in Arm state
#   profile.sh thumb    in Thumb state
#
# Exit 3 without an emulator. The lists of functions for fast RAM are in hot/.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
target=armv4t-none-eabi
[[ ${1:-} != thumb ]] || target=thumbv4t-none-eabi
.ci/get-emulators.sh gba >/dev/null || exit 3
source examples/gba/keys.sh
# A build of its own, so that the game without samples stays.
export CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-target}/profile
mkdir -p "$CARGO_TARGET_DIR"
export RUSTC_WRAPPER=$PWD/.ci/rustc.sh GBA_SECONDS=600
RUSTC_BOOTSTRAP=1 cargo run --quiet --profile counted --package tilesat-gba --features console,profile -Zbuild-std=core \
    --target "$target" --bin game -- --keys "5:select $keys" >"$CARGO_TARGET_DIR/samples.txt"

elf=$CARGO_TARGET_DIR/$target/counted/game
"$(rustc --print target-libdir)/../bin/llvm-nm" --demangle --print-size --numeric-sort --radix=d "$elf" |
    sed 's/^\(\S* \S* \S\) /\1\t/' | awk -F'\t' '
    function hex(text,    i, n) { n = 0; for (i = 1; i <= length(text); i++) n = n * 16 + index("0123456789abcdef", substr(text, i, 1)) - 1; return n }
    NR == FNR {
        split($1, field, " ")
        if (field[3] ~ /[tTwW]/ && field[2] + 0 && $2 !~ /^__.*Thunk/) { from[++count] = field[1] - field[1] % 2; size[count] = field[2] + 0; name[count] = $2 }
        next
    }
    match($0, /PC [0-9a-f]+$/) {
        pc = hex(substr($0, RSTART + 3)) - 4
        low = 0; high = count + 1
        while (high - low > 1) { middle = int((low + high) / 2); if (from[middle] <= pc) low = middle; else high = middle }
        all++
        if (low && pc < from[low] + size[low]) samples[low]++
    }
    END {
        for (i = 1; i <= count; i++) if (samples[i])
            printf "%.8f\t%.2f\t%d\t%s\t%s\n", samples[i] / size[i], 100 * samples[i] / all, size[i], from[i] < 134217728 ? "RAM" : "ROM", name[i]
    }' - "$CARGO_TARGET_DIR/samples.txt" | sort -rn | awk -F'\t' '{ sum += $2; printf "%5.2f %% %6.2f %% %6d B %s  %s\n", $2, sum, $3, $4, $5 }'
