# documents.awk -- how far each figure and table of the four documents is made again.
#
#   awk -f chapters/tools/documents.awk chapters/documents/[elsx]*.md
#
# A row of these pages begins with | **Fig. 3** and ends with a word: beside (with
# their numbers), kind (the same is shown, without their numbers), partly, missing, or
# sketch (no result). Fails where a figure has no row, or two, or another word.

BEGIN {
    FS = " *[|] *"
    all["xs11"] = "Fig. 1-11, Table 1-4"
    all["sx15"] = "Fig. 1-10, Table 1-3"
    all["ls"] = "Fig. 3.1-3.1, Fig. 4.1-4.7, Fig. 5.1-5.6"
    all["ew18"] = "Fig. 1-20, Fig. B.1-B.2, Table 1-2"
    n_words = split("beside kind partly missing sketch", words, " ")
}

/^[|] [*][*](Fig|Table)/ {
    page = FILENAME
    gsub(/^.*\/|[.]md$/, "", page)
    gsub(/[*]/, "", $2)
    rows[page, $2]++
    count[page, $(NF - 1)]++
}

END {
    print "| document | with their numbers beside | in kind | partly | missing | no result |"
    print "| --- | --- | --- | --- | --- | --- |"
    n = split("xs11 sx15 ls ew18", pages, " ")
    for (i = 1; i <= n; i++) {
        page = pages[i]
        line = "| [" toupper(page) "](" page ".md)"
        for (k = 1; k <= n_words; k++) {
            line = line " | " count[page, words[k]] + 0
            found += count[page, words[k]]
        }
        print line " |"
        for (k = split(all[page], spans, ", "); k; k--) {
            prefix = spans[k]
            sub(/[0-9]+-.*/, "", prefix)
            ends = substr(spans[k], length(prefix) + 1)
            split(ends, end, "-")
            sub(/.*[.]/, "", end[2])
            for (f = end[1]; f <= end[2]; f++) {
                wanted++
                if (rows[page, prefix f] != 1) {
                    print page ": " prefix f " has " rows[page, prefix f] + 0 " rows"
                    bad = 1
                }
            }
        }
    }
    if (found != wanted) print found + 0 " rows with a word, " wanted " figures and tables"
    exit bad || found != wanted
}
