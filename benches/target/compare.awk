# Compares a fresh table with the reviewed one: awk -v same_compiler=0|1 -f compare.awk counts.txt FRESH
# Prints one line a finding and ends with a summary line; exit status 1 where a row is above its budget, differs by more
# than 2 % from the reviewed row, or has no counterpart. With another compiler differences are told but do not fail.
BEGIN { FS = "|" }

function trim(s) { gsub(/^ +| +$/, "", s); return s }
function number(s) { s = trim(s); sub(/ .*/, "", s); return s + 0 }
function moved(a, b, d) { d = a > b ? a - b : b - a; return d * 50 > a }
function fail(what, row, text) { printf "  %-7s %s: %s\n", what, row, text }

NF < 5 || /^core/ { next }
{ row = trim($1) " " trim($2) }
FILENAME == ARGV[1] { old_first[row] = $3; old_second[row] = $4; next }
{
    rows++
    seen[row] = 1
    budget = number($5)
    if (budget && number($3) > budget) { over++; fail("OVER", row, trim($3) ", budget " budget) }
    if (!(row in old_first)) { changed++; fail("NEW", row, trim($3)); next }
    if (moved(number(old_first[row]), number($3)) || moved(number(old_second[row]), number($4))) {
        changed++
        fail("CHANGED", row, "was " trim(old_first[row]) " / " trim(old_second[row]) ", is " trim($3) " / " trim($4))
    }
}
END {
    for (row in old_first) if (!(row in seen)) { changed++; fail("GONE", row, "no longer measured") }
    printf "%d rows, %d over budget, %d changed\n", rows, over, changed
    exit (over || (changed && same_compiler) || !rows)
}
