# Prints the README's short table: awk -f short.awk counts.txt. Whole programs come first.
# readme.awk prints the long one.
BEGIN {
    FS = "|"
    program("a hero among blocks", "a `Character` among `Blocks`")
    program("a hero among slopes", "a `Character` among `Slopes`")
    program("a hero among blocks with a lift", "a `Character` among `Blocks`, with lifts")
    program("a hero among slopes with a lift", "a `Character` among `Slopes`, with lifts")
    program("33 bodies among blocks, coins, ladders", "33 bodies among blocks, with coins and ladders")
    program("240 bullets, 32 enemies, pairs and events", "240 bullets and 32 enemies, pairs and events")
    call("AABB-AABB overlaps, hit", "two boxes overlap", "AABB-AABB overlaps", "kernel")
    call("ray, 17 cells, hit", "a ray through 17 cells of blocks", "ray, Blocks", "kernel")
    call("blocks: box moves, <= 4 a frame", "a box moves among blocks", "move_and_slide, AABB, Blocks", "kernel")
    call("shapes: circle moves, <= 4 a frame", "a circle moves among all shapes", "move_and_slide, circle, AllShapes", "kernel")
    call("ride, box is carried", "a box is carried by a lift", "ride on solids, AABB, Blocks", "kernel")
    call("64 bodies awake, step", "a scene of 64 bodies, one step", "", "scenes")
}
function program(row, title) { name[++programs] = row; say[row] = title }
function call(row, title, flash, section) {
    calls++
    key[calls] = section SUBSEP row; label[calls] = title; weighs[calls] = flash
    stack[calls] = section == "scenes" ? "scene: " row : row
}
function trim(s) { gsub(/^ +| +$/, "", s); return s }
# Prints 1234567 as 1 234 567.
function spaced(n, s) {
    if (n == "") return ""
    n = sprintf("%.0f", n) + 0
    for (s = ""; n >= 1000; n = int(n / 1000)) s = sprintf(" %03d", n % 1000) s
    return n s
}
NF < 2 { section = ""; next }
$1 ~ /^\[.*\]/ {
    section = trim($1)
    section = substr(section, 2, length(section) - 2)
    next
}
# The Cortex-M0 is the first column of each table.
section != "" { value[section, trim($1)] = trim($2) }
END {
    print "| whole programs and calls | flash, bytes | instructions | stack or static RAM, bytes |"
    print "|---|--:|--:|--:|"
    for (i = 1; i <= programs; i++)
        printf "| %s | %s | | %s |\n", say[name[i]], spaced(value["game flash", name[i]]), spaced(value["RAM", name[i]])
    for (i = 1; i <= calls; i++)
        printf "| %s | %s | %s | %s |\n", label[i], spaced(value["flash", weighs[i]]), spaced(value[key[i]]), spaced(value["stack", stack[i]])
}
