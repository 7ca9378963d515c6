# Prints the costs in the documentation of `Scene`: awk -f scene.awk counts.txt
BEGIN { FS = "|" }
function trim(s) { gsub(/^ +| +$/, "", s); return s }
function at(section, row, column) {
    if (!((section, row, column) in value)) { print "scene.awk: no " section ", " row ", " column > "/dev/stderr"; exit 1 }
    return value[section, row, column]
}
# Prints 1234567 as 1 234 567.
function spaced(n, s) {
    n = sprintf("%.0f", n) + 0
    for (s = ""; n >= 1000; n = int(n / 1000)) s = sprintf(" %03d", n % 1000) s
    return n s
}
function bound(call) { return call == "" ? "" : spaced(at("bound", "scenes: " call, "M0")) }
function flash(with) { return spaced(at("game flash", "a scene of 30 balls and boxes" with ", among blocks", "M0")) }
function row(what, size, step, ride) { printf "/// | %s | %s | %s | %s |\n", what, size, bound(step), bound(ride) }
function step(kind) { return spaced(at("scenes", kind ", step", "M0")) }
NF < 2 { section = ""; next }
/^\[.*\]/ {
    section = substr(trim($1), 2, length(trim($1)) - 2)
    for (i = 2; i <= NF; i++) column[i] = trim($i)
    next
}
section != "" { for (i = 2; i <= NF; i++) value[section, trim($1), column[i]] = trim($i) }
END {
    print "/// | scene | flash, bytes | stack of a step, bytes | of a [ride](Self::ride) |"
    print "/// |---|--:|--:|--:|"
    row("boxes and circles", flash(""), "s.step(blocks, g, each)")
    row("the same, with [`Solid`](crate::Solid) lifts", flash(" with lifts"), "s.step(lifts, g, each)", "s.ride(l, lifts, g, follow, each)")
    row("the same, with [`ConvexSolid`](crate::world::ConvexSolid) lifts", flash(" with planks"), "s.step(planks, g, each)", "s.ride(l, planks, g, follow, each)")
    row("[`WithCapsules`](super::WithCapsules)", "", "pills.step(shapes, g, each)", "pills.ride(l, lifts, g, follow, each)")
    row("[`AnyShape`](crate::shape::AnyShape)", "", "any.step(shapes, g, each)", "any.ride(l, solids, g, follow, each)")
    split(at("scenes", "64 bodies awake, step", "M0 least..most"), range, /\.\./)
    print "///"
    print "/// | 64 bodies | instructions per step |"
    print "/// |---|--:|"
    print "/// | fly and land, mean | " step("64 bodies awake") " |"
    print "/// | fly and land, at most | " spaced(range[2]) " |"
    print "/// | lie in nooks of slopes, none may sleep | " step("64 bodies awake that lie") " |"
    print "/// | the same, if the scene [remembers](Self::remembering) | " step("64 bodies awake that lie, remembered") " |"
    print "/// | sleep | " step("64 asleep") " |"
}
