# show.awk -- what a directive of a chapter asks for, as text. A library of
# functions for weave.awk, which says in wrong() what cannot be found.

# Lines a to b of a file, without the markers of parts.
function copy(file, a, b,    k, s) {
    s = ""
    for (k = a; k <= b; k++)
        if (source[file, k] !~ /^ *\/\*[<>] /) s = s source[file, k] "\n"
    return s
}

function show_part(file, called,    k, a) {
    for (k = 1; k <= lines[file]; k++) {
        if (index(source[file, k], "/*> " called " */")) a = k + 1
        if (a && index(source[file, k], "/*< " called " */")) {
            place = place ? place : a
            return copy(file, a, k - 1)
        }
    }
    wrong("no part " called " in " file)
    return ""
}

function show_head(file,    k, a) {
    for (a = 1; a <= lines[file] && (source[file, a] !~ /^\/\*/ ||
         source[file, a] ~ /SPDX/); a++) ;
    for (k = a; k < lines[file] && source[file, k] !~ /\*\//; k++) ;
    place = place ? place : a
    return copy(file, a, k)
}

# The definitions with these names, parted as they are in the file.
function show_code(file, names, n,    i, k, text, end) {
    text = ""
    place = end = 0
    for (k = 3; k <= n; k++) {
        if (names[k] == "@head") text = text show_head(file)
        else if (names[k] ~ /^@/) text = text show_part(file, substr(names[k], 2))
        else if (!(i = find(file, names[k])))
            wrong("no " names[k] " in " file)
        else {
            if (text != "" && first[file, i] != end + 1) text = text "\n"
            text = text copy(file, first[file, i], last[file, i])
            end = last[file, i]
            place = place ? place : begin[file, i]
        }
    }
    return text
}

# A part of a text file, or all of it but the mark of a slow transcript.
function show_output(file, section,    k, a) {
    if (section == "")
        return copy(file, source[file, 1] ~ /^# slow/ ? 2 : 1, lines[file])
    for (k = 1; k <= lines[file] && source[file, k] != "## " section; k++) ;
    if (k > lines[file]) wrong("no part " section " in " file)
    for (a = ++k; k <= lines[file] && source[file, k] !~ /^## /; k++) ;
    while (k > a && source[file, k - 1] == "") k--
    return copy(file, a, k - 1)
}

function show_tests(file,    i, s) {
    s = ""
    for (i = 1; i <= items[file]; i++)
        if (kind[file, i] == "test") s = s name[file, i] "\n"
    return s
}

# The value under a key, or under part/key: the second word of the first line
# `key = value`, `key value` or `"key": value,`.
function number(file, key, form,    k, words, s) {
    if (cut(file) < 0) {
        wrong("cannot read " file)
        return "?"
    }
    k = 1
    if (split(key, words, "/") == 2) {
        while (k <= lines[file] && source[file, k] != "## " words[1]) k++
        key = words[2]
    }
    for (; k <= lines[file]; k++) {
        s = source[file, k]
        gsub(/["=:,|]/, " ", s)
        if (split(s, words, /[ \t]+/) && words[1] == "") sub(/^[ \t]+/, "", s)
        split(s, words, /[ \t]+/)
        if (words[1] == key)
            return form == "" ? words[2] : sprintf(form, words[2] + 0)
    }
    wrong("no " key " in " file)
    return "?"
}
