#!/usr/bin/env bash
# Measures run time against error, beside textbook code and other libraries. Writes results.csv, and
# from it plots/*.svg, results.md, and the tables in README.md and src/boards.md.
#
#   run.sh                 all steps: count on the host, judge and time, count on microcontrollers,
#                          weigh, show (half an hour)
#   run.sh --quick         count, judge and show with few inputs, into target/precision; writes
#                          nothing into the repository
#   run.sh --only "STEP.." only these of: count judge micro flash show; keeps the other results
#   run.sh --untimed       judges without times: on a busy machine, or for rows with unchanged code
#   run.sh --parts "P.."   judges and counts only these of: pairs convex rays casts moves levels
#                          broad regions batch; with or without --only
#   run.sh --threads       prints what threads add to moves and casts in one level
#   run.sh --soak N        asks each pair of shapes N times around touches; continues where it
#                          stopped (target/precision/soak.txt)
#
# Needs a C compiler (Box2D, Chipmunk2D), valgrind (count) and the emulator of .ci/get-emulators.sh
# (micro).
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
cd "$here"
root=$here/../..
target=${CARGO_TARGET_DIR:-$root/target}
mkdir -p "$target/precision"
target=$(cd "$target" && pwd)
export CARGO_TARGET_DIR=$target
work=$target/precision

# Chipmunk2D 7.0.0 includes a header that C libraries no longer have. Both C libraries use the
# optimisation level of the Rust code; Box2D's package would use -O2.
export CFLAGS="-I$here/compat -DNDEBUG -O3 ${CFLAGS:-}"

# Counts come before times: a later count that differs voids the time, as that of other code.
all='count judge micro flash show'

out=$here/results.csv quick='' untimed='' steps=$all soak='' threads='' parts=()
while (($#)); do
    case $1 in
    --quick)
        quick=--quick steps='count judge show'
        out=$work/results.csv
        rm -f "$out"
        ;;
    --untimed) untimed=--untimed ;;
    --only)
        steps=${2:?--only needs names of steps}
        for step in $steps; do
            [[ " $all " == *" $step "* ]] || { echo "run.sh: $step: no such step" >&2; exit 2; }
        done
        shift
        ;;
    --threads) threads=1 ;;
    --parts)
        read -ra parts <<<"${2:?--parts needs names}"
        shift
        ;;
    --soak)
        soak=${2:?--soak needs a number of queries}
        shift
        ;;
    *)
        sed -n '2,/^[^#]/s/^# \{0,1\}//p' "$here/run.sh" >&2
        exit 2
        ;;
    esac
    shift
done

cargo build --quiet --profile timed --package tilesat-precision --features peers
bench=$target/timed/tilesat-precision

if [[ -n $threads ]]; then
    exec "$bench" threads
fi

if [[ -n $soak ]]; then
    exec "$bench" soak "$soak" --state "$work/soak.txt" --out "$out"
fi

judge() {
    "$bench" measure ${parts[@]+"${parts[@]}"} $quick $untimed --out "$out"
}

count() {
    command -v valgrind >/dev/null || { echo 'run.sh: no valgrind, no instructions of the host' >&2; return; }
    "$bench" count ${parts[@]+"${parts[@]}"} $quick --out "$out"
}

cores=(m0:thumbv6m-none-eabi m4f:thumbv7em-none-eabihf)

# count_on TARGET PART. Frames take longer than a micro:bit's clock can count. So the board of the
# Cortex-M3 runs code for the M0.
count_on() {
    local board=$1
    [[ $1 == thumbv6m-* && $2 =~ ^(moves|broad)$ ]] && board=thumbv7m-none-eabi
    cargo build --quiet --profile counted --package tilesat-precision-counts --features chip --bin "$2" --target "$1"
    QEMU_SECONDS=1200 "$root/.ci/qemu.sh" "$board" "$target/$1/counted/$2"
}

# Building of segment maps. 10 000 segments need the board of the Cortex-M3, which runs code for the
# M0, and they need no inputs.
chains() {
    cargo build --quiet --profile counted --package tilesat-precision-counts --features chip --bin chains \
        --target thumbv6m-none-eabi
    "$root/.ci/qemu.sh" thumbv7m-none-eabi "$target/thumbv6m-none-eabi/counted/chains" >"$work/chains.txt"
    "$bench" add m0 "$work/chains.txt" --out "$out"
}

