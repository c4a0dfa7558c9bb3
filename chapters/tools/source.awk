# source.awk -- source files as pages, for the book: OUT/FILE.html of each FILE,
# named on stdin. The folders are there.
#
#   ls src/coupling/drag.[ch] | awk -f c.awk -f source.awk -v anchors=A -v out=OUT
#
# Each line has an address (#L12), each definition its name (#drag_beta);
# citations lead to the table of equations, 'Chapter "Drag"' to the chapter.

# Turns what `form` matches into a link, if page_of knows where to.
function with_links(s,    done, text, name, to) {
    done = ""
    while (match(s, /\[(SX15|XS11|LS|EW18) [^]]*\]|Chapter "[^"]+"/)) {
        text = substr(s, RSTART, RLENGTH)
        name = text
        if (text ~ /^Ch/) {
            gsub(/"/, "", name)
            gsub(/ /, "-", name)
            to = page_of[name]
        } else {
            gsub(/[][()]/, "", name)
            sub(/,.*/, "", name)
            if (name !~ /Algorithm/) sub(/-.*/, "", name)
            gsub(/[ .]/, "-", name)
            name = tolower(name)
            to = name in page_of ? page_of[name] "#" name : ""
        }
        done = done substr(s, 1, RSTART - 1) \
               (to == "" ? text : "<a href=\"" root to "\">" text "</a>")
        s = substr(s, RSTART + RLENGTH)
    }
    return done s
}

BEGIN {
    while ((getline line < anchors) > 0) {
        split(line, w, " ")
        page_of[w[1]] = w[2]
    }
}

# Puts the names of the definitions at the lines where they begin.
function find_names(file,    i, n, w, seen) {
    split("", at)
    for (i = 1; i <= items[file]; i++) {
        n = split(name[file, i], w, " ")
        for (; n > 0; n--)
            if (!(w[n] in seen)) {
                seen[w[n]] = 1
                at[begin[file, i]] = at[begin[file, i]] "<a id=\"" w[n] "\"></a>"
            }
    }
}

{
    file = $0
    page = out "/" file ".html"
    root = file
    gsub(/[^\/]+\//, "../", root)
    sub(/[^\/]*$/, "", root)
    cut(file)
    find_names(file)
    print "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\" />" >page
    print "<meta name=\"viewport\" content=\"width=device-width\" />" >page
    print "<meta name=\"color-scheme\" content=\"light dark\" />" >page
    print "<title>" file "</title>" >page
    print "<link rel=\"stylesheet\" href=\"" root "book.css\" />\n</head>" >page
    print "<body class=\"source\">\n<nav class=\"top\"><a href=\"" root \
        "index.html\">Winnow</a> <span>" file "</span></nav>\n<main>\n<pre>" >page
    for (k = 1; k <= lines[file]; k++) {
        s = source[file, k]
        gsub(/&/, "\\&amp;", s)
        gsub(/</, "\\&lt;", s)
        gsub(/>/, "\\&gt;", s)
        printf "<span id=\"L%d\">%s%s\n</span>", k, at[k], with_links(s) >page
        delete source[file, k]
    }
    print "</pre>\n</main>\n</body>\n</html>" >page
    close(page)
}
