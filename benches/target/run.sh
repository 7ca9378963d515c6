#!/usr/bin/env bash
# Prints what queries cost on a Cortex-M0 and a Cortex-M3: instructions and stack (in the emulator) and flash, and compares all with
# the reviewed table counts.txt.
#
#   run.sh                 print and compare; exit 1 where a row is over budget or moved by more than 2 %
#   run.sh --accept        print, make this the reviewed table, and write it into the README
#   run.sh --readme        only write the reviewed table into the README
#   run.sh --symbols BIN   what the flash program BIN links (src/bin), with sizes, on both cores
#   run.sh --flash-only    no emulator: flash alone
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
cd "$here"
out=${CARGO_TARGET_DIR:-$here/../../target}/benches
mkdir -p "$out"
out=$(cd "$out" && pwd)
export CARGO_TARGET_DIR=$out

accept=0 symbols='' counts=1 measure=1
while (($#)); do
    case $1 in
    --accept) accept=1 ;;
    --flash-only) counts=0 ;;
    --readme) measure=0 ;;
    --symbols)
        symbols=${2:?--symbols needs the name of a program in flash/src/bin}
        shift
        ;;
    *)
        sed -n '2,11s/^# \{0,1\}//p' "$here/run.sh" >&2
        exit 2
        ;;
    esac
    shift
done

# The README with the reviewed table between its two marks.
readme=$here/../../README.md
with_table() {
    awk '/<!-- counts:begin/ { print; while (("awk -f readme.awk counts.txt" | getline row) > 0) print row; inside = 1 }
         /<!-- counts:end/ { inside = 0 }
         !inside' "$readme"
}
write_readme() {
    with_table >"$out/README.md"
    cat "$out/README.md" >"$readme"
}
if ((!measure)); then
    write_readme
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
)

build_flash() {
    cargo build --quiet --profile flash --package tilesat-flash --bins --target "$1"
}
# Bytes of flash: code, constants and initialised data.
flash_of() {
    "$llvm/llvm-size" "$out/$1/flash/$2" | awk 'NR == 2 { print $1 + $2 }'
}

if [[ -n $symbols ]]; then
    for core in "${cores[@]}"; do
        target=${core#*:}
        build_flash "$target"
        echo "$symbols on ${core%:*}: $(flash_of "$target" "$symbols") B, of which the frame is $(flash_of "$target" empty) B"
        "$llvm/llvm-nm" --demangle --print-size --size-sort --reverse-sort --radix=d "$out/$target/flash/$symbols" |
            awk '{ size = $2 + 0; $1 = $2 = $3 = ""; printf "%6d  %s\n", size, $0 }'
    done
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
    done >"$measured"
    grep -v '^M[0-9]* stack|' "$measured" | line >>"$fresh"
    {
        echo
        echo 'Bytes of stack below the caller, the most of 64 inputs at opt-level 3: operands and answer are not counted, they are the caller'"'"'s.'
        echo 'core|query, class of inputs|most|most|budget' | line
        grep '^M[0-9]* stack|' "$measured" | line
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
    empty=$(flash_of "$target" empty)
    for program in "${programs[@]}"; do
        IFS=: read -r bin name budget <<<"$program"
        [[ ${core%:*} == M0 ]] || budget=0
        net=$(($(flash_of "$target" "$bin") - empty))
        echo "${core%:*} flash|$name|$((net + 46))|$net|$budget" | line >>"$fresh"
    done
done

# A static level costs no RAM: the linker's sizes of initialised and zeroed data.
for core in "${cores[@]}"; do
    ram=$("$llvm/llvm-size" "$out/${core#*:}/flash/static_levels" | awk 'NR == 2 { print $2 + $3 }')
    echo "${core%:*} RAM|two static levels|$ram|$ram|0" | line >>"$fresh"
    ((ram == 0)) || { echo "run.sh: static levels take $ram B of RAM" >&2; exit 1; }
done

cat "$fresh"
if ((accept)); then
    ((counts)) || { echo 'run.sh: --accept needs the counts as well' >&2; exit 2; }
    cp "$fresh" counts.txt
    write_readme
    echo "counts.txt and the README's table are now this: review the difference before it is committed"
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
if ! cmp -s <(with_table) "$readme"; then
    stale=1
    echo "the README's table is not that of counts.txt: benches/target/run.sh --readme writes it"
fi
echo
awk -v same_compiler=$same -f compare.awk "$reviewed" "$fresh" && ((!stale))
