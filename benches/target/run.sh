#!/usr/bin/env bash
# Prints what queries cost on a Cortex-M0 and a Cortex-M3: instructions and stack (in the emulator) and flash, and compares all with
# the reviewed table counts.txt.
#
#   run.sh                 print and compare; exit 1 where a row is over budget or moved by more than 2 %
#   run.sh --accept        print, make this the reviewed table, and write it into the README and the guide to broad phases
#   run.sh --readme        only write the reviewed table into the README and the guide
#   run.sh --symbols BIN   what the flash program BIN links (src/bin), with sizes, on both cores
#   run.sh --flash-only    no emulator: flash alone
#   run.sh --no-panic      only the proof that nothing panics: exit 1 where a program of everything links a panic or a 64-bit division
#   run.sh --bodies        only broad phases: measure, and print their table as Markdown
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
cd "$here"
out=${CARGO_TARGET_DIR:-$here/../../target}/benches
mkdir -p "$out"
out=$(cd "$out" && pwd)
export CARGO_TARGET_DIR=$out

accept=0 symbols='' counts=1 measure=1 bodies=0 proof=0
while (($#)); do
    case $1 in
    --accept) accept=1 ;;
    --flash-only) counts=0 ;;
    --readme) measure=0 ;;
    --bodies) bodies=1 ;;
    --no-panic) proof=1 ;;
    --symbols)
        symbols=${2:?--symbols needs the name of a program in flash/src/bin}
        shift
        ;;
    *)
        sed -n '2,13s/^# \{0,1\}//p' "$here/run.sh" >&2
        exit 2
        ;;
    esac
    shift
done

