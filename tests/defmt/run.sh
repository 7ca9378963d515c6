#!/usr/bin/env bash
# Checks the output of the feature defmt on the chip, and its cost.
#
#   run.sh            runs the firmware on an emulated Cortex-M0 and M3. It logs a value of every
#                     public type. Decodes its frames and compares them with expected.txt. A public
#                     type without a line fails. Then compares programs that log nothing, built
#                     with the feature and without: they must have the same functions, and the
#                     same constants and statics of the same sizes
#   run.sh --accept   the same, and the decoded output becomes expected.txt
#   run.sh --short    only on the M0, and with a game in place of the program that has every
#                     function of scenes: 60 s of a core less
#
# Exit 0: all is well. 1: a line differs or is missing, or the feature costs something. 3: no
# emulator is available.
set -euo pipefail
exec </dev/null
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
accept='' targets=(thumbv6m-none-eabi thumbv7m-none-eabi)
# Programs with every public function of shapes and of scenes. Without the feature, and with it but
# without a log.
programs=(everything_shapes everything_scenes)
case "${*:-}" in
'') ;;
--accept) accept=--accept ;;
--short) targets=(thumbv6m-none-eabi) programs=(everything_shapes scene_blocks) ;;
*)
    sed -n '2,/^[^#]/s/^# \{0,1\}//p' "$here/run.sh" >&2
    exit 2
    ;;
esac

cd "$root"
out=${CARGO_TARGET_DIR:-target}
mkdir -p "$out/defmt"
out=$(cd "$out" && pwd)
llvm=$(rustc --print target-libdir)/../bin

# The pages of rustdoc that list the public types. The flags and packages are those of `.ci/run`, so
# cargo writes nothing twice.
RUSTDOCFLAGS='-D warnings' cargo doc --quiet --no-deps --all-features --package tilesat --package tilesat-tools --package tilesat-guide
cargo build --quiet --package tilesat-defmt-check

# The same symbols in any directory, as in the tables of sizes, whose programs are among those
# below.
export RUSTC_WRAPPER=$root/.ci/rustc.sh

failed=0
for target in "${targets[@]}"; do
    CARGO_TARGET_DIR=$out/defmt cargo build --quiet --profile flash --package tilesat-defmt --features chip --target "$target"
    elf=$out/defmt/$target/flash/tilesat-defmt
    frames=$out/defmt/$target.frames status=0
    "$root/.ci/qemu.sh" "$target" "$elf" 2>"$frames" || status=$?
    if ((status == 3)); then
        cat "$frames" >&2
        echo "defmt: no emulator: what the feature prints was NOT checked" >&2
        exit 3
    elif ((status)); then
        failed=1
        echo "$target: the firmware ended with $status; its frames and its message:" >&2
        tr -cd '[:print:]\n' <"$frames" | tail -n 5 >&2
        continue
    fi
    echo "-- $target"
    "$out/debug/tilesat-defmt-check" "$elf" "$frames" "$out/doc/tilesat" "$here/expected.txt" $accept || failed=1
done

# Functions, constants and statics of a program with their sizes. Their position, and so some bytes
# of padding, depends on the compiler's hashes, which include features. So do the last parts of the
# names. The two marks of the encoding are in no loaded section.
parts() {
    "$llvm/llvm-nm" --demangle --print-size --radix=d "$1" | grep -v ' _defmt_\(encoding\|version\)_ = ' |
        awk '{ size = $2 + 0; kind = $3; $1 = $2 = $3 = ""; print size, kind $0 }' | sed 's/::h[0-9a-f]\{16\}//' | sort -k 2
}
# The parts that must be equal. A function's own bytes may differ: the order of the code follows
# those hashes too, and with it a branch's length and the choice of a register (once in 953
# functions, by 2 bytes).
same() { awk '{ if ($2 ~ /[tTwW]/) $1 = "-"; print }' "$1" | diff - <(awk '{ if ($2 ~ /[tTwW]/) $1 = "-"; print }' "$2"); }
build() {
    CARGO_TARGET_DIR=$1 cargo build --quiet --profile flash --package tilesat-flash "${programs[@]/#/--bin=}" --target thumbv6m-none-eabi "${@:2}"
}
build "$out/benches"
build "$out/defmt" --features tilesat/defmt
echo '-- programs that log nothing: parts and their bytes without the feature, and with it'
for program in "${programs[@]}"; do
    parts "$out/benches/thumbv6m-none-eabi/flash/$program" >"$out/defmt/off.txt"
    parts "$out/defmt/thumbv6m-none-eabi/flash/$program" >"$out/defmt/on.txt"
    awk -v program="$program" '
        { count[FILENAME]++; sum[FILENAME] += $1 }
        END {
            printf "%-20s %4d %7d   %4d %7d\n", program, count[ARGV[1]], sum[ARGV[1]], count[ARGV[2]], sum[ARGV[2]]
            more = sum[ARGV[2]] - sum[ARGV[1]]
            if (more * 1000 > sum[ARGV[1]]) { print program ": the feature adds " more " bytes: more than a thousandth, which layout alone does not"; exit 1 }
        }' "$out/defmt/off.txt" "$out/defmt/on.txt" || failed=1
    same "$out/defmt/off.txt" "$out/defmt/on.txt" || failed=1
done
((!failed)) || { echo 'defmt: FAILED' >&2; exit 1; }
echo 'defmt: ok'