micro() {
    if ((!${#parts[@]})) || [[ " ${parts[*]} " == *' levels '* ]]; then chains; fi
    export PRECISION_INPUTS=$work/inputs
    mkdir -p "$PRECISION_INPUTS"
    "$bench" inputs "$PRECISION_INPUTS"
    local core part asked=(pairs rays casts moves broad)
    # Only the host counts convex pairs, queries on whole levels, regions and many shapes.
    ((${#parts[@]})) && mapfile -t asked < <(printf '%s\n' "${parts[@]}" | grep -vx -e convex -e levels -e regions -e batch)
    for core in "${cores[@]}"; do
        echo "instructions on ${core%:*}: ${asked[*]}" >&2
        for part in "${asked[@]}"; do
            count_on "${core#*:}" "$part"
        done >"$work/${core%:*}.txt"
        "$bench" add "${core%:*}" "$work/${core%:*}.txt" --out "$out"
    done
}

# Links each query alone from a library of its kind: the linker keeps only what the query needs.
flash() {
    local core library kind tools elf names name
    tools=$(rustc --print sysroot)/lib/rustlib/$(rustc -vV | sed -n 's/^host: //p')/bin
    elf=$work/one.elf
    for core in "${cores[@]}"; do
        echo "bytes on ${core%:*}" >&2
        library=$target/${core#*:}/flash/libtilesat_precision_flash.a
        for kind in queries moves broad; do
            # Without the firmware's flags, which lay out a board.
            RUSTFLAGS='' cargo build --quiet --profile flash --package tilesat-precision-flash --no-default-features --features "$kind" \
                --target "${core#*:}"
            mapfile -t names < <("$tools/llvm-nm" --format=just-symbols --extern-only --defined-only "$library" 2>/dev/null | grep -E '^[A-Za-z0-9:% -]+\|.*\|')
            for name in "${names[@]}"; do
                "$tools/rust-lld" -flavor gnu --gc-sections --entry "$name" "$library" -o "$elf"
                echo "$name|$("$tools/llvm-size" "$elf" | awk 'NR == 2 { print $1 + $2 }')"
            done
        done >"$work/flash-${core%:*}.txt"
        "$bench" add "flash_${core%:*}" "$work/flash-${core%:*}.txt" --out "$out"
    done
}

# The machine and the versions of the tools, for the page.
machine() {
    local version
    version() { awk -v name="\"$1\"" '$1 == "name" && $3 == name { getline; gsub(/"/, "", $3); print $3; exit }' "$root/Cargo.lock"; }
    echo "| | |"
    echo "|---|---|"
    echo "| machine | $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1), $(nproc) cores |"
    echo "| Rust | $(rustc --version), opt-level 3, fat LTO over the libraries too, one codegen unit, no target-cpu |"
    echo "| C | $(cc --version | head -n 1), -O3 -DNDEBUG, no -march, no link-time optimisation: Box2D and Chipmunk2D |"
    echo "| floats on microcontrollers | textbook f32 and parry2d take roots from libm, even on the core with an FPU |"
    echo "| counts | $(valgrind --version 2>/dev/null || echo none); QEMU with one instruction per tick |"
    echo "| parry2d, parry2d-f64, rapier2d | $(version parry2d), $(version parry2d-f64), $(version rapier2d): its character controller slides with parry2d's casts; its pairs are parry2d's |"
    echo "| ncollide2d over simba's I16F16 | $(version ncollide2d), $(version simba); circles only, within 127 px. Beyond that its squares overflow, and the root for its other pairs may not end |"
    echo "| Box2D | of boxdd-sys $(version boxdd-sys) (C, f32) |"
    echo "| Chipmunk2D | 7.0.0, of chipmunk-sys $(version chipmunk-sys) (C, f64); it has no mover, and Box2D's is a capsule, so that moves only circles |"
    echo "| cute_c2 | missing: no registry package contains it. Elsewhere it took 43, 65 and 91 instructions for contacts of circles, of a circle and a box, of boxes |"
    echo "| broccoli, rstar, quadtree_rs | $(version broccoli), $(version rstar), $(version quadtree_rs): built, packed or filled again in each frame of pairs |"
    echo "| microcontrollers | without an allocator: parry2d has no grid for rays, and only casts of circles against circles; moves and broad phases are ours and the textbook's, because the others need a heap |"
    echo "| tilesat | with its feature \`libm\` on the desktop, so casts of circles take the processor's root; \`exact (no filters)\` is not its code, but this benchmark's own |"
}

show() {
    machine >"$(dirname "$out")/machine.md"
    "$bench" show --out "$out"
}

for step in $all; do
    if [[ " $steps " == *" $step "* ]]; then "$step"; fi
done
