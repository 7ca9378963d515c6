#!/usr/bin/env bash
# Fuzzes the library and the level readers: every input is held against the contract by the judges of the tests.
#
#   run.sh [TARGET...]             guided by coverage, all targets or these; wants a nightly toolchain and cargo-fuzz
#   run.sh --seconds N [TARGET...] N seconds in all (default 360), the same for each target
#   run.sh --replay [TARGET...]    the committed corpus, on any toolchain
#   run.sh --random N [TARGET...]  the same, and N changed inputs of each target
#   run.sh --coverage              the lines of src that the committed corpus reaches, by module
#   run.sh --keep [TARGET...]      makes the smallest corpus that covers what was found so far the committed one
#   run.sh --list                  the targets
#
# What was found stays below target/fuzz and is gone on from. Exit 1 where something failed, 3 where nothing could be run.
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
        sed -n '2,12s/^# \{0,1\}//p' run.sh >&2
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

# Bytes of an input: of a pair a few, of a sequence of operations many.
declare -A longest=([broad]=1200 [scene]=1200 [segment_bytes]=600 [ride]=400 [tmx]=500 [ldtk]=400)
host=$(rustc -vV | sed -n 's/^host: //p')

build_guided() {
    if ! cargo +nightly --version >/dev/null 2>&1 || ! cargo fuzz --version >/dev/null 2>&1; then
        cat >&2 <<'END'
run.sh: NOTHING WAS FUZZED: a nightly toolchain or cargo-fuzz is not here.
    rustup toolchain install nightly --profile minimal
    cargo install cargo-fuzz
The committed corpus needs neither: run.sh --replay
END
        exit 3
    fi
    # There is no unsafe code to be caught by a sanitizer; without one more is tried in the same time.
    CARGO_TARGET_DIR=$out/guided cargo +nightly fuzz build --fuzz-dir "$here" --features coverage-guided --sanitizer none
}

guided() {
    local target each found=0 log program total=0
    build_guided
    each=$((seconds / ${#targets[@]}))
    ((each > 0)) || each=1
    echo "== ${#targets[@]} targets, $each s each"
    printf '%-14s %12s %9s %7s %7s %9s\n' target executions new edges corpus findings
    for target in "${targets[@]}"; do
        program=$out/guided/$host/release/$target log=$out/$target.log
        mkdir -p "$out/corpus/$target" "$out/findings/$target" "corpus/$target" "faults/$target"
        # 77: a finding; the log tells.
        "$program" "$out/corpus/$target" "corpus/$target" "faults/$target" -max_total_time="$each" -max_len="${longest[$target]:-300}" -timeout=20 -reload=0 \
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

# The fewest inputs that reach every edge which all inputs reach.
keep() {
    local target program fresh
    build_guided
    for target in "${targets[@]}"; do
        program=$out/guided/$host/release/$target fresh=$out/fresh/$target
        mkdir -p "$out/corpus/$target" "corpus/$target"
        rm -rf "$fresh" && mkdir -p "$fresh"
        "$program" -set_cover_merge=1 -use_counters=0 -max_len="${longest[$target]:-300}" "$fresh" "$out/corpus/$target" "corpus/$target" >"$out/$target.merge.log" 2>&1
        rm -rf "corpus/$target" && cp -r "$fresh" "corpus/$target"
        printf '%-14s %5d inputs %7d bytes\n' "$target" "$(find "corpus/$target" -type f | wc -l)" "$(cat "corpus/$target"/* | wc -c)"
    done
    printf 'in all %d bytes\n' "$(find corpus -type f -exec cat {} + | wc -c)"
}

replay() {
    CARGO_TARGET_DIR=$out/stable cargo run --quiet --example replay -- --random "$random" "${targets[@]}"
}

coverage() {
    local llvm
    llvm=$(rustc --print target-libdir)/../bin
    [[ -x $llvm/llvm-cov ]] || {
        echo 'run.sh: NOTHING WAS MEASURED: rustup component add llvm-tools' >&2
        exit 3
    }
    rm -f "$out"/coverage-*.profraw
    RUSTFLAGS=-Cinstrument-coverage CARGO_TARGET_DIR=$out/coverage cargo build --quiet --example replay
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
