# Adds the modelled cycles to the firmware's lines: awk -f cycles.awk MERGED
# MERGED has the firmware's lines, with the plugin's lines between them. Before each row of the
# firmware, the plugin has reported three calls 64 times: the query, an empty call, and a call that
# only loads its operands. Fails if the plugin saw other instructions than the firmware counted, or
# if the known loop is not three cycles per turn. The calls around the query and around nothing may
# differ by one taken branch, as the compiler lays them out: one or two cycles.
BEGIN { FS = "|" }

/^instructions [0-9]+ cycles [0-9]+$/ {
    split($0, part, " ")
    kind = calls++ % 3
    instructions[kind] += part[2]
    cycles[kind] += part[4]
    next
}
{ print }
$1 == "M0" && NF == 5 {
    if (calls == 192 && ($2 == "kernel" || $2 == "scenes")) {
        base = $2 == "kernel" ? 2 : 1
        split($4, part, " ")
        seen = (instructions[0] - instructions[base]) / 64
        # The firmware rounds to a tenth.
        if (seen - part[1] > 0.051 || part[1] - seen > 0.051) {
            printf "%s: the firmware counts %s, the plugin saw %s instructions\n", $3, part[1], seen >"/dev/stderr"
            wrong = 1
        }
        mean = (cycles[0] - cycles[base]) / 64
        printf "M0+ cycles|%s|%s|%.1f|0\n", $2, $3, mean
        if ($2 == "kernel") printf "M0+ cycles|reference|%s|%.1f|0\n", $3, (cycles[0] - cycles[1]) / 64
        if ($3 ~ /^a loop of two instructions, 1000 turns/ && (mean < 2998 || mean > 3002)) {
            printf "a loop of 3000 cycles is modelled as %s\n", mean >"/dev/stderr"
            wrong = 1
        }
        modelled++
    }
    calls = 0
    split("", instructions)
    split("", cycles)
}
END { exit (wrong || !modelled) }
