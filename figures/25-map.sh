#!/bin/sh
# The cheapest of each committed study for 5, 1 and 0.1 %, over the cost of the case
# as it stands: from the figures/25-*.txt that are named.
set -eu
awk '
    FNR == 1 { if (name != "") put(); name = FILENAME; sub(/.*25-/, "", name); sub(/.txt$/, "", name)
               n = standing = 0; delete cost; delete words; first = 1; skip = 0 }
    /, against / { skip = !first; first = 0 }
    skip { next }
    /^for .* %: / {
        n++
        rest = $0; sub(/^for [^:]*: /, "", rest)
        if (rest ~ /^none/) { words[n] = "-"; cost[n] = 0; next }
        cost[n] = rest + 0
        sub(/^[^:]*: /, "", rest)
        words[n] = rest
    }
    /^the case as it stands: / {
        rest = $0; sub(/^[^:]*: /, "", rest); standing = rest + 0
        error = "is good for " rest; sub(/is good for .*error /, "is good for ", error)
        if (rest ~ /compared with/) error = "is what the others are compared with"
        sub(/:.*/, "", error)
    }
    function put(    i, text) {
        printf "%s%s\n", name, standing ? ": the case as it stands " error : ""
        for (i = 1; i <= 3; i++) {
            text = ""
            if (cost[i] && standing) text = sprintf(", %.2f of its time", cost[i] / standing)
            printf "  %5s  %s%s\n", i == 1 ? "5 %" : i == 2 ? "1 %" : "0.1 %", words[i], text
        }
    }
    END { put() }' "$@"
