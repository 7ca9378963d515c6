# Compares fresh tables with the reviewed ones:
#   awk -v same_compiler=0|1 -v only=SECTIONS -v without=COLUMNS \
#     -f read.awk -f compare.awk counts.txt FRESH
# SECTIONS and COLUMNS are names between semicolons, or empty: the only ones to compare, and the
# ones that could not be measured here. Prints a line per finding, then a summary line. Exits with 1
# if a number exceeds its budget, differs by more than 2 % from the reviewed one, or has no
# counterpart. A budget must equal the reviewed one. With another compiler it reports differences of
# numbers but does not fail.

function in_list(list, item) { return index(";" list ";", ";" item ";") > 0 }
function moved(a, b, d) { d = a > b ? a - b : b - a; return d * 50 > a }
function told(what, key, text, part) {
    split(key, part, SUBSEP)
    printf "  %-7s %s | %s | %s: %s\n", what, part[1], part[2], part[3], text
}
function change(key, text) {
    changed++
    split(key, part, SUBSEP)
    of_column[part[3]]++
    told(text ~ /^was/ ? "CHANGED" : text ~ /^is/ ? "NEW" : "GONE", key, text)
}

section == "" || (only != "" && !in_list(only, section)) { next }
{
    file = FILENAME == ARGV[1] ? 1 : 2
    if (file == 2) rows++
    for (i = 2; i <= columns; i++) {
        number = trim($i)
        if (number == "" || number == "-" || column[i] ~ /\.\./ || in_list(without, column[i])) continue
        key = section SUBSEP trim($1) SUBSEP column[i]
        if (column[i] ~ / budget$/) {
            core = substr(column[i], 1, length(column[i]) - 7)
            if (in_list(without, core)) continue
            if (file == 1) { reviewed[key] = number; continue }
            budget[key] = number
            if (!(key in reviewed) || reviewed[key] != number) {
                stale++
                told("BUDGET", key, (key in reviewed ? "is " reviewed[key] : "is missing") " in counts.txt, now " number)
            }
            continue
        }
        if (file == 1) { old[key] = number; continue }
        numbers++
        fresh[key] = number
        keys[numbers] = key
    }
    if (file == 1) next
    for (i = 2; i <= columns; i++) {
        if (column[i] !~ / budget$/ || trim($i) == "") continue
        core = substr(column[i], 1, length(column[i]) - 7)
        key = section SUBSEP trim($1) SUBSEP core
        if (fresh[key] + 0 > $i + 0) { over++; told("OVER", key, fresh[key] ", budget " trim($i)) }
    }
}

END {
    for (i = 1; i <= numbers; i++) {
        key = keys[i]
        if (!(key in old)) change(key, "is " fresh[key])
        else if (moved(old[key] + 0, fresh[key] + 0))
            change(key, sprintf("was %s, is %s (%+.1f %%)", old[key], fresh[key], old[key] + 0 ? (fresh[key] / old[key] - 1) * 100 : 100))
    }
    for (key in old) if (!(key in fresh)) change(key, "no longer measured")
    for (key in reviewed) if (!(key in budget)) { stale++; told("BUDGET", key, "is " reviewed[key] " in counts.txt, now none") }
    where = ""
    for (c in of_column) where = where (where == "" ? ": " : ", ") c " " of_column[c]
    printf "%d rows, %d numbers, %d over budget, %d other budgets, %d changed%s\n", rows, numbers, over, stale, changed, where
    exit (over || stale || (changed && same_compiler) || !rows)
}
