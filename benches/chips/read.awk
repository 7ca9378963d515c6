# Reads counts.txt, or the output of pivot.awk, for a script that prints a table of it:
# awk -f read.awk -f SCRIPT counts.txt
# `value` has each measured cell by section, row and column. In a row, `section` and `column` name
# its cells.
BEGIN { FS = "|" }

function trim(s) { gsub(/^ +| +$/, "", s); return s }
# Prints 1234567 as 1 234 567, to the nearest whole number, and nothing as nothing.
function spaced(n, s) {
    if (n == "") return ""
    n = sprintf("%.0f", n) + 0
    for (s = ""; n >= 1000; n = int(n / 1000)) s = sprintf(" %03d", n % 1000) s
    return n s
}
function larger(a, b) { return b + 0 > a + 0 ? b : a }
# The cell of `section SUBSEP row` in a column.
function at(where, column) { return (where SUBSEP column) in value ? value[where SUBSEP column] : "" }

NF < 2 { section = ""; next }
$1 ~ /^\[.*\]/ {
    section = trim($1)
    section = substr(section, 2, length(section) - 2)
    columns = NF
    for (i = 2; i <= NF; i++) column[i] = trim($i)
    next
}
section != "" { for (i = 2; i <= NF && i <= columns; i++) if (trim($i) != "-") value[section, trim($1), column[i]] = trim($i) }
