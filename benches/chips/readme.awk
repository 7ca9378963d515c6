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

function snapshot(how, row) {
    row = "stack" SUBSEP "a snapshot of 16 bodies, " how SUBSEP "M0"
    return spaced(larger(shown(row), shown(row " at s")))
}

END {
    line = "| | " core[1]
    for (c = 2; c <= cores; c++) line = line " | " (core[c] ~ /cycles/ ? "*" core[c] "*" : core[c])
    print line " | stack | flash |"
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
