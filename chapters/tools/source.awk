# source.awk -- source files as pages, for the book: OUT/FILE.html of each FILE,
# named on stdin. The folders are there.
#
#   ls src/coupling/drag.[ch] |
#       awk -v anchors=A -v functions=F -v out=OUT -f c.awk -f colour.awk -f source.awk
#
# Each line has an address (#L12), each definition its name (#drag_beta);
# citations lead to the table of equations, 'Chapter "Drag"' to the chapter.

BEGIN { colour_begin() }

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
    in_comment = 0
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
        s = file ~ /[.][ch]$/ ? colour_line(source[file, k]) : with_links(escaped(source[file, k]))
        printf "<span id=\"L%d\">%s%s\n</span>", k, at[k], s >page
        delete source[file, k]
    }
    print "</pre>\n</main>\n</body>\n</html>" >page
    close(page)
}
