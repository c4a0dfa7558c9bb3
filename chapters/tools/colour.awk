# colour.awk -- C in colours, a line at a time: comments, words of the language, types,
# functions, strings, numbers. A library for listing.awk, source.awk and steps.awk.
#
# Citations in comments lead where `anchors` says, one "NAME PAGE" a line; a function
# leads to its definition, where `functions` names it, one "NAME FILE" a line. `root`
# stands before all pages.

function colour_begin(    line, w, n, i) {
    while ((getline line < anchors) > 0) {
        split(line, w, " ")
        page_of[w[1]] = w[2]
    }
    while (functions != "" && (getline line < functions) > 0) {
        split(line, w, " ")
        if (w[1] in home && home[w[1]] != w[2]) w[2] = ""
        home[w[1]] = w[2]
    }
    n = split("break case const continue default do else enum extern for goto if inline " \
              "return sizeof static struct switch typedef union void volatile while " \
              "restrict _Alignas _Atomic _Noreturn _Static_assert", w, " ")
    for (i = 1; i <= n; i++) keyword[w[i]] = "kw"
    n = split("char double float int long short signed unsigned FILE", w, " ")
    for (i = 1; i <= n; i++) keyword[w[i]] = "dt"
    keyword["void"] = "dt"
}

function escaped(s) {
    gsub(/&/, "\\&amp;", s)
    gsub(/</, "\\&lt;", s)
    gsub(/>/, "\\&gt;", s)
    return s
}

function plain(s) {
    gsub(/&lt;/, "<", s)
    gsub(/&gt;/, ">", s)
    gsub(/&quot;/, "\"", s)
    gsub(/&#39;/, "'", s)
    gsub(/&amp;/, "\\&", s)
    return s
}

function span(class, s) { return "<span class=\"" class "\">" s "</span>" }

# "(2.12)", "[LS 4.16]", "[Ghia82]", 'Chapter "Drag"': links, where the book knows them.
function with_links(s,    done, text, name, to) {
    done = ""
    while (match(s, /\([0-9]+\.[0-9]+[a-z]?\)|\[[A-Z][A-Za-z0-9]+( [^]]*)?\]|Chapter "[^"]+"/)) {
        text = name = substr(s, RSTART, RLENGTH)
        to = ""
        if (name ~ /^Ch/) {
            gsub(/"/, "", name)
            gsub(/ /, "-", name)
            if (name in page_of) to = page_of[name]
        } else if (name ~ /^\(/) {
            gsub(/\./, "-", name)
            if (text in page_of) to = page_of[text] "#eq-" substr(name, 2, length(name) - 2)
        } else {
            gsub(/[][()]/, "", name)
            sub(/,.*/, "", name)
            if (name ~ / /) {
                if (name !~ /Algorithm/) sub(/-.*/, "", name)
                gsub(/[ .]/, "-", name)
                name = tolower(name)
            }
            if (name in page_of) to = page_of[name] "#" name
        }
        done = done substr(s, 1, RSTART - 1) \
               (to == "" ? text : "<a href=\"" root to "\">" text "</a>")
        s = substr(s, RSTART + RLENGTH)
    }
    return done s
}

# Code without comments.
function coloured(s,    done, w, gap, before) {
    done = ""
    if (s ~ /^ *#/) return span("pp", escaped(s))
    while (match(s, /"([^"\\]|\\.)*"|'([^'\\]|\\.)+'|[A-Za-z_][A-Za-z0-9_]*|[0-9][0-9a-fA-Fx.]*([eE][-+]?[0-9]+)?/)) {
        w = substr(s, RSTART, RLENGTH)
        gap = substr(s, 1, RSTART - 1)
        done = done escaped(gap)
        s = substr(s, RSTART + RLENGTH)
        if (w ~ /^["']/) done = done span("st", escaped(w))
        else if (w ~ /^[0-9]/) done = done span("fl", w)
        else if (w in keyword) done = done span(keyword[w], w)
        else if ((before ~ /^(struct|enum|union)$/ && gap ~ /^ +$/) || w ~ /_t$/) done = done span("dt", w)
        else if (s ~ /^\(/) {
            if (home[w] != "" && !defines)
                done = done "<a class=\"fu\" href=\"" root home[w] ".html#" w "\">" w "</a>"
            else done = done span("fu", w)
        } else done = done w
        before = w
    }
    return done escaped(s)
}

# A line; whether it ends within a comment is kept for the next one.
function colour_line(s,    out, p, q) {
    out = ""
    defines = s ~ /^[A-Za-z_]/ && s ~ /\(/
    while (s != "") {
        p = in_comment ? 1 : index(s, "/*")
        out = out coloured(p ? substr(s, 1, p - 1) : s)
        s = p ? substr(s, p) : ""
        if (!p) continue
        q = index(in_comment ? s : "  " substr(s, 3), "*/")
        out = out span("co", with_links(escaped(q ? substr(s, 1, q + 1) : s)))
        s = q ? substr(s, q + 2) : ""
        in_comment = !q
    }
    return out
}
