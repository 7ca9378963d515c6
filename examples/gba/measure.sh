#!/usr/bin/env bash
# Measures the cost of motion in the game for the Game Boy Advance, in cycles per frame. A script
# presses the keys. Runs in Thumb and in ARM state, with 32 bodies and with 64. Compares with the
# reviewed table cycles.txt.
#
#   measure.sh            prints and compares; exit 1 if a mean moved by more than 2 %, or a name
#                         in hot/ is that of no function, exit 3 without an emulator
#   measure.sh --short    the same, in Arm state only
#   measure.sh --accept   prints, makes this the reviewed table, and writes it into README.md;
#                         writes the last picture to gba.png
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
here=examples/gba
accept=0 states=('ARM armv4t-none-eabi' 'Thumb thumbv4t-none-eabi')
case "${*:-}" in
'') ;;
--short) states=("${states[0]}") ;;
--accept) accept=1 ;;
*)
    sed -n '2,/^[^#]/s/^# \{0,1\}//p' "$0" >&2
    exit 2
    ;;
esac
.ci/get-emulators.sh gba >/dev/null || exit 3
out=${CARGO_TARGET_DIR:-target}
mkdir -p "$out"
export RUSTC_WRAPPER=$PWD/.ci/rustc.sh

source $here/keys.sh
game() {
    RUSTC_BOOTSTRAP=1 cargo run --quiet --profile counted --package tilesat-gba --features console -Zbuild-std=core --target "$1" --bin game -- --keys "$2" "${@:3}"
}

# stale TARGET: the patterns of its list that put nothing into fast RAM. Without this check the
# lists would become longer and the game slower, one renamed function at a time.
stale() {
    local list=$here/hot/${1%%v4t*}/hot.x sections pattern
    # The name of a section is that of its function or constant, after ".text." or ".rodata.".
    sections=$("$(rustc --print target-libdir)/../bin/llvm-nm" "$out/$1/counted/game" |
        awk '$1 ~ /^03/ { print ".text." $NF; print ".rodata." $NF }')
    grep -o '\.\(text\|rodata\)\.[^ )]*' "$list" | while read -r pattern; do
        grep -qx -- "${pattern//\*/.*}" <<<"$sections" || echo "$list: $pattern is in no name of fast RAM"
    done
}

fresh=$out/cycles.txt
{
    rustc --version
    echo 'state of the core|bodies|frames|mean|most|late|stack|hash'
    for state in "${states[@]}"; do
        read -r name target <<<"$state"
        for bodies in 32 64; do
            # Select at power-on doubles the bodies.
            before=$([[ $bodies == 64 ]] && echo 5:select || echo 5)
            picture=()
            [[ $accept$name$bodies == 1ARM32 ]] && picture=(--png $here/gba.png --scale 3)
            game "$target" "$before $keys" "${picture[@]}" |
                sed -n "s/^bodies=\(.*\) frames=\(.*\) mean=\(.*\) most=\(.*\) late=\(.*\) stack=\(.*\) hash=\(.*\)/$name|\1|\2|\3|\4|\5|\6|\7/p"
        done
    done
} >"$fresh"
cat "$fresh"

missing=$(for state in "${states[@]}"; do stale "${state#* }"; done)
if [[ -n $missing ]]; then
    printf '%s\n' "$missing"
    exit 1
fi

if ((accept)); then
    cp "$fresh" $here/cycles.txt
    awk -F'|' -v table="$fresh" '
        /<!-- gba:begin/ {
            print
            print "| GBA, state of the core | bodies | cycles per frame, mean | most | share of a picture, mean | frames over a picture | stack, bytes |"
            print "|---|--:|--:|--:|--:|--:|--:|"
            while ((getline row < table) > 0)
                if (split(row, c, "|") == 8 && c[2] + 0)
                    printf "| %s | %d | %d | %d | %.0f %% | %d of %d | %d |\n", c[1], c[2], c[4], c[5], c[4] / 2808.96, c[6], c[3], c[7]
            inside = 1
        }
        /<!-- gba:end/ { inside = 0 }
        !inside' "$here/README.md" >"$out/README.md"
    cat "$out/README.md" >"$here/README.md"
    echo "$here/cycles.txt, gba.png and the README's table are updated: review the difference before you commit it"
fi

awk -F'|' -v all=$((2 * ${#states[@]})) '
    FNR == 1 { if (NR == 1) compiler = $0; else other = compiler != $0; next }
    NR == FNR { mean[$1 $2] = $4; next }
    $2 + 0 {
        rows++
        was = mean[$1 $2]
        if ($4 > was * 1.02 || $4 < was * 0.98) { moved++; printf "%s, %d bodies: %d cycles, %d in the reviewed table\n", $1, $2, $4, was }
    }
    END {
        if (rows != all) { print "the game did not come to its end"; exit 1 }
        if (!moved) print rows " rows, none moved by more than 2 %"
        else if (other) print "another compiler: reported, not failed"
        exit moved && !other
    }' $here/cycles.txt "$fresh"
