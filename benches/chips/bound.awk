# Bounds the stack of each function of a program of everything:
#   awk -v part=PART -f bound.awk DISASSEMBLY
# The disassembly is llvm-objdump's of a program for ARMv6-M. A function's frame is everything that
# it pushes and subtracts from the stack pointer. Its bound is its frame plus the largest bound of
# its callees. Prints M0|bound|PART: the expression|most (least..most)|0, over all types that the
# expression is written for. Calls by pointer reach the caller's own functions, so add their stack.
# Fails if a function calls itself, or changes the stack pointer in an unknown way.

function hex(digits, i, n) {
    n = 0
    for (i = 1; i <= length(digits); i++) n = n * 16 + index("0123456789abcdef", substr(digits, i, 1)) - 1
    return n
}
# Counts the registers in {r4, r6, r7, lr} or {r4-r7}.
function registers(list, item, ends, i, n, count) {
    gsub(/[{}]| */, "", list)
    count = split(list, item, ",")
    n = 0
    for (i = 1; i <= count; i++)
        n += split(item[i], ends, "-") == 2 ? substr(ends[2], 2) - substr(ends[1], 2) + 1 : 1
    return n
}
function fail(function_at, what) {
    printf "bound.awk: %s: %s\n", name[function_at], what >"/dev/stderr"
    failed = 1
}
function plain(address) {
    sub(/^0+/, "", address)
    return address == "" ? "0" : address
}

# A symbol may continue in the next lines, and identical functions share one address.
goes_on {
    gsub(/^ +/, "")
    symbol[count] = name[at] = symbol[count] " " $0
    goes_on = !/>:$/
    next
}
/^[0-9a-f]+ </ {
    if ($2 ~ /^<\$/) next
    at = plain($1)
    name[at] = symbol[++count] = substr($0, index($0, "<") + 1)
    address[count] = at
    goes_on = !/>:$/
    next
}
!/^ *[0-9a-f]+:/ { next }
/\.word/ { word[plain(substr($1, 1, length($1) - 1))] = $NF; next }
{
    operation = $2
    operands = $0
    sub(/^[^\t]*\t[^\t]*\t?/, "", operands)
    comment = operands
    sub(/ *@.*/, "", operands)
}
operation == "push" { frame[at] += 4 * registers(operands); next }
operation == "sub" && operands ~ /^sp, #/ { sub(/.*#0x/, "", operands); frame[at] += hex(operands); next }
# A large frame is a negative number among the constants behind the function. Going back to a frame
# pointer ends a function.
operation == "ldr" && operands ~ /, \[pc/ {
    register = operands
    sub(/,.*/, "", register)
    sub(/.*@ 0x/, "", comment)
    sub(/ .*/, "", comment)
    constant[register] = comment
    next
}
operation == "add" && operands ~ /^sp, r/ { large[at] = large[at] " " constant[substr(operands, 5)]; next }
operation ~ /^(sub|msr)/ && operands ~ /^sp, r|^[mp]sp/ { fail(at, operation " " operands); next }
operation ~ /^b/ && operands ~ /^0x[0-9a-f]+ </ && operands !~ /\+0x[0-9a-f]+>?$/ {
    target = operands
    sub(/^0x/, "", target)
    sub(/ .*/, "", target)
    # This one swaps two numbers and calls itself once.
    if (target == at && operation == "bl" && name[at] ~ /roots_apart/) twice[at] = 1
    else if (target == at && operation == "bl") fail(at, "calls itself")
    else calls[at] = calls[at] " " target
}

function frame_of(f, item, n, i, bytes) {
    n = split(large[f], item, " ")
    for (i = 1; i <= n; i++) {
        if (!(item[i] in word)) { fail(f, "no constant at " item[i]); continue }
        bytes = hex(substr(word[item[i]], 3))
        if (bytes >= 2147483648) frame[f] += 4294967296 - bytes
    }
    return frame[f] * ((f in twice) ? 2 : 1)
}
function bound(f, item, n, i, most, deep) {
    if (f in done) return done[f]
    if (f in open) { fail(f, "calls itself"); return 0 }
    open[f] = 1
    n = split(calls[f], item, " ")
    most = 0
    for (i = 1; i <= n; i++) {
        if (item[i] == f || !(item[i] in name)) continue
        deep = bound(item[i])
        if (deep > most) most = deep
    }
    delete open[f]
    return done[f] = frame_of(f) + most
}

END {
    for (i = 1; i <= count; i++) {
        if (symbol[i] !~ /^kept /) continue
        bytes = bound(address[i])
        # The words of the expression, as in the source.
        row = substr(symbol[i], 6)
        sub(/ <- .*/, "", row)
        gsub(/& /, "\\&", row)
        gsub(/ :: /, "::", row)
        gsub(/::< /, "::<", row)
        gsub(/^{ | }$/, "", row)
        gsub(/\|/, "/", row)
        if (!(row in most)) { order[++rows] = row; least[row] = bytes }
        if (bytes > most[row]) most[row] = bytes
        if (bytes < least[row]) least[row] = bytes
    }
    for (i = 1; i <= rows; i++) {
        row = order[i]
        printf "M0|bound|%s: %s|%d (%d..%d)|0\n", part, row, most[row], least[row], most[row]
    }
    exit failed || !rows
}
