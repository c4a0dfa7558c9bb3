#!/bin/sh
# The map of what each choice buys, a table: of each committed study, the first
# measure, the error of the case as it stands, and the cheapest variant that is
# surely within 5, 1 and 0.1 %, with its time over that of the case as it stands.
#
#   25-map.sh figures/25-NAME.txt ...
set -eu
awk '
    # "0.42 s, error 0.8 % +- 0.1 %: step=1e-3": the time, the error, the variant.
    function take(rest) {
        cost = rest + 0
        error = rest ~ /error/ ? rest : "they are compared with it"
        sub(/^.*error /, "", error)
        sub(/:.*/, "", error)
        sub(/^[^:]*: /, "", rest)
        return rest
    }
    function cell(i) {
        if (!found[i]) return stands ~ /compared/ ? "none but itself" : "none"
        return words[i] (standing ? sprintf("; %.2f", found[i] / standing) : "")
    }
    function put() {
        if (name != "")
            printf "| %s | %s | %s | %s | %s |\n", name, stands, cell(1), cell(2), cell(3)
    }
    BEGIN {
        print "| study | as it stands | for 5 % | for 1 % | for 0.1 % |"
        print "| --- | --- | --- | --- | --- |"
    }
    FNR == 1 {
        put()
        name = FILENAME; sub(/.*25-/, "", name); sub(/.txt$/, "", name)
        n = measures = standing = 0; stands = ""
        delete found; delete words
    }
    /, against .*:$/ { measures++ }
    measures != 1 { next }
    /^for .* %: / {
        n++
        rest = $0; sub(/^for [^:]*: /, "", rest)
        if (rest ~ /^none/) next
        words[n] = take(rest)
        found[n] = cost
    }
    /^the case as it stands: / {
        rest = $0; sub(/^[^:]*: /, "", rest)
        take(rest)
        standing = cost
        stands = error
    }
    END { put() }' "$@"
