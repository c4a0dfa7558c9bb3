# weave.awk -- fills a chapter with what it quotes, and prints it.
#
#   awk -f c.awk -f weave.awk chapters/09-drag.md
#
# Directives stand on a line of their own and own the fence that follows:
#   <!-- code src/exchange/drag.c drag_beta drag_force -->   definitions by name
#   <!-- code src/exchange/drag.h @head -->        the comment that opens a file
#   <!-- code src/fluid/piso.c @label -->     from /*> label */ to /*< label */
#   <!-- output figures/drag.txt -->                 a text file, whole
#   <!-- output figures/drag.txt part -->            its part under "## part"
#   <!-- tests tests/test_drag.c -->                 the facts that a file shows
# and a number within a line, never at its beginning:
#   about <!-- number figures/drag.txt u_mf %.2f -->0.88<!-- --> m/s
# With -v places=1 a code directive is printed with the line it was found on,
# for the HTML. What cannot be found is said, as chapter:line, and ends in 1.

function wrong(message) {
    print FILENAME ":" FNR ": " message >"/dev/stderr"
    failed = 1
}

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

function show_output(file, section,    k, a) {
    if (section == "") return copy(file, 1, lines[file])
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

# The value under a key: the second word of a line `key = value`, `key value`
# or `"key": value,`.
function number(file, key, form,    k, words, s) {
    if (cut(file) < 0) wrong("cannot read " file)
    for (k = 1; k <= lines[file]; k++) {
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

function numbers(s,    done, words, n) {
    done = ""
    while (match(s, /<!-- number [^>]* -->[^<]*<!-- -->/)) {
        if (RSTART == 1 && done == "")
            wrong("a number cannot begin a line: GitHub takes it for HTML")
        n = split(substr(s, RSTART + 5), words, / /)
        done = done substr(s, 1, RSTART - 1) "<!-- number " words[2] " " \
               words[3] (words[4] == "-->" || words[4] ~ /^-->/ ? "" : " " words[4]) \
               " -->" number(words[2], words[3], words[4] ~ /^-->/ ? "" : words[4]) \
               "<!-- -->"
        s = substr(s, RSTART + RLENGTH)
    }
    if (index(s, "<!-- number")) wrong("a number that nothing ends")
    return done s
}

function fence(language, text,    mark) {
    mark = "```"
    while (index("\n" text, "\n" mark)) mark = mark "`"
    printf "%s%s\n%s%s\n", mark, language, text, mark
}

# Passes over the fence that a directive owns; the line after it is kept.
function skip(    mark) {
    held = ""
    if ((getline held) <= 0) { ended = 1; return }
    if (held !~ /^```/) return
    match(held, /^`+/)
    mark = substr(held, 1, RLENGTH)
    while ((getline held) > 0 && held != mark) ;
    if ((getline held) <= 0) ended = 1
}

function directive(line,    words, n, text) {
    n = split(line, words, / +/) - 1 # "<!--" is dropped, "-->" not counted
    for (i = 1; i < n; i++) words[i] = words[i + 1]
    n--
    if (cut(words[2]) < 0) wrong("cannot read " words[2])
    if (words[1] == "code") text = show_code(words[2], words, n)
    if (words[1] == "output") text = show_output(words[2], words[3])
    if (words[1] == "tests") text = show_tests(words[2])
    if (words[1] == "code" && places) sub(words[2], "&:" place, line)
    print line
    skip()
    fence(words[1] == "code" ? "c" : "text", text)
}

{
    line = $0
    for (;;) {
        if (shut != "") { # inside a fence everything is text
            if (line == shut) shut = ""
            print line
        } else if (line ~ /^(```+|~~~+)/) {
            match(line, /^(`+|~+)/)
            shut = substr(line, 1, RLENGTH)
            print line
        } else if (line ~ /^<!-- (code|output|tests) [^ ].* -->$/) {
            directive(line)
            if (ended) break
            line = held
            continue
        } else if (line ~ /^<!-- (code|output|tests)/) {
            wrong("a directive stands alone on its line")
            print line
        } else
            print numbers(line)
        break
    }
}

END {
    exit failed
}
