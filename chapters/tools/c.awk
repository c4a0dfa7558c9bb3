# c.awk -- cuts a C file into its top-level definitions. A library of functions
# for weave.awk and ledger.awk; it trusts the layout of clang-format: what
# begins in column one begins a definition.
#
# After cut(file), for i from 1 to items[file]:
#   name[file, i]     what it defines; the words of an anonymous enum
#   kind[file, i]     function, prototype, type, table, define or test
#   first[file, i]    line on which the comment above it begins
#   begin[file, i]    line on which it begins itself
#   last[file, i]     its last line
# and source[file, k] is line k of lines[file]; -1 lines: no such file.

function cut(file,    text, n) {
    if (file in lines) return lines[file]
    n = 0
    while ((got = getline text < file) > 0) source[file, ++n] = text
    close(file)
    lines[file] = got < 0 ? -1 : n
    items[file] = 0
    if (file ~ /\.[ch]$/) cut_items(file, n)
    return lines[file]
}

function cut_items(file, n,    k, text, above) {
    above = 0 # the line on which a comment began that nothing parts from here
    for (k = 1; k <= n; k++) {
        text = source[file, k]
        if (text ~ /^\/\*/) {
            if (!above) above = k
            while (k < n && source[file, k] !~ /\*\//) k++
            if (source[file, k] ~ /SPDX/) above = 0
        } else if (text ~ /^[A-Za-z_]/ || text ~ /^# *define /) {
            k = cut_item(file, k, n, above ? above : k)
            above = 0
        } else
            above = 0
    }
}

# Notes the definition that begins on line k; returns its last line.
function cut_item(file, k, n, above,    i, depth, code, all) {
    i = ++items[file]
    first[file, i] = above
    begin[file, i] = k
    all = ""
    inside = 0 # a comment
    depth = 0
    if (source[file, k] ~ /^#/) {
        all = source[file, k]
        while (k < n && source[file, k] ~ /\\$/) k++
    } else
        for (; k <= n; k++) {
            code = bare(source[file, k])
            all = all " " code
            depth += gsub(/[{]/, "{", code) - gsub(/[}]/, "}", code)
            if (depth == 0 && code ~ /[;}] *$/) break
            if (source[file, k + 1] == "" && all ~ /^ [A-Z_]+[(].*[)]$/) break
        }
    last[file, i] = k
    label(file, i, all)
    return k
}

# A line without comments, and with nothing in its strings.
function bare(s,    p) {
    if (inside) {
        if (!(p = index(s, "*/"))) return ""
        s = substr(s, p + 2)
        inside = 0
    }
    gsub(/"([^"\\]|\\.)*"/, "\"\"", s)
    gsub(/'([^'\\]|\\.)'/, "0", s)
    while ((p = index(s, "/*")) > 0)
        if (match(substr(s, p), /\*\//))
            s = substr(s, 1, p - 1) " " substr(s, p + RSTART + 1)
        else {
            s = substr(s, 1, p - 1)
            inside = 1
        }
    sub(/[ \t]+$/, "", s)
    return s
}

# Finds the name and the kind from the text of a definition.
function label(file, i, all,    head, end, words, k) {
    sub(/^ +/, "", all)
    if (sub(/^# *define +/, "", all)) {
        match(all, /^[A-Za-z_0-9]+/)
        note(file, i, "define", substr(all, 1, RLENGTH))
        return
    }
    if (sub(/^FACT(_FOR_EACH)?\( */, "", all)) {
        match(all, /^[a-z_0-9A-Z]+/)
        note(file, i, "test", substr(all, 1, RLENGTH))
        return
    }
    match(all, /[{;=]/)
    head = substr(all, 1, RSTART - 1)
    end = substr(all, RSTART, 1)
    sub(/ +$/, "", head)
    if (match(head, /[A-Za-z_0-9]+\(/))
        note(file, i, end == "{" ? "function" : "prototype",
             substr(head, RSTART, RLENGTH - 1))
    else if (head == "enum") {
        gsub(/[^A-Za-z_0-9 ]|= *[0-9]+/, " ", all)
        sub(/^ *enum +/, "", all)
        note(file, i, "type", all)
    } else if (end == "{" && head ~ /^(struct|enum|union) [A-Za-z_0-9]+$/)
        note(file, i, "type", word_last(head))
    else if (end == ";" && head ~ /^(struct|enum|union) [A-Za-z_0-9]+$/)
        note(file, i, "forward", "")
    else if (head ~ /struct$/ && match(all, /[}] *[a-z_0-9]+/)) {
        note(file, i, "table", word_last(substr(all, RSTART, RLENGTH)))
    } else {
        sub(/ *\[.*/, "", head)
        note(file, i, head ~ /^extern/ ? "prototype" : "table", word_last(head))
    }
}

function note(file, i, what, called) {
    kind[file, i] = what
    name[file, i] = called
}

function word_last(s) {
    match(s, /[A-Za-z_0-9]+$/)
    return substr(s, RSTART)
}

# The definition of that name in a file that was cut, or 0: what has a body goes
# before a prototype.
function find(file, called,    i, found) {
    found = 0
    for (i = 1; i <= items[file]; i++)
        if (index(" " name[file, i] " ", " " called " ") &&
            (!found || kind[file, found] == "prototype"))
            if (!found || kind[file, i] != "prototype") found = i
    return found
}

# What a directive of a page shows: afterwards (file, name) is in shown. A part, @label,
# shows the function that it is in.
function show(directive,    w, n, j, file, called, k, i) {
    n = split(directive, w, " ")
    file = w[3]
    for (j = 4; j < n; j++) {
        cut(file)
        called = w[j]
        if (called ~ /^@/) {
            called = "/*> " substr(called, 2) " */"
            for (k = 1; k <= lines[file] && !index(source[file, k], called); k++) ;
            for (i = 1; i <= items[file]; i++)
                if (begin[file, i] <= k && k <= last[file, i]) called = name[file, i]
        }
        shown[file, called] = 1
    }
}
