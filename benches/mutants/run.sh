#!/usr/bin/env bash
# Breaks the sources in one place at a time, and checks that a suite of seconds fails. cargo-mutants
# lists the mutants. src/main.rs weaves all of a part into one program, so each mutant costs a run
# and no build. An interrupted run continues where it stopped.
#
#   run.sh [num] [query]      every mutant of src/num and src/query, against thinned judges
#   run.sh again              the survivors, against scenes and judges of the whole crate
#   run.sh rest               a sample of the mutants of world, motion, broad and scene against the
#                             same: numbers K, K + N, ...
#   run.sh scene              the same sample of src/scene alone; so for world, motion and broad
#   run.sh --of N --seed K    N and K of the sample (default 100, 7)
#   run.sh --seconds N ...    starts no run after N seconds (default 2700)
#   run.sh --shard K/N ...    every N-th run only, from K = 0: for several machines
#   run.sh --count            only counts the mutants, by module
#   run.sh --summary          only the known figures, and the survivors
#
# Exit 1: a mutant survived that survivors.md does not explain. Exit 3: cargo-mutants is missing.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
out=${CARGO_TARGET_DIR:-$root/target}/mutants
mkdir -p "$out"
out=$(cd "$out" && pwd)

parts=() seconds=2700 of=100 seed=7 shard=0/1 only=''
while (($#)); do
    case $1 in
    num | query | again | rest | world | motion | broad | scene) parts+=("$1") ;;
    --seconds | --of | --seed | --shard)
        declare "${1#--}=${2:?$1 needs a value}"
        shift
        ;;
    --count | --summary) only=${1#--} ;;
    *)
        sed -n '2,/^[^#]/s/^# \{0,1\}//p' "$here/run.sh" >&2
        exit 2
        ;;
    esac
    shift
done
((${#parts[@]})) || parts=(num query)

if ! cargo mutants --version >/dev/null 2>&1; then
    echo 'run.sh: cargo-mutants IS NOT HERE, nothing was checked: cargo install cargo-mutants --locked' >&2
    exit 3
fi

# By how much the judges' streams are thinned.
export TILESAT_CASES=400 TILESAT_FRAMES=400
export RUST_BACKTRACE=0
# A run takes up to a few seconds. More than this means an endless loop. Counts processor seconds,
# so that other load on the machine does not matter.
longest=8

# The unchanged tests, beside sources that will change. The copies get new time stamps: cargo then
# ignores what an interrupted run had changed.
make_tree() {
    local tree=$1
    rm -rf "$tree/src" "$tree/tests"
    mkdir -p "$tree"
    cp -r "$root"/{src,tests,README.md,LICENSE-MIT,Cargo.lock} "$tree"
    cp "$here/tree/thinned.rs" "$tree/tests"
    # It plays a game of the examples, which the tree lacks.
    sed -i '/^mod rollback;/d' "$tree/tests/bodies/main.rs"
    cp "$here/tree/Cargo.toml" "$tree"
    mkdir -p "$tree/.cargo" && cp "$root/.cargo/mutants.toml" "$tree/.cargo"
}

# Lists the mutants of a part as JSON.
list() {
    local module modules=("$1") files=()
    [[ $1 == again ]] && modules=(num query)
    [[ $1 == rest ]] && modules=(world motion broad scene)
    # Tests are not part of the library.
    for module in "${modules[@]}"; do files+=(--file "src/$module/**" --exclude "src/$module/**/tests.rs" --exclude "src/$module/tests/**"); done
    cargo mutants --in-place --list --json "${files[@]}"
}
# Prints which of the two suites checks a part.
suite_of() { [[ $1 == num || $1 == query ]] && echo pairs || echo rest; }
is_sample() { [[ $1 != again && $(suite_of "$1") == rest ]]; }
executables_of() {
    case $1 in
    num | query) echo thinned bodies casts pairs rays ;;
    motion) echo bodies casts motion rays segments solids tiles ;;
    scene) echo bodies ;;
    *) echo bodies motion rays segments solids tiles ;;
    esac
}
survivors() { awk -F'\t' '$2 == "survived" { print $3 }' "$out"/num/done.tsv "$out"/query/done.tsv; }

# Builds the programs of all mutants of a part, and their table: the suite, and the unit tests of
# the sources. Pairs also run the code of cores without a long multiply.
weave() {
    local part=$1 tree=$out/$1 target=$out/$1-target name
    local options=(--tests "$(executables_of "$part")")
    is_sample "$part" && options+=(--of "$of" --seed "$seed")
    [[ $part == again ]] && options+=(--only "$tree/names.txt") && survivors >"$tree/names.txt"
    make_tree "$tree"
    (cd "$tree" && list "$part" >list.json)
    CARGO_TARGET_DIR=$out/weave cargo build --quiet --package tilesat-mutants
    CARGO_TARGET_DIR=$target "$out/weave/debug/tilesat-mutants" "$tree/list.json" "$tree" "${options[@]}"
    rm -f "$tree"/program-*
    for name in $(executables_of "$part"); do
        program "$tree" "$target" "suite-$name" --test "$name"
        [[ $(suite_of "$part") == rest ]] || RUSTFLAGS='--cfg tilesat_split' program "$tree" "$target/split" "split-$name" --test "$name"
    done
    program "$tree" "$target" unit --lib
}
program() {
    local tree=$1 target=$2 name=$3
    (cd "$tree" && CARGO_TARGET_DIR=$target cargo test --quiet --package tilesat --profile mutants "${@:4}" --no-run --message-format json) |
        sed -n 's/.*"executable":"\([^"]*\)".*/\1/p' | xargs -I{} cp {} "$tree/program-$name"
}

