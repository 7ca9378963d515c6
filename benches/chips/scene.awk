# Prints the costs in the documentation of `Scene`: awk -f read.awk -f scene.awk counts.txt

function need(where, column) {
    if (at(where, column) == "") { print "scene.awk: no " where ", " column > "/dev/stderr"; exit 1 }
    return at(where, column)
}
function bound(call) { return call == "" ? "" : spaced(need("bound" SUBSEP "scenes: " call, "M0")) }
function flash(with) { return spaced(need("game flash" SUBSEP "a scene of 30 balls and boxes" with ", among blocks", "M0")) }
function row(what, size, step, ride) { printf "/// | %s | %s | %s | %s |\n", what, size, bound(step), bound(ride) }
function step(kind) { return spaced(need("scenes" SUBSEP kind ", step", "M0")) }
END {
    print "/// | scene | flash, bytes | stack of a step, bytes | of a [ride](Self::ride) |"
    print "/// |---|--:|--:|--:|"
    row("boxes and circles", flash(""), "s.step(blocks, g, each)")
    row("the same, with [`Solid`](crate::Solid) lifts", flash(" with lifts"), "s.step(lifts, g, each)", "s.ride(l, lifts, g, follow, each)")
    row("the same, with [`ConvexSolid`](crate::world::ConvexSolid) lifts", flash(" with planks"), "s.step(planks, g, each)", "s.ride(l, planks, g, follow, each)")
    row("[`WithCapsules`](super::WithCapsules)", "", "pills.step(shapes, g, each)", "pills.ride(l, lifts, g, follow, each)")
    row("[`AnyShape`](crate::shape::AnyShape)", "", "any.step(shapes, g, each)", "any.ride(l, solids, g, follow, each)")
    split(need("scenes" SUBSEP "64 bodies awake, step", "M0 least..most"), range, /\.\./)
    print "///"
    print "/// | 64 bodies | instructions per step |"
    print "/// |---|--:|"
    print "/// | fly and land, mean | " step("64 bodies awake") " |"
    print "/// | fly and land, at most | " spaced(range[2]) " |"
    print "/// | lie in nooks of slopes, none may sleep | " step("64 bodies awake that lie") " |"
    print "/// | the same, if the scene [remembers](Self::remembering) | " step("64 bodies awake that lie, remembered") " |"
    print "/// | sleep | " step("64 asleep") " |"
}
