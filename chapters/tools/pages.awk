# pages.awk -- checks rendered pages: every page parses, and every link, image
# and address in it leads somewhere; no TeX is left.
#
#   cd build/book && find . -name '*.html' -o -name '*.svg' ... | awk -f pages.awk
#
# Reads the names of all files of the book; says what is wrong; ends in 1 then.

function wrong(message) {
    print message >"/dev/stderr"
    failed = 1
}

# a/b/../c is a/c.
function straight(path) {
    while (match(path, /[^\/.]+\/\.\.\//))
        path = substr(path, 1, RSTART - 1) substr(path, RSTART + RLENGTH)
    return path
}

function tag(file, s,    called, v) {
    called = s
    sub(/^[\/!?]*/, "", called)
    match(called, /^[A-Za-z0-9]+/)
    called = substr(called, 1, RLENGTH)
    if (called == "a") {
        if (s !~ /^\// && linked) wrong(file ": a link within a link")
        linked = s !~ /^\//
    }
    if (s ~ /^[!?]/ || s ~ /\/$/) ;
    else if (s ~ /^\//) {
        if (depth == 0 || open[depth] != called)
            wrong(file ": </" called "> closes <" open[depth] ">")
        depth--
    } else
        open[++depth] = called
    if (match(s, / id="[^"]*"/)) {
        v = substr(s, RSTART + 5, RLENGTH - 6)
        if ((file, v) in id) wrong(file ": two things called #" v)
        id[file, v] = 1
    }
    if (match(s, / (href|src)="[^"]*"/)) {
        v = substr(s, RSTART, RLENGTH)
        sub(/^[^"]*"/, "", v)
        sub(/"$/, "", v)
        link[++n_links] = v
        from[n_links] = file
    }
}

# What stands between two tags.
function text(file, s) {
    if (raw > 0) return
    if (s ~ /\$|\\[a-z]+|\\tag/) wrong(file ": raw TeX: " substr(s, 1, 60))
}

function read_page(file,    whole, line, parts, n, i, p) {
    whole = ""
    while ((getline line < file) > 0) whole = whole line " "
    close(file)
    depth = raw = 0
    n = split(whole, parts, "<")
    for (i = 2; i <= n; i++) {
        p = index(parts[i], ">")
        if (!p) wrong(file ": a tag that nothing ends")
        if (parts[i] ~ /^(code|pre)/) raw++
        tag(file, substr(parts[i], 1, p - 1))
        if (parts[i] ~ /^\/(code|pre)/) raw--
        text(file, substr(parts[i], p + 1))
    }
    if (depth) wrong(file ": <" open[depth] "> is never closed")
}

{
    sub(/^\.\//, "")
    exists[$0] = 1
    if (/\.html$/) page[++n_pages] = $0
}

END {
    for (i = 1; i <= n_pages; i++) read_page(page[i])
    for (i = 1; i <= n_links; i++) {
        if (link[i] ~ /^[a-z]+:/) continue
        place = link[i]
        sub(/^[^#]*#?/, "", place)
        file = link[i]
        sub(/#.*/, "", file)
        folder = from[i]
        sub(/[^\/]*$/, "", folder)
        file = file == "" ? from[i] : straight(folder file)
        if (!(file in exists)) wrong(from[i] ": broken link: " link[i])
        else if (place != "" && !((file, place) in id))
            wrong(from[i] ": no such place: " link[i])
    }
    print "book: " n_pages " pages, " n_links " links"
    exit failed
}
