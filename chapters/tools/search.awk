# search.awk -- an index of the book's sections for book.js, which searches without a
# server: [where, page, section, text], one a line.
#
#   awk -v functions=F -f colour.awk -f search.awk PAGES >search.js

function bare(s) {
    gsub(/<[^>]*>/, "", s)
    s = plain(s)
    gsub(/[\t\\]/, " ", s)
    gsub(/"/, "\\\"", s)
    return s
}

function flush() {
    if (where != "") printf "[\"%s\",\"%s\",\"%s\",\"%s\"],\n", where, title, section, body
    body = ""
}

BEGIN { print "const sections = [" }

FNR == 1 {
    flush()
    title = where = ""
    within = shut = 0
}
/^<main>/ { within = 1 }
/^<\/main>/ { within = 0 }
!within { next }
/<pre/ { shut = 1 }
shut {
    if (/<\/pre>/) shut = 0
    next
}
match($0, /<h[1-3] id="[^"]*"/) {
    flush()
    id = substr($0, RSTART + 8, RLENGTH - 9)
    section = bare($0)
    if (title == "") title = section
    where = FILENAME "#" id
    next
}
{ body = body (body == "" ? "" : " ") bare($0) }

END {
    flush()
    while ((getline line < functions) > 0) {
        split(line, w, " ")
        printf "[\"%s.html#%s\",\"%s\",\"%s\",\"\"],\n", w[2], w[1], w[2], w[1]
    }
    print "];"
}
