#!/usr/bin/env bash
# Measures the costs of queries and compares them with the reviewed tables of counts.txt. Counts
# instructions on five cores, cycles on a sixth, and stack, in the emulator. Takes flash, static RAM
# and bounds of the stack from the linker's output.
#
#   run.sh                 prints and compares; exit 1 if a number is over budget or moved by > 2 %,
#                          or if a budget below is not that of counts.txt
#   run.sh --accept        prints, makes these the reviewed tables, and writes them into the README,
#                          the guide, src/boards.md and src/broad/guide.md
#   run.sh --readme        only writes the reviewed tables there
#   run.sh --symbols BIN   prints the symbols that the flash program BIN (src/bin) links, with sizes
#   run.sh --short         prints and compares the tables of the Cortex-M0 only, and counts at
#                          optimisation level 3 only
#   run.sh --core CORE     prints and compares queries, motion and scenes on one core only
#                          (M0, M3, M4F, M33, RV32)
#   run.sh --flash-only    needs no emulator: only flash, RAM and bounds
#   run.sh --no-panic      only proves that nothing panics; exit 1 if a program of everything links
#                          a panic or a 64-bit division
#   run.sh --bodies        only measures broad phases, and prints their table as Markdown
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
cd "$here"
out=${CARGO_TARGET_DIR:-$here/../../target}/benches
mkdir -p "$out"
out=$(cd "$out" && pwd)
export CARGO_TARGET_DIR=$out RUSTC_WRAPPER=$here/../../.ci/rustc.sh

accept=0 symbols='' only_core='' counts=1 measure=1 bodies=0 proof=0 short=0
while (($#)); do
    case $1 in
    --accept) accept=1 ;;
    --flash-only) counts=0 ;;
    --readme) measure=0 ;;
    --bodies) bodies=1 ;;
    --no-panic) proof=1 ;;
    --short) short=1 ;;
    --core)
        only_core=${2:?--core needs the name of a core}
        shift
        ;;
    --symbols)
        symbols=${2:?--symbols needs the name of a program in flash/src/bin}
        shift
        ;;
    *)
        sed -n '2,/^[^#]/s/^# \{0,1\}//p' "$here/run.sh" >&2
        exit 2
        ;;
    esac
    shift
done

# File, mark, and the command that makes a table of counts.txt. The file's table is between two
# marks.
tables=(
    README.md:short:short.awk
    guide/a_board_from_zero.md:stack:'short.awk -v page=board'
    guide/many_bodies.md:flash:'short.awk -v page=scenes'
    src/boards.md:counts:readme.awk
    src/broad/guide.md:bodies:bodies.awk
    src/scene/set.rs:costs:scene.awk
)
root=$(cd ../.. && pwd)
with_table() {
    awk -v begin="<!-- $2:begin" -v end="<!-- $2:end" -v table="awk -f read.awk -f $3 counts.txt" '
        index($0, begin) { print; while ((table | getline row) > 0) print row; inside = 1 }
        index($0, end) { inside = 0 }
        !inside' "$root/$1"
}
write_tables() {
    local file mark script
    for entry in "${tables[@]}"; do
        IFS=: read -r file mark script <<<"$entry"
        with_table "$file" "$mark" "$script" >"$out/table.md"
        cat "$out/table.md" >"$root/$file"
    done
}
if ((!measure)); then
    write_tables
    exit 0
fi

# The cores of the flash table. Rows of queries, motion and scenes run on more cores, crowds on
# these.
cores=(M0:thumbv6m-none-eabi M3:thumbv7m-none-eabi)
counted=("${cores[@]}" M4F:thumbv7em-none-eabihf M33:thumbv8m.main-none-eabihf RV32:riscv32imc-unknown-none-elf)
# The two ends of multiplication: none of 64 bits, and all of it.
proved=(thumbv6m-none-eabi riscv32imc-unknown-none-elf)
# Columns that could not be measured, or that the caller left out.
absent=()
if ((short)); then
    absent=('M0 at s' M3 M4F M33 RV32)
    cores=("${cores[0]}") counted=("${cores[0]}") proved=("${proved[0]}")
fi
llvm=$(rustc --print target-libdir)/../bin

