# Prints the README's short table, whole programs first: awk -f read.awk -f short.awk counts.txt
# readme.awk prints the long one. -v page=board prints only the programs, and how much stack to
# leave, for the guide's board from zero. -v page=scenes prints the flash of scenes, for its many
# bodies. The stack that was seen is that at the level of optimisation that takes more. Bounds are
# those at "s". The bound of a hero is that of boxes, circles and capsules in all levels.
BEGIN {
    hero("a hero among blocks", "a `Character` among `Blocks`")
    hero("a hero among slopes", "a `Character` among `Slopes`")
    hero("a hero among blocks with a lift", "a `Character` among `Blocks`, with lifts")
    hero("a hero among slopes with a lift", "a `Character` among `Slopes`, with lifts")
    program("a scene of 30 balls and boxes, among blocks", "a `Scene` of 30 bodies, packed and bouncing", "scenes", "30 balls packed and bouncing, step", "scene: 30 balls packed and bouncing, step", "scenes: s.step(blocks, g, each)")
    program("a scene of 30 balls and boxes with lifts, among blocks", "the same with lifts (`Solid`)", "", "", "", "scenes: s.step(lifts, g, each)")
    program("a scene of 30 balls and boxes with planks, among blocks", "the same with planks (`ConvexSolid`)", "", "", "", "scenes: s.step(planks, g, each)")
    program("a game seen from above", "a game seen from above, a box among blocks")
    program("33 bodies among blocks, coins, ladders", "33 bodies among blocks, with coins and ladders")
    program("240 bullets, 32 enemies, pairs and events", "240 bullets and 32 enemies, pairs and events")
    call("blocks: box moves, <= 4 a frame", "a box moves among blocks", "move_and_slide, AABB, Blocks", "kernel")
    call("shapes: circle moves, <= 4 a frame", "a circle moves among all shapes", "move_and_slide, circle, AllShapes", "frames", "circle moves, <= 4 a frame, mean of 4000")
}
function hero(row, title) { program(row, title, "frames", row ", mean of 4000", row, row ~ /lift/ ? "motion: c.step_on(l, solids, i)" : "motion: c.step(l, i)") }
function program(row, title, section, counted, stack, limit) {
    line(title, "game flash", row, section, counted, stack)
    RAM[lines] = row
    bound_of[lines] = "bound" SUBSEP limit
    if (limit != "") shown = lines
}
function call(row, title, flash, section, counted) {
    line(title, "flash", flash, section, counted == "" ? row : counted, row)
}
function line(title, weighed, flash, section, counted, stack) {
    say[++lines] = title
    flash_of[lines] = weighed SUBSEP flash
    count_of[lines] = section SUBSEP counted
    stack_of[lines] = "stack" SUBSEP stack
}
function stack(i) { return larger(at(stack_of[i], "M0"), at(stack_of[i], "M0 at s")) }
function bound(i) { return at(bound_of[i], "M0") }
# The most of 4000 frames, and of a scene that of 64 steps. The most of the 64 inputs of other calls
# is far below their worst.
function most(i, where, range) {
    where = count_of[i]
    if (sub(/, mean of 4000$/, ", most of 4000", where)) return at(where, "M0")
    if (where !~ /^scenes/) return ""
    range = at(where, "M0 least..most")
    sub(/.*\.\./, "", range)
    return range
}
# How often the mean of 4000 frames among all shapes fits into the worst frame of a box or a circle,
# up to a speed.
function times(speed, n, kinds, worst, row) {
    n = split("circle box", kinds, " ")
    for (; n; n--) {
        row = "frames" SUBSEP kinds[n] " moves, <= " speed " a frame, "
        worst = larger(worst, at(row "most of 4000", "M0") / at(row "mean of 4000", "M0"))
    }
    return sprintf("%.0f", worst)
}
function kilobytes(bytes) { return sprintf("%.1f KB", bytes / 1024) }
function flash(i) { return at(flash_of[i], "M0") }
END {
    if (page == "scenes") {
        HERO = "game flash" SUBSEP "a scene of 30 balls and boxes with a hero, among blocks"
        printf "On a Cortex-M0, a program with a `Scene` takes %d KB of flash, where 1 KB is 1024 bytes.\n", flash(5) / 1024 + 0.5
        printf "It does not fit a chip of 64 KB. With lifts it takes %d KB, and %d KB if the lifts have any\nconvex shape. With a hero among its boxes it takes %d KB, and\nup to %s of stack.\n", flash(6) / 1024 + 0.5, flash(7) / 1024 + 0.5, at(HERO, "M0") / 1024 + 0.5, kilobytes(at("bound" SUBSEP "scenes: hero.lead(s, l, lifts, i)", "M0"))
        exit
    }
    print "| whole programs and calls | flash | mean instructions at \"s\" | mean at 3 | maximum at 3 | stack seen | stack, bound | static RAM |"
    print "|---|--:|--:|--:|--:|--:|--:|--:|"
    for (i = 1; i <= (page == "board" ? shown : lines); i++)
        printf "| %s | %s | %s | %s | %s | %s | %s | %s |\n", say[i], spaced(at(flash_of[i], "M0")), spaced(at(count_of[i], "M0 at s")), spaced(at(count_of[i], "M0")), spaced(most(i)), spaced(stack(i)), spaced(bound(i)), i in RAM ? spaced(at("RAM" SUBSEP RAM[i], "M0")) : ""
    if (page == "board")
        printf "\nThese heroes took up to %s of stack, with lifts %s. No box, circle or capsule takes more\nthan %s in a level joined of up to three, with lifts %s. No step of these scenes takes more\nthan %s. Leave 2 KB more for your own code.\n", kilobytes(stack(2)), kilobytes(stack(4)), kilobytes(bound(1)), kilobytes(bound(3)), kilobytes(larger(bound(5), larger(bound(6), bound(7))))
    else {
        print "\nAmong all shapes, at up to 4 units per frame, the worst of 4000 frames takes " times(4) " times the mean. At"
        print "up to 30 units it takes " times(30) " times the mean."
    }
}
