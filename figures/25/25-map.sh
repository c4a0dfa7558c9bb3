#!/bin/sh
# The map of what each choice buys, a table: of each committed study the choice that it is
# about, and by its first measure the error of the case as it stands, and the cheapest
# variant that is certainly within 5, 1 and 0.1 %, with its time over that of the case as it
# stands.
#
#   25-map.sh figures/25/25-NAME.txt ...
set -eu
awk '
    # "0.42 s, error 0.8 % +- 0.1 %: step=1e-3": the time, the error, the variant.
    function take(rest) {
        cost = rest + 0
        error = rest ~ /, (error|difference) / ? rest : "the reference itself"
        sub(/^.*, (error|difference) /, "", error)
        sub(/:.*/, "", error)
        sub(/^[^:]*: /, "", rest)
        return rest
    }
    function cell(i) {
        if (!found[i]) return stands ~ /itself/ ? "none but itself" : "none"
        return words[i] (standing ? sprintf("; %.2f", found[i] / standing) : "")
    }
    function put() {
        if (name != "")
            printf "| %s | `%s` | %s | %s | %s | %s |\n", choice[name], name, stands,
                cell(1), cell(2), cell(3)
    }
    function about(text, names,    n, part) {
        for (n = split(names, part, " "); n > 0; n--) choice[part[n]] = text
    }
    BEGIN {
        about("particle step", "particle-step")
        about("contact stiffness", "bed-stiffness")
        about("contact law", "bed-contact")
        about("list skin", "skin bed-skin")
        about("fluid step, time scheme, mesh", "fluid-step")
        about("fluid step", "bed-fluid-step")
        about("time scheme, slip integration", "bed-time")
        about("mesh, averaging method", "bed-mesh bed-vertical sx15-mesh sx15-vertical")
        about("convection, mesh", "convection")
        about("convection", "bed-convection")
        about("correctors", "correctors bed-correctors")
        about("tolerance", "tolerance bed-tolerance")
        about("averaging method", "averaging packed-column bed-averaging")
        about("bandwidth", "bandwidth bed-bandwidth sx15-bandwidth")
        about("scheme of the diffusion", "diffusion")
        about("interpolation", "interpolation bed-interpolation")
        about("treatment of the drag", "treatment bed-treatment")
        about("slip integration, fluid step", "settling")
        about("sub-steps, slip integration", "substeps")
        about("sub-steps, treatment", "bed-seepage xs11-seepage")
        about("1, 2 and 4-way coupling", "coupling")
        about("1 and 2-way coupling", "bed-coupling")
        about("drag law", "bed-drag")
        about("slip at the walls", "bed-walls")
        about("threads", "threads")
        print "| choice | study | as it stands | for 5 % | for 1 % | for 0.1 % |"
        print "| --- | --- | --- | --- | --- | --- |"
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
        if (rest ~ /^none of/) next
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