# file : mark : what makes a table of counts.txt. The file's table is between two marks.
tables=(README.md:counts:readme.awk src/broad/guide.md:bodies:bodies.awk)
root=$here/../..
with_table() {
    awk -v begin="<!-- $2:begin" -v end="<!-- $2:end" -v table="awk -f $3 counts.txt" '
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

cores=(M0:thumbv6m-none-eabi M3:thumbv7m-none-eabi)
llvm=$(rustc --print target-libdir)/../bin

# program : name in the table : budget in bytes on the M0, the 46 bytes of the quoted empty program included
# The ray's goal is 1100; closed corners, starts on lines and three kinds of outside have not been made to fit it yet.
programs=(
    'aabb_overlaps:AABB-AABB overlaps:120'
    'circle_overlaps:circle-circle overlaps:260'
    'circle_aabb_overlaps:circle-AABB overlaps:0'
    'circle_segment_overlaps:circle-segment overlaps:0'
    'unit_normal:unit normal:0'
    'circle_contact:circle-circle contact:0'
    'cast_ray:ray, Blocks:2700'
    'cast_ray_slopes:ray, Slopes:0'
    'cast_ray_shapes:ray, AllShapes:0'
    'move_aabb:move_and_slide, AABB, Blocks:0'
    'move_aabb_slopes:move_and_slide, AABB, Slopes:0'
    'move_aabb_shapes:move_and_slide, AABB, AllShapes:0'
    'move_circle:move_and_slide, circle, Blocks:0'
    'move_circle_slopes:move_and_slide, circle, Slopes:0'
    'move_circle_shapes:move_and_slide, circle, AllShapes:0'
    'move_circle_surface:move_and_slide, circle, AllShapes, friction:0'
    'ride_aabb:ride on solids, AABB, Blocks:0'
    'ride_circle:ride on solids, circle, Blocks:0'
    'solids_aabb:a game with solids, AABB, Blocks:0'
    'solids_circle:a game with solids, circle, Blocks:0'
    'pairs_brute:broad phase of 64, brute:0'
    'pairs_sweep:broad phase of 64, sweep:0'
    'pairs_grid:broad phase of 64, grid:0'
    'pairs_hash:broad phase of 64, hash:0'
)

build_flash() {
    cargo build --quiet --profile flash --package tilesat-flash --bins --target "$1"
}
# Bytes of flash: code, constants and initialised data.
flash_of() {
    "$llvm/llvm-size" "$out/$1/$2" | awk 'NR == 2 { print $1 + $2 }'
}

if [[ -n $symbols ]]; then
    for core in "${cores[@]}"; do
        target=${core#*:}
        build_flash "$target"
        echo "$symbols on ${core%:*}: $(flash_of "$target/flash" "$symbols") B, of which the frame is $(flash_of "$target/flash" empty) B"
        "$llvm/llvm-nm" --demangle --print-size --size-sort --reverse-sort --radix=d "$out/$target/flash/$symbols" |
            awk '{ size = $2 + 0; $1 = $2 = $3 = ""; printf "%6d  %s\n", size, $0 }'
    done
    exit 0
fi

# The proof that nothing panics: programs that hold every public function, at both ends of what a firmware is built with. All panics
# end in the_panic, which cannot be inlined; long divisions and 128 bits are refused too.
refused='the_panic|rust_begin_unwind|core::panicking|_fail(ed)?(::h[0-9a-f]+)?$|__aeabi_u?ldivmod|__u?(div|mod|divmod)di[34]|__(u?(div|mod|divmod)|mul|ash[lr]|lshr)ti[345]'
# The flags of .cargo for Arm; for RISC-V they would ask for the layout of a board.
build_proof() {
    RUSTFLAGS=-Clink-arg=-Tlink.x cargo build --quiet --profile "$1" --package tilesat-flash --bin 'everything_*' --target "$2"
}
# Who calls what is refused, from which line, innermost of what was inlined: built once more, with lines.
callers() {
    local name=${2//-/_}
    (export "CARGO_PROFILE_${name^^}_DEBUG=line-tables-only" && build_proof "$2" "$1")
    "$llvm/llvm-objdump" --disassemble --line-numbers --demangle --no-show-raw-insn "$out/$1/$2/$3" | awk -v refused="$refused" '
        /^[0-9a-f]+ <.*>:$/ { caller = $0; gsub(/^[0-9a-f]+ <|>:$/, "", caller) }
        /^; .*:[0-9]+$/ { at = substr($0, 3) }
        /^ .*<.*>$/ && caller !~ refused {
            callee = $0
            gsub(/^[^<]*<|>$/, "", callee)
            if (callee ~ refused) print "    " callee " in " caller ", " at
        }' | sort -u
}
# prove PROFILE...
prove() {
    local profile target source bin found bad=0
    for profile in "$@"; do
        for target in thumbv6m-none-eabi riscv32imc-unknown-none-elf; do
            build_proof "$profile" "$target"
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
    ((!bad)) || { echo 'run.sh: the library links what it must not' >&2; exit 1; }
}
if ((proof)); then
    prove flash flash-fast
    exit 0
fi

# Crowds do not fit the micro:bit: code for either core runs on the board of the M3.
count_bodies() {
    cargo build --quiet --release --package tilesat-counts --bin broad --target "$1"
    "$here/../../.ci/qemu.sh" thumbv7m-none-eabi "$out/$1/release/broad"
}
if ((bodies)); then
    for core in "${cores[@]}"; do
        count_bodies "${core#*:}"
    done | awk -f bodies.awk
    exit 0
fi

# Lines a|b|c|d|e as columns; no budget is shown as nothing.
line() {
    awk -F'|' '{ sub(/^0$/, "", $5); printf "%-8s | %-46s | %-22s | %-22s | %s\n", $1, $2, $3, $4, $5 }' | sed 's/ *$//'
}

fresh=$out/fresh.txt
rustc --version >"$fresh"
{
    echo
    echo 'Instructions: mean (least..most) of 64 inputs. Kernel: operands in registers. API: the call by reference.'
    echo 'core|query, class of inputs|kernel|API|kernel budget' | line
} >>"$fresh"
measured=$out/measured.txt
if ((counts)); then
    for core in "${cores[@]}"; do
        cargo run --quiet --release --package tilesat-counts --target "${core#*:}"
        cargo run --quiet --release --package tilesat-counts --bin solids --target "${core#*:}"
        count_bodies "${core#*:}"
        cargo run --quiet --release --package tilesat-counts --bin scene --target "${core#*:}"
    done >"$measured"
    grep '^M[0-9]*|' "$measured" | line >>"$fresh"
    {
        echo
        echo 'Bytes of stack below the caller, the most of 64 inputs at opt-level 3: operands and answer are not counted, they are the caller'"'"'s.'
        echo 'core|query, class of inputs|most|most|budget' | line
        grep '^M[0-9]* stack|' "$measured" | line
        echo
        echo 'Instructions a frame of N bodies that all move, and all pairs: mean (least..most). The boxes are at hand; 6 to 24 units, 32 cells, up to 2 a frame.'
        echo 'fixed: 1024 x 768; density: 64 x 64 each; cluster: all in 256 x 256.'
        echo 'core|bodies, world|plain|filters, each by name|plain budget' | line
        grep '^M[0-9]* pairs|' "$measured" | line
        echo
        echo 'Bytes of RAM of N bodies, with a grid for 1024 x 768.'
        echo 'core|bodies|plain|filters|budget' | line
        grep '^M[0-9]* size|' "$measured" | line
    } >>"$fresh"
    # The goal is 512 for every query; motion, contacts, nearest points and rays among all shapes have not been made to fit it yet.
    awk -F'|' '$1 ~ /stack/ && $3 > 512 { n++ } $1 ~ /stack/ && $3 > most { most = $3; row = $1 " " $2 }
        END { printf "%d rows take more than 512 B of stack, the most %d: %s\n", n, most, row }' "$measured"
fi
{
    echo
    echo 'Bytes of flash at opt-level "s", everything pulled in. Net: without the frame. With: 46 bytes for an empty program.'
    echo 'core|query|with|net|budget' | line
} >>"$fresh"
for core in "${cores[@]}"; do
    target=${core#*:}
    build_flash "$target"
    empty=$(flash_of "$target/flash" empty)
    for program in "${programs[@]}"; do
        IFS=: read -r bin name budget <<<"$program"
        [[ ${core%:*} == M0 ]] || budget=0
        net=$(($(flash_of "$target/flash" "$bin") - empty))
        echo "${core%:*} flash|$name|$((net + 46))|$net|$budget" | line >>"$fresh"
    done
done

# A static level costs no RAM: the linker's sizes of initialised and zeroed data.
for core in "${cores[@]}"; do
    ram=$("$llvm/llvm-size" "$out/${core#*:}/flash/static_levels" | awk 'NR == 2 { print $2 + $3 }')
    echo "${core%:*} RAM|two static levels|$ram|$ram|0" | line >>"$fresh"
    ((ram == 0)) || { echo "run.sh: static levels take $ram B of RAM" >&2; exit 1; }
done

# At the level of optimisation that firmware is shipped with; --no-panic proves both.
prove flash
cat "$fresh"
if ((accept)); then
    ((counts)) || { echo 'run.sh: --accept needs the counts as well' >&2; exit 2; }
    cp "$fresh" counts.txt
    write_tables
    echo "counts.txt, the README's table and the guide's are now this: review the difference before it is committed"
fi
reviewed=counts.txt
if ! ((counts)); then
    reviewed=$out/reviewed-flash.txt
    grep -E ' (flash|RAM) ' counts.txt >"$reviewed"
fi
same=0 stale=0
if [[ $(head -n 1 counts.txt) == "$(head -n 1 "$fresh")" ]]; then
    same=1
else
    echo "counts.txt was made by $(head -n 1 counts.txt): differences are told, only budgets fail"
fi
for entry in "${tables[@]}"; do
    IFS=: read -r file mark script <<<"$entry"
    if ! cmp -s <(with_table "$file" "$mark" "$script") "$root/$file"; then
        stale=1
        echo "the table in $file is not that of counts.txt: benches/target/run.sh --readme writes it"
    fi
done
echo
awk -v same_compiler=$same -f compare.awk "$reviewed" "$fresh" && ((!stale))
