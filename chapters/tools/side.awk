# side.awk -- puts the contents of the book at the side of a page, on stdin, with the
# sections of the page below its name, and the part that it belongs to open.
#
#   awk -v plan=PLAN -v page=09-drag -f side.awk
#
# A line of PLAN is "part Course", "group A small bed" or "page 09-drag 9 Drag".

function put(    line, name, i, here, part) {
    while ((getline line < plan) > 0) {
        text[++n] = line
        if (line ~ /^part /) part = n
        if (line ~ "^page " page " ") here = part
    }
    for (i = 1; i <= n; i++) {
        name = text[i]
        sub(/^[a-z]+ /, "", name)
        if (text[i] ~ /^part /) {
            printf "%s<details%s><summary>%s</summary>\n<ul>\n", (any++ ? "</ul></details>\n" : ""),
                (i == here || (!here && i == 1) ? " open=\"open\"" : ""), name
        } else if (text[i] ~ /^group /) {
            printf "<li class=\"group\">%s</li>\n", name
        } else {
            split(name, w, " ")
            if (w[1] ~ /^step-/ && page !~ /^step/) continue
            sub(/^[^ ]* /, "", name)
            printf "<li><a href=\"%s.html\"%s>%s</a>%s</li>\n", w[1],
                (w[1] == page ? " aria-current=\"page\"" : ""), name, (w[1] == page ? toc : "")
        }
    }
    if (any) print "</ul></details>"
}

/^<!-- toc -->$/ {
    while ((getline) > 0 && !/^<!-- \/toc -->$/) toc = toc $0 "\n"
    next
}
/^<!-- side -->$/ { put(); next }
{ print }
