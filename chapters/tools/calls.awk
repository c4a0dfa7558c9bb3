# calls.awk -- all functions of src/, for weave.awk, which lists what the listings of a page
# call: name, file, whether a page shows it, whether it is public, and what the first
# sentence of its comment says; tabs between.
#
#   awk -f c.awk -f calls.awk PAGES SOURCES

/^<!-- code [^ ]+ .* -->$/ && FILENAME ~ /\.md$/ { show($0) }
FILENAME ~ /\.md$/ { next }

function sentence(file, i,    k, s) {
    s = ""
    for (k = first[file, i]; k < begin[file, i]; k++) s = s " " source[file, k]
    gsub(/\/\*|\*\/|^ *\* | +\* /, " ", s)
    gsub(/  +/, " ", s)
    sub(/^ /, "", s)
    if (match(s, /[.:;]( |$)/)) s = substr(s, 1, RSTART - 1)
    gsub(/[|]/, "\\|", s)
    gsub(/</, "\\&lt;", s)
    gsub(/[*]/, "\\*", s)
    sub(/ $/, "", s)
    return length(s) > 140 ? "" : s
}

FNR == 1 {
    cut(FILENAME)
    for (i = 1; i <= items[FILENAME]; i++) {
        called = name[FILENAME, i]
        if (kind[FILENAME, i] == "prototype") said[called] = sentence(FILENAME, i)
        if (kind[FILENAME, i] != "function") continue
        at[++n_at] = FILENAME "\t" called
        own[n_at] = sentence(FILENAME, i)
        public[n_at] = FILENAME ~ /\.h$/ || source[FILENAME, begin[FILENAME, i]] !~ /^static /
    }
    nextfile
}

END {
    for (k = 1; k <= n_at; k++) {
        split(at[k], w, "\t")
        print w[2] "\t" w[1] "\t" ((w[1], w[2]) in shown) "\t" public[k] "\t" \
            (own[k] != "" ? own[k] : public[k] ? said[w[2]] : "")
    }
}