# The tests of the whole crate: fast ones of seconds each, for what the others do not notice, and
# slow ones.
long=(neither_order_nor_broad mirrored_and_moved_scenes a_copy_is_a_snapshot no_body_enters_the_solid all_frames_of_four_pairs
    anything_over_anything every_small_velocity all_frames_of_all_exceptions every_neighbourhood_of_nine mosaics_are_their_outline
    at_rest_on_a_floor at_rest_on_a_corner what_is_left_is_what_the_raster contacts_equal_the closest_points_equal mirrored_scenes_give
    rays_equal_the_judge every_corner_of_four shape_features::every p17_boxes_rest_in_a_bowl convex_rest:: scene_13_a_wedge_narrower)
# Besides tests of more than these seconds, the last lines name what the thinned streams or the hook
# for panics break: tests of the rests that they find, of how much they saw, and of panics.
never=(at_rest_in_a_gap at_rest_on_a_one_way at_rest_in_a_corner a_million_frames as_many_on_ceiling p17_rest p17_pushed
    scene_38_a_stack a_ball_swings
    p17_between_a_slope_and_a_ceiling p17_balls_rest_over_a_narrow_gap what_lies_on_a_body turning_never_ends_inside
    no_arm_passes_a_body rays_see_the_union a_door_without_a_version are_named)

# Prints the tests of a program that can notice a mutant of a part within seconds. Prints nothing if
# there are none.
choose() {
    local skip=("${long[@]/#/--skip=}" "${never[@]/#/--skip=}")
    case $1/$2 in
    num/unit) chosen=(num::) ;;
    query/unit) chosen=(query::) ;;
    */unit) chosen=('' "${never[@]/#/--skip=}") ;;
    num/*-thinned | query/*-thinned) chosen=('') ;;
    num/*-bodies) chosen=(response_ratio::) ;;
    num/*-casts) chosen=(ranges::) ;;
    num/*-pairs) chosen=(convex_shapes::angles convex_shapes::radians convex_shapes::vectors degenerate:: distances:: number_types:: numbers:: push_out::) ;;
    query/*-casts) chosen=(classes:: corners:: mutants:: ranges::) ;;
    query/*-pairs) chosen=(closest_ties:: convex:: convex_symmetry:: degenerate:: distances:: exact:: mutants:: push_out::) ;;
    query/*-rays) chosen=(single::) ;;
    motion/suite-casts) chosen=(blocks:: scenes:: segments:: shapes:: "${skip[@]}") ;;
    motion/long-motion) chosen=("${long[@]}" alive_ assist:: bounce_curves:: by_flags:: convex_bodies:: inside:: long_runs:: memo:: pinch:: points::
        response_ same:: shape_scenes:: symmetry:: torture walk_joined:: walk_slopes:: walk_steps:: wedge:: "${never[@]/#/--skip=}") ;;
    motion/long-solids) chosen=('' "${never[@]/#/--skip=}") ;;
    */long-*) chosen=("${long[@]}" response_verlet:: "${never[@]/#/--skip=}") ;;
    scene/suite-bodies) chosen=('' --skip=broad --skip=sort_sweep "${never[@]/#/--skip=}") ;;
    */suite-bodies) chosen=(broad_pairs:: broad_removals:: pair_events:: response:: scene_rules:: scene_sleep:: "${skip[@]}") ;;
    */suite-motion) chosen=(floor:: mutants:: one_way:: response_gravity:: rest:: scenes:: segments:: walk_scenes:: "${skip[@]}") ;;
    */suite-rays) chosen=(shapes:: single:: "${skip[@]}") ;;
    */suite-segments) chosen=(build:: queries:: "${skip[@]}") ;;
    */suite-solids) chosen=(mutants:: push:: "${skip[@]}") ;;
    */suite-tiles) chosen=(blocks:: contacts:: features:: joined:: map:: mutants:: shape_features:: "${skip[@]}") ;;
    *) chosen=() ;;
    esac
}

