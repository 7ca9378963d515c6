# Prints the rows of broad phases as Markdown, one table per world:
# awk -f read.awk -f bodies.awk counts.txt
# pivot.awk's output of a measurement works as well. Rows of [pairs] are "sweep, 64 bodies, fixed".
# Rows of [size] and [size, filters] are "sweep, 64 bodies".
BEGIN {
    kinds = split("brute sweep grid hash", kind, " ")
    worlds = split("fixed density cluster", world, " ")
    title["fixed"] = "a world of 1024 x 768"
    title["density"] = "64 x 64 for each"
    title["cluster"] = "all in 256 x 256"
}

section ~ /^(pairs|size)/ {
    split(trim($1), name, ", ")
    n = name[2] + 0
    if (!(n in seen)) { seen[n] = 1; bodies[++rows] = n }
    for (i = 2; i <= NF; i++) {
        if (section == "pairs") plain[column[i] " " name[3] " " name[1] " " n] = int(trim($i) + 0.5)
        if (section == "size") plain[column[i] " size " name[1] " " n] = int(trim($i) + 0.5)
        if (section == "size, filters") masked[column[i] " size " name[1] " " n] = int(trim($i) + 0.5)
    }
}

END {
    for (w = 1; w <= worlds; w++) {
        print "| " title[world[w]] " | M0 brute | sweep | grid | hash | M3 brute | sweep | grid | hash |"
        print "|--:|--:|--:|--:|--:|--:|--:|--:|--:|"
        for (i = 1; i <= rows; i++) {
            line = "| " bodies[i]
            for (m = 0; m <= 3; m += 3) {
                least = 0
                for (k = 1; k <= kinds; k++) {
                    cost[k] = plain["M" m " " world[w] " " kind[k] " " bodies[i]]
                    if (!least || cost[k] < least) least = cost[k]
                }
                for (k = 1; k <= kinds; k++) {
                    line = line " | " (cost[k] == least ? "**" spaced(cost[k]) "**" : spaced(cost[k]))
                }
            }
            print line " |"
        }
        print ""
    }
    print "| a world of 1024 x 768 | M0 regular grid | loose grid | M3 regular grid | loose grid |"
    print "|--:|--:|--:|--:|--:|"
    for (i = 1; i <= rows; i++) {
        line = "| " bodies[i]
        for (m = 0; m <= 3; m += 3)
            line = line " | " spaced(plain["M" m " fixed regular " bodies[i]]) " | " spaced(plain["M" m " fixed grid " bodies[i]])
        print line " |"
    }
    print ""
    print "| bytes of RAM | brute | sweep | grid | hash | *with filters* | *sweep* | *grid* | *hash* |"
    print "|--:|--:|--:|--:|--:|--:|--:|--:|--:|"
    for (i = 1; i <= rows; i++) {
        line = "| " bodies[i]
        for (k = 1; k <= kinds; k++) line = line " | " spaced(plain["M0 size " kind[k] " " bodies[i]])
        for (k = 1; k <= kinds; k++) line = line " | *" spaced(masked["M0 size " kind[k] " " bodies[i]]) "*"
        print line " |"
    }
}
