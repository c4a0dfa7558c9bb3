# steps.awk -- a step of the course as a listing: coloured, its citations as
# links, and marked where no step before it has the same line.
#
#   awk -v anchors=A -v root="" -f steps.awk BEFORE.c ... STEP.c
#
# The last file is the one that is shown.

BEGIN {
    while ((getline line < anchors) > 0) {
        split(line, w, " ")
        page_of[w[1]] = w[2]
    }
    shown = ARGV[ARGC - 1]
    n = split("break case char const continue do double else enum extern float for if " \
              "inline int long return sizeof static struct typedef void while field size_t", w, " ")
    for (i = 1; i <= n; i++) keyword[w[i]]
    while ((getline line < shown) > 0) text[++lines] = line
}
FILENAME == shown { nextfile }
{ earlier[key($0)] }

# A line, whatever its comment is aligned with.
function key(s) {
    gsub(/  +/, " ", s)
    return s
}

function escaped(s) {
    gsub(/&/, "\\&amp;", s)
    gsub(/</, "\\&lt;", s)
    gsub(/>/, "\\&gt;", s)
    return s
}
function span(class, s) { return "<span class=\"" class "\">" s "</span>" }

# "(2.12)", "[LS 4.16]", "[Ghia82]": links, where the book knows them.
function with_links(s,    done, text, name, to) {
    done = ""
    while (match(s, /\([0-9]+\.[0-9]+\)|\[[A-Z][A-Za-z0-9]+( [0-9.]+[a-z]?(, [0-9.]+[a-z]?)*)?\]/)) {
        text = substr(s, RSTART, RLENGTH)
        name = text
        if (name ~ /^\(/) {
            gsub(/\./, "-", name)
            to = text in page_of ? page_of[text] "#eq-" substr(name, 2, length(name) - 2) : ""
        } else {
            gsub(/[][]/, "", name)
            if (name ~ / /) {
                sub(/,.*/, "", name)
                gsub(/[ .]/, "-", name)
                name = tolower(name)
                to = name in page_of ? page_of[name] "#" name : ""
            } else to = name in page_of ? page_of[name] "#" name : ""
        }
        done = done substr(s, 1, RSTART - 1) (to == "" ? text : "<a href=\"" to "\">" text "</a>")
        s = substr(s, RSTART + RLENGTH)
    }
    return done s
}

# Code without comments: words, numbers, strings.
function coloured(s,    done, w) {
    done = ""
    if (s ~ /^#/) return span("pp", escaped(s))
    while (match(s, /"([^"\\]|\\.)*"|[A-Za-z_][A-Za-z0-9_]*|[0-9][0-9a-fA-Fx.]*([eE][-+]?[0-9]+)?/)) {
        w = substr(s, RSTART, RLENGTH)
        done = done escaped(substr(s, 1, RSTART - 1))
        s = substr(s, RSTART + RLENGTH)
        if (w ~ /^"/) done = done span("st", escaped(w))
        else if (w ~ /^[0-9]/) done = done span("fl", w)
        else if (w in keyword) done = done span("kw", w)
        else if (s ~ /^\(/) done = done span("fu", w)
        else done = done w
    }
    return done escaped(s)
}

END {
    inside = 0
    printf "<pre class=\"step\">"
    for (k = 1; k <= lines; k++) {
        s = text[k]
        out = ""
        while (s != "") {
            p = inside ? 1 : index(s, "/*")
            out = out coloured(p ? substr(s, 1, p - 1) : s)
            s = p ? substr(s, p) : ""
            if (!p) continue
            q = index(inside ? s : "  " substr(s, 3), "*/")
            out = out span("co", with_links(escaped(q ? substr(s, 1, q + 1) : s)))
            s = q ? substr(s, q + 2) : ""
            inside = !q
        }
        new = ARGC > 2 && !(key(text[k]) in earlier)
        printf "<span id=\"L%d\"%s>%s\n</span>", k, new ? " class=\"new\"" : "", out
    }
    print "</pre>"
}