# Runs the programs with a mutant, one after another, until one fails.
tell() {
    local part=$1 tree=$out/$1 id=$2 name program status chosen limit names=() executables
    read -ra executables <<<"$(executables_of "$part")"
    for name in suite split; do names+=("${executables[@]/#/$name-}"); done
    names+=(unit)
    [[ $(suite_of "$part") != rest ]] || names+=("${executables[@]/#/long-}")
    for name in "${names[@]}"; do
        # The long tests are in the same programs.
        program=$tree/program-${name/#long-/suite-}
        [[ -x $program ]] || continue
        choose "$part" "$name"
        ((${#chosen[@]})) || continue
        [[ $name == long-* || $name == unit ]] && limit=$((15 * longest)) || limit=$longest
        status=0
        # Unit tests compare short answers with exact ones: of few pairs, too few are near.
        (ulimit -t "$limit" && if [[ $name == unit ]]; then unset TILESAT_CASES; fi &&
            MUTANT=$id exec "$program" "${chosen[@]}") >"$tree/last.txt" 2>&1 || status=$?
        case $status in
        0) ;;
        # Killed for its time.
        137 | 152) echo timeout && return ;;
        *) echo caught && return ;;
        esac
    done
    echo survived
}

run_part() {
    local part=$1 tree=$out/$1 source tests id verdict name told began=$SECONDS done=0
    source=$(find "$root/src" -name '*.rs' | sort | xargs awk 'FNR == 1 { on = 1 } /^#\[cfg\(test\)\]/ { held = $0; next }
        /^mod tests \{/ { on = 0 } on && NF { print held $0 } { held = "" }' | cksum | cut -d' ' -f1)
    is_sample "$part" && source+=-$of-$seed
    tests=$(find "$here/tree" "$root/tests" "$root/src" -name '*.rs' | sort | xargs cat | cksum | cut -d' ' -f1)
    [[ $part == again ]] && tests+=-$(survivors | cksum | cut -d' ' -f1)
    mkdir -p "$tree" && touch "$tree/done.tsv"
    if [[ $(cat "$tree/state" 2>/dev/null) != "$source $tests" ]]; then
        echo "== $part: weaving"
        weave "$part"
        # Tests only become more: a mutant that a test noticed stays noticed.
        if [[ $(cut -d' ' -f1 "$tree/state" 2>/dev/null) == "$source" ]]; then
            grep -v '	survived	' "$tree/done.tsv" >"$tree/kept.tsv" || true
            mv "$tree/kept.tsv" "$tree/done.tsv"
        else
            : >"$tree/done.tsv"
        fi
        echo "$source $tests" >"$tree/state"
    fi
    # In a broken program every mutant would seem caught.
    if [[ $(tell "$part" 0) != survived ]]; then
        tail -40 "$tree/last.txt" >&2
        echo "run.sh: the suite of $part fails without a mutant" >&2
        exit 1
    fi
    echo "== $part: $(wc -l <"$tree/mutants.tsv") mutants, $(grep -c woven "$tree/mutants.tsv") in one program, $(wc -l <"$tree/done.tsv") known"
    while IFS=$'\t' read -r id verdict name; do
        ((id % ${shard#*/} == ${shard%/*})) || continue
        [[ $verdict == woven ]] || continue
        grep -q "^$id	" "$tree/done.tsv" && continue
        if ((SECONDS >= seconds)); then
            echo "== $part: the time is over; the same command goes on from here"
            return
        fi
        told=$(tell "$part" "$id")
        printf '%s\t%s\t%s\n' "$id" "$told" "$name" >>"$tree/done.tsv"
        [[ $told == survived ]] && echo "   survived: $name"
        done=$((done + 1))
        ((done % 50)) || echo "== $(date +%H:%M:%S) $part: $done runs, $(((SECONDS - began) * 1000 / done)) ms each"
    done <"$tree/mutants.tsv"
}

# Prints figures by part, and the survivors that survivors.md does not name by file and text. Lines
# may move.
summary() {
    local part name unknown=0 tree verdict
    printf '%-8s %9s %9s %9s %9s %9s %9s %9s\n' part mutants caught timeout survived unviable constant 'not run'
    for part in num query again rest world motion broad scene; do
        tree=$out/$part
        [[ -f $tree/mutants.tsv ]] || continue
        awk -F'\t' -v part="$part" 'FILENAME ~ /done/ { n[$2]++; next } { n[$2]++; all++ }
            END { ran = n["caught"] + n["timeout"] + n["survived"]
                printf "%-8s %9d %9d %9d %9d %9d %9d %9d\n", part, all, n["caught"], n["timeout"], n["survived"], n["unviable"], n["constant"], n["woven"] - ran }' \
            "$tree/done.tsv" "$tree/mutants.tsv"
    done
    while read -r name; do
        grep -qF -- "$name" "$here/survivors.md" && continue
        echo "survived, not explained: $name"
        unknown=1
    done < <(cat "$out"/{again,num,query,rest,world,motion,broad,scene}/done.tsv 2>/dev/null | awk -F'\t' '$2 == "survived" && !($3 in caught) { print $3 } $2 != "survived" { caught[$3] }' | sed -E 's/:[0-9]+:[0-9]+:/:/' | sort -u)
    return $unknown
}

case $only in
count)
    make_tree "$out/count"
    for part in num query world motion broad scene; do
        printf '%-8s %6d\n' "$part" "$(cd "$out/count" && list "$part" | grep -c "\"name\":")"
    done
    exit
    ;;
summary)
    summary
    exit
    ;;
esac
for part in "${parts[@]}"; do
    run_part "$part"
done
summary
