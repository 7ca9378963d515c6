# The reviewed table as Markdown, both cores side by side: awk -f readme.awk counts.txt
# Those of broad phases are a table of their own (bodies.awk).
# Rows that only show where a class comes from stay in counts.txt, and so do stacks below 256 bytes.
BEGIN { FS = "|" }

function trim(s) { gsub(/^ +| +$/, "", s); return s }
function mean(s) { return sprintf("%.0f", trim(s) + 0) }

NF < 5 || /^core/ || /^M[0-9]+ (pairs|size)/ || /(second|third|last) reject|, uniform/ { next }
{
    core = trim($1)
    name = trim($2)
    if (core ~ /stack/) {
        sub(/ stack/, "", core)
        if (!(name in stack_listed) && $3 + 0 < 256) next
        if (!(name in stack_listed)) { stack_listed[name] = 1; stack_order[++stacks] = name }
        stack[name, core] = trim($3)
        next
    }
    sub(/ \(A right\)/, "", name)
    kind = core ~ /flash|RAM/ ? "flash" : "count"
    if (core ~ /RAM/) name = "RAM of " name
    sub(/ (flash|RAM)/, "", core)
    if (!((kind, name) in listed)) { listed[kind, name] = 1; order[kind, ++rows[kind]] = name }
    first[kind, name, core] = mean($3)
    second[kind, name, core] = mean($4)
}
END {
    print "| instructions | M0 | *by reference* | M3 | *by reference* |"
    print "|---|--:|--:|--:|--:|"
    for (i = 1; i <= rows["count"]; i++) {
        name = order["count", i]
        printf "| %s | %d | *%d* | %d | *%d* |\n", name, first["count", name, "M0"], second["count", name, "M0"], first["count", name, "M3"], second["count", name, "M3"]
    }
    print ""
    print "| bytes of flash, 46 for an empty program included | M0 | M3 |"
    print "|---|--:|--:|"
    for (i = 1; i <= rows["flash"]; i++) {
        name = order["flash", i]
        printf "| %s | %d | %d |\n", name, first["flash", name, "M0"], first["flash", name, "M3"]
    }
    if (!stacks) exit
    print ""
    print "| bytes of stack, the most of 64 inputs, where above 256 | M0 | M3 |"
    print "|---|--:|--:|"
    for (i = 1; i <= stacks; i++) {
        name = stack_order[i]
        printf "| %s | %s | %s |\n", name, stack[name, "M0"], stack[name, "M3"]
    }
}
