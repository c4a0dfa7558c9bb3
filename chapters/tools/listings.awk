# listings.awk -- how much of each chapter is listings of code, by lines that are not empty.
#
#   awk -f listings.awk chapters/[0-9]*.md          each chapter and its share
#   awk -v half=1 -f listings.awk chapters/[0-9]*.md   those that are more than half

function chapter_ends() {
    if (name == "") return
    if (!half) printf "%-40s %.2f\n", name, code / lines
    else if (2 * code > lines)
        printf "note: more than half of %s is listings (%.2f)\n", name, code / lines
}

FNR == 1 {
    chapter_ends()
    name = FILENAME
    shut = ""
    code = lines = 0
}

shut != "" {
    if ($0 == shut) shut = ""
    else if (NF) { lines++; code += listing }
    next
}

/^```/ {
    match($0, /^`+/)
    shut = substr($0, 1, RLENGTH)
    listing = $0 ~ /^`+c$/
    next
}

NF && !/^<!-- (code|output|tests)/ { lines++ }

END { chapter_ends() }
