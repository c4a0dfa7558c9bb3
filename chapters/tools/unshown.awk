# unshown.awk -- the functions of src/ that a reader should meet and does not.
#
#   awk -f c.awk -f unshown.awk -v exempt=chapters/unshown.txt [-v names=1] \
#       chapters/*.md SOURCES
#
# What counts is public, that is not static or in a header, or cites an equation of
# the documents. To create, initialize and release is housekeeping and does not
# count. A reader has met a function if a chapter shows it, or names it in
# `backquotes`. Prints how many each file has, or a line for each, those with an
# equation first. A line of the list of exemptions is a file, or a file and a
# function; one that exempts nothing ends in 1. Of the calls in listings of the course,
# chapters/[0-9]*.md, at most a tenth may lead to functions that no page shows or names.

FILENAME ~ /\.md$/ {
    if ($0 ~ /^```/) {
        fenced = !fenced
        listing = $0 == "```c"
    }
    if (fenced) {
        if (listing) look_at_calls(bare($0))
        next
    }
    if ($0 ~ /^<!-- code [^ ]+ .* -->$/) show($0)
    for (text = $0; match(text, /`[a-z0-9_]+`/); text = substr(text, RSTART + RLENGTH))
        named[substr(text, RSTART + 1, RLENGTH - 2)] = 1
    next
}

function look_at_calls(s) {
    if (s ~ /^[A-Za-z_].*\(/ && match(s, /[A-Za-z_0-9]+\(/))
        met[substr(s, RSTART, RLENGTH - 1)] = 1
    if (s ~ /^[A-Za-z_#]/ || FILENAME !~ /chapters\/[0-9]/) return
    for (; match(s, /[A-Za-z_][A-Za-z0-9_]*\(/); s = substr(s, RSTART + RLENGTH))
        calls[substr(s, RSTART, RLENGTH - 1)]++
}

# The first citation of the documents within a definition and its comment.
function citation(file, i,    k) {
    for (k = first[file, i]; k <= last[file, i]; k++)
        if (match(source[file, k], /\[(SX15|XS11|LS|EW18) [^]]*\]/))
            return substr(source[file, k], RSTART, RLENGTH)
    return ""
}

function counts(file, i) {
    if (kind[file, i] != "function") return 0
    if (name[file, i] ~ /_(create|free|init|release)$/) return 0
    if (citation(file, i) != "") return 1
    return file ~ /\.h$/ || source[file, begin[file, i]] !~ /^(static|FIELD_GROUPS_KERNEL) /
}

FNR == 1 {
    file = FILENAME
    cut(file)
    for (i = 1; i <= items[file]; i++) {
        if (kind[file, i] == "prototype") cites[name[file, i]] = citation(file, i)
        if (kind[file, i] == "function") defined[name[file, i]] = 1
        if (counts(file, i)) {
            all++
            called = name[file, i]
            at[file, called] = begin[file, i]
            if (citation(file, i) != "") cites[called] = citation(file, i)
            if ((file, called) in shown) seen++
            else if (called in named) spoken++
            else hidden[file] = hidden[file] " " called
        }
    }
}

END {
    while ((getline line < exempt) > 0) {
        if (line ~ /^#/ || line == "") continue
        n = split(line, w, " ")
        if (n == 1 && w[1] in hidden) {
            spared += split(hidden[w[1]], x, " ")
            delete hidden[w[1]]
        } else if (n == 2 && index(hidden[w[1]] " ", " " w[2] " ")) {
            spared++
            sub(" " w[2] " ", " ", hidden[w[1]])
            sub(" " w[2] "$", "", hidden[w[1]])
        } else {
            print exempt ": exempts nothing: " line >"/dev/stderr"
            failed = 1
        }
    }
    for (file in hidden)
        if ((n = split(hidden[file], w, " ")) > 0) {
            left += n
            if (!names) print file ": " n | "sort"
            for (k = 1; names && k <= n; k++) {
                cited = cites[w[k]]
                if (cited != "") equations++
                print (cited != "" ? 0 : 1) "\t" file ":" at[file, w[k]] ": " \
                    w[k] (cited != "" ? " " : "") cited | "sort | cut -f2"
            }
        }
    close(names ? "sort | cut -f2" : "sort")
    for (called in calls)
        if (called in defined) {
            all_calls += calls[called]
            if (!(called in named) && !(called in met)) lost += calls[called]
        }
    print "calls in the course: " all_calls + 0 ", " lost + 0 \
        " to functions that no page shows or names"
    if (10 * lost > all_calls) {
        print "more than a tenth of the calls in the course lead nowhere" >"/dev/stderr"
        failed = 1
    }
    print "unshown: " left + 0 " of " all + 0 " functions of src; " seen + 0 \
        " are shown, " spoken + 0 " named, " spared + 0 " exempt"
    exit failed
}
