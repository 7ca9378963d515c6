#!/usr/bin/env bash
# Fuzzes the library and the level readers. The judges of the tests check every input.
#
#   run.sh [TARGET...]             guided by coverage, all targets or these; needs a C++ compiler
#   run.sh --seconds N [TARGET...] N seconds in all (default 360), the same for each target
#   run.sh --replay [TARGET...]    only the committed corpus, on any toolchain
#   run.sh --random N [TARGET...]  the same, and N changed inputs of each target
#   run.sh --coverage              the lines of src that the committed corpus reaches, by module
#   run.sh --keep [TARGET...]      commits the smallest corpus with all coverage that was found
#   run.sh --list                  the targets
#
# The committed inputs are lines of hexadecimal digits, in corpus/TARGET.hex and in
# faults/TARGET.hex. The latter has the name of the fault behind each input. New findings stay below
# target/fuzz, and the next run continues from them. Exit 1: an input failed. Exit 3: nothing could
# run.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
out=${CARGO_TARGET_DIR:-$here/../../target}/fuzz
mkdir -p "$out"
out=$(cd "$out" && pwd)
cd "$here"
mapfile -t all < <(for file in fuzz_targets/*.rs; do basename "$file" .rs; done)

mode=guided seconds=360 random=0 targets=()
while (($#)); do
    case $1 in
    --seconds | --random)
        declare "${1#--}=${2:?$1 needs a number}"
        [[ $1 == --random ]] && mode=replay
        shift
        ;;
    --replay | --coverage | --keep) mode=${1#--} ;;
    --list)
        printf '%s\n' "${all[@]}"
        exit
        ;;
    --* | -*)
        sed -n '2,/^[^#]/s/^# \{0,1\}//p' run.sh >&2
        exit 2
        ;;
    *)
        [[ -f fuzz_targets/$1.rs ]] || {
            echo "run.sh: no target $1; there are: ${all[*]}" >&2
            exit 2
        }
        targets+=("$1")
        ;;
    esac
    shift
done
((${#targets[@]})) || targets=("${all[@]}")

# Bytes of an input: few for a pair, many for a sequence of operations.
declare -A longest=([broad]=1200 [scene]=1200 [segment_bytes]=600 [ride]=400 [tmx]=500 [ldtk]=400)
host=$(rustc -vV | sed -n 's/^host: //p')

# unpack FILE FOLDER: writes a file per line.
unpack() {
    local line n=0
    rm -rf "$2" && mkdir -p "$2"
    [[ -f $1 ]] || return 0
    while read -r line _; do
        n=$((n + 1))
        # shellcheck disable=SC2059 # the bytes are the format
        printf "$(sed 's/^-$//; s/../\\x&/g' <<<"$line")" >"$2/$n"
    done <"$1"
}
# pack FOLDER: prints a line per file.
pack() {
    local file
    for file in "$1"/*; do
        od -An -v -tx1 "$file" | tr -d ' \n' | sed 's/^$/-/'
        echo
    done | LC_ALL=C sort
}

# libFuzzer needs counters of edges and of comparisons from the compiler. No sanitizer: there is no
# unsafe code, the fuzzer runs more inputs without one, and any toolchain works.
coverage_flags='--cfg fuzzing -Cpasses=sancov-module -Cllvm-args=-sanitizer-coverage-level=4 -Cllvm-args=-sanitizer-coverage-inline-8bit-counters
    -Cllvm-args=-sanitizer-coverage-pc-table -Cllvm-args=-sanitizer-coverage-trace-compares -Cllvm-args=-sanitizer-coverage-stack-depth'
build_guided() {
    command -v c++ >/dev/null || {
        echo 'run.sh: NOTHING WAS FUZZED: libFuzzer wants a C++ compiler. The committed corpus does not: run.sh --replay' >&2
        exit 3
    }
    RUSTFLAGS=${coverage_flags//$'\n'/} CARGO_TARGET_DIR=$out/guided cargo build --quiet --profile fuzz --package tilesat-fuzz \
        --features coverage-guided --target "$host" "${targets[@]/#/--bin=}"
    local target
    for target in "${targets[@]}"; do
        unpack "corpus/$target.hex" "$out/committed/$target"
        unpack "faults/$target.hex" "$out/faults/$target"
    done
}

guided() {
    local target each found=0 log program total=0
    build_guided
    each=$((seconds / ${#targets[@]}))
    ((each > 0)) || each=1
    echo "== ${#targets[@]} targets, $each s each"
    printf '%-14s %12s %9s %7s %7s %9s\n' target executions new edges corpus findings
    for target in "${targets[@]}"; do
        program=$out/guided/$host/fuzz/$target log=$out/$target.log
        mkdir -p "$out/corpus/$target" "$out/findings/$target"
        # 77 means a finding. The log has it.
        "$program" "$out/corpus/$target" "$out/committed/$target" "$out/faults/$target" -max_total_time="$each" -max_len="${longest[$target]:-300}" -timeout=20 -reload=0 \
            -print_final_stats=1 -artifact_prefix="$out/findings/$target/" >"$log" 2>&1 || true
        local n
        n=$(find "$out/findings/$target" -type f | wc -l)
        awk -v target="$target" -v findings="$n" '
            /cov: / { for (i = 1; i < NF; i++) { if ($i == "cov:") edges = $(i + 1); if ($i == "corp:") { split($(i + 1), c, "/"); corpus = c[1] } } }
            /stat::number_of_executed_units/ { runs = $2 }
            /stat::new_units_added/ { new = $2 }
            END { printf "%-14s %12d %9d %7d %7d %9d\n", target, runs, new, edges, corpus, findings }' "$log"
        if ((n)); then
            found=1
            grep -m1 -A3 'panicked at' "$log" || tail -3 "$log"
            find "$out/findings/$target" -type f
        fi
        total=$((total + $(awk '/stat::number_of_executed_units/ { n = $2 } END { print n + 0 }' "$log")))
    done
    echo "== $total executions, $( ((found)) && echo 'SOMETHING WAS FOUND' || echo 'nothing found')"
    return $found
}

# Keeps the fewest inputs that reach every edge.
keep() {
    local target program fresh
    build_guided
    for target in "${targets[@]}"; do
        program=$out/guided/$host/fuzz/$target fresh=$out/fresh/$target
        mkdir -p "$out/corpus/$target"
        rm -rf "$fresh" && mkdir -p "$fresh"
        "$program" -set_cover_merge=1 -use_counters=0 -max_len="${longest[$target]:-300}" "$fresh" "$out/corpus/$target" "$out/committed/$target" >"$out/$target.merge.log" 2>&1
        pack "$fresh" >"corpus/$target.hex"
        printf '%-14s %5d inputs %7d bytes\n' "$target" "$(wc -l <"corpus/$target.hex")" "$(cat "$fresh"/* | wc -c)"
    done
}

replay() {
    # Uses the test profile: it checks overflow and every assertion. The other example turns on the
    # features of the tests, so that cargo takes what the tests have built.
    cargo build --quiet --profile test --package tilesat --package tilesat-examples --package tilesat-fuzz --example replay --example hero
    "${CARGO_TARGET_DIR:-../../target}/debug/examples/replay" --random "$random" "${targets[@]}"
}

coverage() {
    local llvm
    llvm=$(rustc --print target-libdir)/../bin
    [[ -x $llvm/llvm-cov ]] || {
        echo 'run.sh: NOTHING WAS MEASURED: rustup component add llvm-tools' >&2
        exit 3
    }
    rm -f "$out"/coverage-*.profraw
    RUSTFLAGS=-Cinstrument-coverage CARGO_TARGET_DIR=$out/coverage cargo build --quiet --profile test --package tilesat-fuzz --example replay
    LLVM_PROFILE_FILE=$out/coverage-%p.profraw "$out/coverage/debug/examples/replay"
    "$llvm/llvm-profdata" merge --sparse "$out"/coverage-*.profraw -o "$out/coverage.profdata"
    "$llvm/llvm-cov" report "$out/coverage/debug/examples/replay" --instr-profile "$out/coverage.profdata" --ignore-filename-regex '/\.cargo/|rustlib/|/rustc/|/out/|benches/|examples/' >"$out/coverage.txt"
    # Columns of the report: file, regions, missed, %, functions, missed, %, lines, missed, %.
    echo
    awk '
        function row(name, all, missed) { return sprintf("%-8s %7d %7d %7.1f", name, all, all - missed, 100 * (all - missed) / all) }
        BEGIN { printf "%-8s %7s %7s %7s\n", "module", "lines", "reached", "%" }
        $1 ~ /\.rs$/ {
            name = $1; sub(/^.*\/src\//, "", name)
            module = name ~ /\// ? substr(name, 1, index(name, "/") - 1) : "others"
            lines[module] += $8; missed[module] += $9; all += $8; none += $9
        }
        END { for (m in lines) print row(m, lines[m], missed[m]) | "sort"; close("sort"); print row("all", all, none) }' "$out/coverage.txt"
    echo "by file: $out/coverage.txt"
}

"$mode"