# Program, name in the table, and budget in bytes of flash on the M0, with the 46 bytes of the
# quoted empty program. The goal of the ray is 1100. It does not fit yet: closed corners, starts on
# lines and three kinds of outside.
programs=(
    'aabb_overlaps:AABB-AABB overlaps:120'
    'circle_overlaps:circle-circle overlaps:260'
    'circle_aabb_overlaps:circle-AABB overlaps:0'
    'circle_segment_overlaps:circle-segment overlaps:0'
    'unit_normal:unit normal:0'
    'circle_contact:circle-circle contact:0'
    'turned_overlaps:turned boxes overlap:0'
    'any_overlaps:shapes of any kind overlap:0'
    'cast_ray:ray, Blocks:3200'
    'cast_ray_slopes:ray, Slopes:0'
    'cast_ray_shapes:ray, AllShapes:0'
    'move_aabb:move_and_slide, AABB, Blocks:0'
    'move_aabb_slopes:move_and_slide, AABB, Slopes:0'
    'move_aabb_shapes:move_and_slide, AABB, AllShapes:0'
    'move_circle:move_and_slide, circle, Blocks:0'
    'move_circle_slopes:move_and_slide, circle, Slopes:0'
    'move_circle_shapes:move_and_slide, circle, AllShapes:0'
    'move_circle_surface:move_and_slide, circle, AllShapes, friction:0'
    'move_capsule:move_and_slide, capsule, Blocks:0'
    'move_capsule_shapes:move_and_slide, capsule, AllShapes:0'
    'move_turned:move_and_slide, turned box, Blocks:0'
    'move_turned_shapes:move_and_slide, turned box, AllShapes:0'
    'ride_aabb:ride on solids, AABB, Blocks:0'
    'ride_circle:ride on solids, circle, Blocks:0'
    'ride_convex:ride on convex solids, circle, Blocks:0'
    'solids_aabb:a game with solids, AABB, Blocks:0'
    'solids_circle:a game with solids, circle, Blocks:0'
    'pairs_brute:broad phase of 64, brute:0'
    'pairs_sweep:broad phase of 64, sweep:0'
    'pairs_grid:broad phase of 64, grid:0'
    'pairs_hash:broad phase of 64, hash:0'
)

# Program, name in the table, and ceilings of flash and of static RAM on the M0 and on the M3. These
# are whole games.
games=(
    'game_blocks:33 bodies among blocks, coins, ladders:46500:2400:45500:2400'
    'game_ninja:a ninja among all shapes:44000:64:44000:64'
    'game_top_down:a game seen from above:13000:64:13000:64'
    'hero_blocks:a hero among blocks:24400:136:24300:136'
    'hero_slopes:a hero among slopes:43200:136:42700:136'
    'hero_blocks_lift:a hero among blocks with a lift:37500:172:37500:172'
    'hero_slopes_lift:a hero among slopes with a lift:57100:172:56000:172'
    'hero_slopes_plank:a hero among slopes with a plank that turns:71900:224:71900:224'
    'scene_blocks:a scene of 30 balls and boxes, among blocks:89000:6000:86500:6000'
    'scene_blocks_lifts:a scene of 30 balls and boxes with lifts, among blocks:101500:6000:99000:6000'
    'scene_blocks_hero:a scene of 30 balls and boxes with a hero, among blocks:109500:6000:106500:6000'
    'scene_blocks_planks:a scene of 30 balls and boxes with planks, among blocks:132000:6000:132000:6000'
    'game_bullets:240 bullets, 32 enemies, pairs and events:70500:13800:70500:13800'
)

# build_flash TARGET...: builds all but the programs of everything, which are large and belong to
# the proof.
build_flash() {
    local source bins=()
    for source in flash/src/bin/*.rs; do
        [[ $source == */everything_* ]] || bins+=(--bin "$(basename "$source" .rs)")
    done
    cargo build --quiet --profile flash --package tilesat-flash "${bins[@]}" "${@/#/--target=}"
}
# Bytes of flash: code, constants and initialised data.
flash_of() {
    "$llvm/llvm-size" "$out/$1/$2" | awk 'NR == 2 { print $1 + $2 }'
}

