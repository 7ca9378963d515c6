# Prints the main rows of the reviewed tables as Markdown, one query per line:
# awk -f read.awk -f readme.awk counts.txt
# All other rows stay in counts.txt. Those of broad phases have a separate table (bodies.awk).
BEGIN {
    # section, row = name on the page = the flash program that holds it
    add("kernel", "AABB-AABB overlaps, hit", "two boxes overlap", "AABB-AABB overlaps")
    add("kernel", "circle-circle overlaps, near", "two circles, near, overlap", "circle-circle overlaps")
    add("kernel", "circle-AABB overlaps, near", "circle and box, near, overlap", "circle-AABB overlaps")
    add("kernel", "circle-segment overlaps, near", "circle and segment, near, overlap", "circle-segment overlaps")
    add("kernel", "circle-circle contact", "contact of two circles", "circle-circle contact")
    add("kernel", "circle-segment contact", "contact of circle and segment", "")
    add("kernel", "unit normal, circle-circle", "its unit normal", "unit normal")
    add("kernel", "circle-segment distance", "distance of circle and segment", "")
    add("kernel", "AABB-AABB cast_shape, hit", "a box cast against a box, hits", "")
    add("kernel", "circle-segment cast_shape, hit", "a circle cast against a segment, hits", "")
    add("kernel", "ray, 17 cells, hit", "ray through 17 cells of blocks", "ray, Blocks")
    add("kernel", "shapes: ray, hit", "ray among all tile shapes, hits", "ray, AllShapes")
    add("kernel", "segments: ray, hit", "ray among free segments, hits", "")
    add("kernel", "shapes: circle overlaps, free", "circle overlaps a level of all shapes", "")
    add("kernel", "blocks: box moves, <= 4 a frame", "box moves and slides among blocks", "move_and_slide, AABB, Blocks")
    add("kernel", "blocks: circle moves, <= 4 a frame", "circle moves and slides among blocks", "move_and_slide, circle, Blocks")
    add("kernel", "shapes: box moves, <= 4 a frame", "box moves and slides among all shapes", "move_and_slide, AABB, AllShapes")
    add("kernel", "shapes: circle moves, <= 4 a frame", "circle moves and slides among all shapes", "move_and_slide, circle, AllShapes")
    add("kernel", "ride, box is carried", "box is carried by a platform, one of four", "ride on solids, AABB, Blocks")
    add("scenes", "64 bodies awake, step", "a scene of 64 bodies, one step", "")
    add("scenes", "64 bodies awake that lie, step", "the same, when most lie on others", "")
    add("scenes", "30 balls packed and bouncing, step", "a scene of 30 balls, packed and bouncing", "")
    played("a hero among blocks")
    played("a hero among slopes")
    played("a hero among blocks with a lift")
    played("a hero among slopes with a lift")
    cores = split("M0 at s,M0,M0+ cycles,M3,M4F,M33,RV32", core, ",")
}

function add(section, row, title, program) {
    rows++
    key[rows] = section SUBSEP row
    stack_row[rows] = section == "scenes" ? "scene: " row : row
    say[rows] = title
    flash[rows] = program
}
# A hero's frame: its mean and its most are two rows of counts.txt, its stack is a third.
function played(row, i) {
    add("frames", row ", mean of 4000", row ": a frame", "")
    stack_row[rows] = row
    add("frames", row ", most of 4000", row ": the longest of 4000", "")
    stack_row[rows] = ""
}
function shown(where) { return where in value ? sprintf("%.0f", value[where]) : "" }
section == "game flash" { game[++games] = trim($1) }

# How much less the mean of each hero takes at opt-level 3: the least and the most of them.
function saved(i, where, part, least, most) {
    for (i = 1; i <= rows; i++) {
        where = key[i]
        if (where !~ /^frames.*, mean of 4000$/) continue
        part = 100 * (1 - value[where, "M0"] / value[where, "M0 at s"])
        if (least == "" || part < least) least = part
        most = larger(most, part)
    }
    return sprintf("%.0f to %.0f %%", least, most)
}
function limit(title, call, other) {
    printf "| %s | %s |\n", title, spaced(larger(at("bound" SUBSEP call, "M0"), other == "" ? 0 : at("bound" SUBSEP other, "M0")))
}
function snapshot(how, row) {
    row = "stack" SUBSEP "a snapshot of 16 bodies, " how SUBSEP "M0"
    return spaced(larger(shown(row), shown(row " at s")))
}

END {
    line = "| | " core[1]
    for (c = 2; c <= cores; c++) line = line " | " (core[c] ~ /cycles/ ? "*" core[c] "*" : core[c])
    print line " | stack seen | flash |"
    print "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|"
    for (i = 1; i <= rows; i++) {
        line = "| " say[i]
        if (!((key[i], "M0") in value)) {
            printf "readme.awk: counts.txt has no row \"%s\"\n", key[i] >"/dev/stderr"
            line = line " (not measured)"
        }
        for (c = 1; c <= cores; c++) {
            number = shown(key[i] SUBSEP core[c])
            if (number != "") number = spaced(number)
            line = line " | " (core[c] ~ /cycles/ && number != "" ? "*" number "*" : number)
        }
        bytes = shown("flash" SUBSEP flash[i] SUBSEP "M0")
        print line " | " larger(shown("stack" SUBSEP stack_row[i] SUBSEP "M0"), shown("stack" SUBSEP stack_row[i] SUBSEP "M0 at s")) " | " (bytes == "" ? "" : spaced(bytes)) " |"
    }
    print ""
    printf "For a frame of these heroes on a Cortex-M0, opt-level 3 takes %s fewer instructions than \"s\".\n", saved()
    print ""
    print "| stack that no input exceeds, at \"s\" | bytes |"
    print "|---|--:|"
    limit("a step of a hero that is a box, a circle or a capsule, in any level", "motion: c.step(l, i)")
    limit("the same with lifts (`Solid`)", "motion: c.step_on(l, solids, i)")
    limit("a step of a scene of boxes and circles among blocks", "scenes: s.step(blocks, g, each)")
    limit("the same with lifts or planks", "scenes: s.step(lifts, g, each)", "scenes: s.step(planks, g, each)")
    limit("a step of a scene of any shapes among all tiles", "scenes: any.step(shapes, g, each)")
    print ""
    print "| stack of a snapshot of a scene of 16, which is 1984 bytes large | bytes |"
    print "|---|--:|"
    print "| `snapshot`, returned | " snapshot("returned") " |"
    print "| `snapshot_into`, written in place | " snapshot("written in place") " |"
    print ""
    print "| whole games, bytes | flash, M0 | flash, M3 | static RAM |"
    print "|---|--:|--:|--:|"
    for (i = 1; i <= games; i++)
        printf "| %s | %s | %s | %s |\n", game[i], spaced(shown("game flash" SUBSEP game[i] SUBSEP "M0")),
            spaced(shown("game flash" SUBSEP game[i] SUBSEP "M3")), spaced(shown("RAM" SUBSEP game[i] SUBSEP "M0"))
}
