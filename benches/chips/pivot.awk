# Prints tables of the output of the firmwares and the linker, one per section: awk -f pivot.awk
# LINES
# A line is core|section|row|value|budget. A value is "mean (least..most)" or a number. A budget of
# 0 means none. A table has one line per row and one column per core. The M0 also has the range, and
# its budgets if there are any.
BEGIN {
    FS = "|"
    cores = split("M0,M0 at s,M3,M4F,M33,RV32,M0+ cycles", core, ",")
    about["kernel"] = "Instructions with operands in registers, mean of 64 inputs of a class, at opt-level 3 and (M0 at s) \"s\". M0+ cycles are modelled, see plugin/src/cost.rs."
    about["reference"] = "The same by reference: less an empty call."
    about["scenes"] = "Instructions of one step of a whole scene by reference, mean of 64 steps."
    about["frames"] = "Instructions of single frames by reference, in a level of all shapes or of a hero in a platformer: the far end of many."
    about["stack"] = "Bytes of stack below the caller, the most of 64 inputs (of a hero: of 4000 frames): operands and answer are the caller's."
    about["bound"] = "Bytes of stack that no input exceeds, at opt-level \"s\", by public function: all frames of the deepest chain of calls, with room for the\n" \
        "answer. Closures and functions that you pass come on top. The most of all types that a line of flash/src/bin/everything_*.rs is written for: levels joined of three."
    about["pairs"] = "Instructions a frame of N bodies that all move, and all pairs. The boxes are at hand; 6 to 24 units, 32 cells, up to 2 a frame.\n" \
        "fixed: 1024 x 768; density: 64 x 64 each; cluster: all in 256 x 256."
    about["pairs, filters"] = "The same with filters, each body by its name."
    about["size"] = "Bytes of RAM of N bodies, with a grid for 1024 x 768."
    about["size, filters"] = "The same with filters."
    about["flash"] = "Bytes of flash at opt-level \"s\", everything pulled in, 46 bytes for an empty program included."
    about["game flash"] = "Bytes of flash of whole games at opt-level \"s\": library, game, level; no start-up code, no pictures. What\n" \
        "a static holds at the start counts as well, unless it is 0 or made later, as the bodies of scenes are."
    about["RAM"] = "Bytes of static RAM, by the linker. Stack comes on top."
}

NF < 5 { next }
{
    section = $2
    row = $3
    if (!(section in rows)) order[++sections] = section
    if (!((section, row) in known)) { known[section, row] = 1; name[section, ++rows[section]] = row }
    split($4, part, " ")
    value[section, row, $1] = part[1]
    seen[section, $1] = 1
    if ($1 == "M0" && part[2] != "") {
        ranged[section] = 1
        range[section, row] = substr(part[2], 2, length(part[2]) - 2)
    }
    if ($5 + 0) { limit[section, row, $1] = $5; limited[section, $1] = 1 }
}

# Cells of one line, padded to the widest of their column.
function cell(line, text) {
    cells[line, ++used] = text
    if (length(text) > width[used]) width[used] = length(text)
}
function print_line(line, i, text) {
    text = ""
    for (i = 1; i <= used; i++) {
        if (i > 1) text = text " | "
        text = text sprintf(i == 1 ? "%-*s" : "%*s", width[i], cells[line, i])
    }
    sub(/[ |]+$/, "", text)
    print text
}

END {
    for (s = 1; s <= sections; s++) {
        section = order[s]
        split("", width)
        for (line = 0; line <= rows[section]; line++) {
            row = name[section, line]
            used = 0
            cell(line, line ? row : "[" section "]")
            for (c = 1; c <= cores; c++) {
                if (!((section, core[c]) in seen)) continue
                cell(line, line ? ((section, row, core[c]) in value ? value[section, row, core[c]] : "-") : core[c])
            }
            if (section in ranged) cell(line, line ? range[section, row] : "M0 least..most")
            for (c = 1; c <= cores; c++) {
                if ((section, core[c]) in limited) cell(line, line ? limit[section, row, core[c]] : core[c] " budget")
            }
        }
        print ""
        if (section in about) print about[section]
        for (line = 0; line <= rows[section]; line++) print_line(line)
    }
}