# Bytes of initialised and zeroed data.
ram_of() {
    "$llvm/llvm-size" "$out/$1/$2" | awk 'NR == 2 { print $2 + $3 }'
}

# Bytes of initialised data: they take both flash and RAM.
image_of() {
    "$llvm/llvm-size" "$out/$1/$2" | awk 'NR == 2 { print $2 + 0 }'
}

if [[ -n $symbols ]]; then
    build_flash "${cores[@]#*:}"
    for core in "${cores[@]}"; do
        target=${core#*:}
        echo "$symbols on ${core%:*}: $(flash_of "$target/flash" "$symbols") B, including $(flash_of "$target/flash" empty) B of the frame"
        "$llvm/llvm-nm" --demangle --print-size --size-sort --reverse-sort --radix=d "$out/$target/flash/$symbols" |
            awk '{ size = $2 + 0; $1 = $2 = $3 = ""; printf "%6d  %s\n", size, $0 }'
    done
    exit 0
fi

# The proof that nothing panics, with programs that hold every public function, at two optimisation
# levels. All panics end in the_panic, which cannot be inlined. It refuses long divisions and 128
# bits as well.
refused='the_panic|rust_begin_unwind|core::panicking|_fail(ed)?(::h[0-9a-f]+)?$|__aeabi_u?ldivmod|__u?(div|mod|divmod)di[34]|__(u?(div|mod|divmod)|mul|ash[lr]|lshr)ti[345]'
# The flags of .cargo are for Arm. For RISC-V they would ask for a board's layout.
build_proof() {
    RUSTFLAGS=-Clink-arg=-Tlink.x cargo build --quiet --profile "$1" --package tilesat-flash --bin 'everything_*' "${@:2}"
}
# Prints the callers of a refused symbol with their lines, innermost inlined function first. Builds
# once more, with line tables.
callers() {
    local name=${2//-/_}
    (export "CARGO_PROFILE_${name^^}_DEBUG=line-tables-only" && build_proof "$2" --target "$1")
    "$llvm/llvm-objdump" --disassemble --line-numbers --demangle --no-show-raw-insn "$out/$1/$2/$3" | awk -v refused="$refused" '
        /^[0-9a-f]+ <.*>:$/ { caller = $0; gsub(/^[0-9a-f]+ <|>:$/, "", caller) }
        /^; .*:[0-9]+$/ { at = substr($0, 3) }
        /^ .*<.*>( *@.*)?$/ && caller !~ refused {
            callee = $0
            gsub(/^[^<]*<|>( *@.*)?$/, "", callee)
            if (callee ~ refused) print "    " callee " in " caller ", " at
        }' | sort -u
}
# prove PROFILE...
prove() {
    local profile target source bin found bad=0
    for profile in "$@"; do
        build_proof "$profile" "${proved[@]/#/--target=}"
        for target in "${proved[@]}"; do
            for source in flash/src/bin/everything_*.rs; do
                bin=$(basename "$source" .rs)
                found=$("$llvm/llvm-nm" --demangle --format=just-symbols "$out/$target/$profile/$bin" | grep -E "$refused" | sort -u | paste -sd ' ' || true)
                echo "$profile $target $bin: $(flash_of "$target/$profile" "$bin") B, ${found:-ok}"
                if [[ -n $found ]]; then
                    bad=1
                    callers "$target" "$profile" "$bin"
                fi
            done
        done
    done
    ((!bad)) || { echo 'run.sh: the library links a panic or a long operation' >&2; exit 1; }
}
if ((proof)); then
    prove flash flash-fast
    exit 0
fi

# The model slows the emulator down, and crowds are large.
export QEMU_SECONDS=${QEMU_SECONDS:-600}
# run_on TARGET BIN [BOARD]: runs a counting firmware, on another board if one is named.
run_on() {
    "$root/.ci/qemu.sh" "${3:-$1}" "$out/$1/counted/$2"
}
# build_counts "TARGET..." PROGRAM...: builds for all targets at once, so that no core of this
# computer waits for the last program of a target. `profile=NAME` before it takes another profile
# than `counted`.
build_counts() {
    local targets
    read -ra targets <<<"$1"
    shift
    echo "building the counting firmwares $* for ${targets[*]}" >&2
    cargo build --quiet --profile "${profile:-counted}" --package tilesat-counts --features chip "${targets[@]/#/--target=}" "${@/#/--bin=}"
}
# Crowds do not fit the micro:bit. The M3's board runs the code of both cores.
run_crowds() { run_on "$1" crowds thumbv7m-none-eabi; }
if ((bodies)); then
    build_counts "${cores[*]#*:}" crowds
    for core in "${cores[@]}"; do
        run_crowds "${core#*:}"
    done | awk -f pivot.awk | awk -f read.awk -f bodies.awk
    exit 0
fi

if [[ -n $only_core ]]; then
    for core in "${counted[@]}"; do
        [[ $core == "$only_core":* ]] && chosen=("$core") || absent+=("${core%:*}")
    done
    [[ -n ${chosen:-} ]] || { echo "run.sh: there is no core $only_core" >&2; exit 2; }
    [[ $only_core == M0 ]] || absent+=('M0 at s' 'M0+ cycles')
    counted=("${chosen[@]}")
fi
# The emulator's plugin that models cycles. Sets $model to its options, if the emulator accepts it.
model=''
find_plugin() {
    local told
    cargo build --quiet --profile unlinked --package tilesat-cycles
    model="-plugin $out/unlinked/libtilesat_cycles.so -d plugin"
    told=$(QEMU_OPTIONS=$model run_on thumbv6m-none-eabi pairs 2>&1 | grep -c '^instructions [0-9]* cycles [0-9]*$') || true
    if ((!told)); then
        model=''
        absent+=('M0+ cycles')
        echo 'NO CYCLES OF THE M0+: this emulator does not load the plugin that models them (it uses version 1 of the interface, as in QEMU 7.2)'
    fi
}

# run_modelled TARGET BIN: prints instructions and the plugin's cycles.
run_modelled() {
    if ! QEMU_OPTIONS=$model run_on "$1" "$2" >"$out/$2.merged" 2>&1; then
        grep -v '^instructions' "$out/$2.merged" >&2
        return 1
    fi
    awk -f cycles.awk "$out/$2.merged"
}

# run_at_s TARGET BIN: runs the firmware at the level of optimisation of the flash tables. Budgets
# are those of the other level.
run_at_s() {
    "$root/.ci/qemu.sh" "$1" "$out/$1/flash/$2" | sed -n 's/^M0|\(.*\)|[0-9]*$/M0 at s|\1|0/p'
}

# Prints the lines core|section|row|value|budget of all firmwares. They run while the next ones
# build.
measure_all() {
    local core target bin how present=() runs=() run
    start() { "$@" >"$out/${#runs[@]}.part" & runs+=($!); }
    for core in "${counted[@]}"; do
        if [[ $core == *:riscv32* ]] && ! "$root/.ci/get-emulators.sh" riscv32 >/dev/null; then
            absent+=("${core%:*}")
            echo "NOT COUNTED ON ${core%:*}: there is no emulator"
        else
            present+=("$core")
        fi
    done
    local firmwares=(pairs levels capsules convex planks segments bodies memory heroes)
    build_counts "${present[*]#*:}" "${firmwares[@]}"
    for core in "${present[@]}"; do
        target=${core#*:} how=run_on
        [[ $core != M0:* ]] || find_plugin
        [[ $core != M0:* || -z $model ]] || how=run_modelled
        for bin in "${firmwares[@]}"; do
            # Of heroes no cycles are modelled: a row is thousands of frames.
            [[ $bin != heroes ]] || how=run_on
            start "$how" "$target" "$bin"
        done
        [[ $core == M0:* ]] && ((!short)) || continue
        profile=flash build_counts "$target" "${firmwares[@]}"
        for bin in "${firmwares[@]}"; do
            start run_at_s "$target" "$bin"
        done
    done
    if [[ -z $only_core ]]; then
        build_counts "${cores[*]#*:}" crowds
        for core in "${cores[@]}"; do
            start run_crowds "${core#*:}"
        done
        build_flash "${cores[@]#*:}"
    fi
    for run in "${!runs[@]}"; do
        wait "${runs[run]}" || return
        cat "$out/$run.part" >>"$lines"
    done
}

fresh=$out/fresh.txt lines=$out/lines.txt
: >"$lines"
if ((counts)); then
    measure_all
    # The goal is 512 for every query. Motion, contacts, nearest points and rays among all shapes do
    # not fit it yet.
    awk -F'|' '$2 == "stack" && $4 > 512 { n++ } $2 == "stack" && $4 > most { most = $4; row = $1 ", " $3 }
        END { printf "%d rows take more than 512 B of stack, at most %d: %s\n", n, most, row }' "$lines"
fi
# Flash and static RAM of every program, and bounds of the stack of every function.
measure_links() {
    local core target name empty program game bin row budget flash ram flash_m3 ram_m3 image source
    build_flash "${cores[@]#*:}"
    for core in "${cores[@]}"; do
        target=${core#*:} name=${core%:*}
        empty=$(flash_of "$target/flash" empty)
        for program in "${programs[@]}"; do
            IFS=: read -r bin row budget <<<"$program"
            [[ $name == M0 ]] || budget=0
            echo "$name|flash|$row|$(($(flash_of "$target/flash" "$bin") - empty + 46))|$budget"
        done
        for game in "${games[@]}"; do
            IFS=: read -r bin row flash ram flash_m3 ram_m3 <<<"$game"
            [[ $name == M0 ]] || flash=$flash_m3 ram=$ram_m3
            echo "$name|game flash|$row|$(flash_of "$target/flash" "$bin")|$flash"
            echo "$name|RAM|$row|$(ram_of "$target/flash" "$bin")|$ram"
        done
        # A static level costs no RAM.
        ram=$(ram_of "$target/flash" static_levels)
        echo "$name|RAM|two static levels|$ram|0"
        ((ram == 0)) || { echo "run.sh: static levels take $ram B of RAM" >&2; exit 1; }
        # Without bodies a static scene is all zero, and so is a game with its own lists. They have
        # no image in flash.
        for bin in scene_blocks scene_blocks_lifts scene_blocks_hero scene_blocks_planks game_bullets; do
            image=$(image_of "$target/flash" "$bin")
            ((image == 0)) || { echo "run.sh: the static of $bin takes $image B of flash" >&2; exit 1; }
        done
    done >>"$lines"

    # Uses the optimisation level of shipped firmware. --no-panic proves both levels.
    prove flash
    for source in flash/src/bin/everything_*.rs; do
        bin=$(basename "$source" .rs)
        "$llvm/llvm-objdump" --disassemble --show-all-symbols --no-show-raw-insn "$out/thumbv6m-none-eabi/flash/$bin" | awk -v part="${bin#everything_}" -f bound.awk
    done >>"$lines"
}
[[ -n $only_core ]] || measure_links

{
    rustc --version
    awk -f pivot.awk "$lines"
} >"$fresh"
cat "$fresh"
without=$(IFS=';'; echo "${absent[*]:-}")
if ((accept)); then
    ((counts)) && [[ -z $without$only_core ]] || { echo "run.sh: --accept needs all counts, but has none of: ${without:-any core}" >&2; exit 2; }
    cp "$fresh" counts.txt
    write_tables
    echo "counts.txt and the pages' tables are updated: review the difference before you commit it"
fi
only=''
((counts)) || only='flash;game flash;RAM;bound'
[[ -z $only_core ]] || only='kernel;reference;scenes;frames;stack'
same=0 stale=0
if [[ $(head -n 1 counts.txt) == "$(head -n 1 "$fresh")" ]]; then
    same=1
else
    echo "counts.txt comes from $(head -n 1 counts.txt): reports differences, and fails only for budgets"
fi
for entry in "${tables[@]}"; do
    IFS=: read -r file mark script <<<"$entry"
    if ! cmp -s <(with_table "$file" "$mark" "$script") "$root/$file"; then
        stale=1
        echo "the table in $file differs from counts.txt: benches/chips/run.sh --readme writes it"
    fi
done
[[ -z $without ]] || echo "NOT MEASURED, so not compared: $without"
echo
awk -v same_compiler=$same -v only="$only" -v without="$without" -f read.awk -f compare.awk counts.txt "$fresh" && ((!stale))
