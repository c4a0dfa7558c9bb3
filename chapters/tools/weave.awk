# weave.awk -- fills a chapter with what it quotes, and prints it.
#
#   awk -f c.awk -f show.awk -f weave.awk chapters/09-drag.md
#
# Directives stand on a line of their own and own the fence that follows:
#   <!-- code src/coupling/drag.c drag_beta drag_force -->   definitions by name
#   <!-- code src/coupling/drag.h @head -->        the comment that opens a file
#   <!-- code src/fluid/piso.c @label -->     from /*> label */ to /*< label */
#   <!-- output figures/09/drag.txt -->                 a text file, whole
#   <!-- output figures/09/drag.txt part -->            its part under "## part"
#   <!-- tests tests/test_drag.c -->                 the facts that a file shows
# or, of a text file with lines | a | b |, the table below it:
#   <!-- table figures/map.txt -->
# or a table of the functions that the listings above call and that no page shows, where
# -v calls=FILE has the index that calls.awk makes:
#   <!-- calls -->
# and a number within a line, never at its beginning:
#   about <!-- number figures/09/drag.txt u_mf %.2f -->0.88<!-- --> m/s
# Figures of a chapter are numbered: below a paragraph that is an image stands one that
# begins with **Figure 9.1.**; where it is missing it is made of what the image is called.
# Sketches, figures/steps/step-*.svg and sketch-*.svg, have no number but **Sketch.**
# With -v places=1 a code directive is printed with the line it was found on,
# for the HTML. What cannot be found is said, as chapter:line, and ends in 1.

function wrong(message) {
    print FILENAME ":" FNR ": " message >"/dev/stderr"
    failed = 1
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

# Passes over a table, and the empty line before it; the line after it is kept.
function skip_table(    any) {
    any = getline held
    if (any > 0 && held == "") any = getline held
    while (any > 0 && held ~ /^[|]/) any = getline held
    if (any <= 0) ended = 1
}

# The lines of a file that belong to a table.
function table(file,    k, text) {
    for (k = 1; k <= lines[file]; k++)
        if (source[file, k] ~ /^[|]/) text = text source[file, k] "\n"
    if (text == "") wrong("no table in " file)
    return text
}

function load_calls(    line, w) {
    while ((getline line < calls) > 0) {
        split(line, w, "\t")
        is_shown[w[2], w[1]] = w[3]
        says[w[2], w[1]] = w[5]
        if (!w[4]) continue
        if (w[1] in public) w[2] = ""
        public[w[1]] = w[2]
    }
}

# Notes the functions that a listing of this file calls.
function note_calls(file, text,    n, k, part, s, called, at) {
    n = split(text, part, "\n")
    inside = 0
    for (k = 1; k <= n; k++) {
        s = bare(part[k])
        if (part[k] ~ /^[A-Za-z_#]/) continue
        for (; match(s, /[A-Za-z_][A-Za-z0-9_]*\(/); s = substr(s, RSTART + RLENGTH)) {
            called = substr(s, RSTART, RLENGTH - 1)
            at = (file, called) in is_shown ? file : public[called]
            if (at == "" || is_shown[at, called] || noted[called]++) continue
            call[++n_calls] = called
            call_in[n_calls] = at
        }
    }
}

# Their table, by file.
function called_table(    i, k, text, up) {
    up = FILENAME ~ /chapters\/[^\/]*$/ ? "../" : "../../"
    text = "| function | file | what it does |\n| --- | --- | --- |\n"
    for (i = 2; i <= n_calls; i++)
        for (k = i; k > 1 && call_in[k] call[k] < call_in[k - 1] call[k - 1]; k--) {
            swap = call[k]; call[k] = call[k - 1]; call[k - 1] = swap
            swap = call_in[k]; call_in[k] = call_in[k - 1]; call_in[k - 1] = swap
        }
    for (i = 1; i <= n_calls; i++)
        text = text "| [`" call[i] "`](" up call_in[i] "#" call[i] ") | `" \
            substr(call_in[i], 5) "` | " says[call_in[i], call[i]] " |\n"
    return text
}

function directive(line,    words, n, text, mark) {
    mark = line
    gsub(/^<!-- | -->$/, "", mark)
    n = split(mark, words, / +/)
    if (cut(words[2]) < 0) wrong("cannot read " words[2])
    if (words[1] == "code") text = show_code(words[2], words, n)
    if (words[1] == "output") text = show_output(words[2], n > 2 ? words[3] : "")
    if (words[1] == "tests") text = show_tests(words[2])
    if (words[1] == "code" && calls != "") note_calls(words[2], text)
    if (words[1] == "code" && places) sub(words[2], "&:" place, line)
    print line
    if (words[1] == "table") {
        skip_table()
        printf "\n%s%s", table(words[2]), ended || held == "" ? "" : "\n"
        return
    }
    skip()
    fence(words[1] == "code" ? "c" : words[2] ~ /patch$/ ? "diff" : "text", text)
}

# The caption of the image above: its number, or all of it.
function caption(line,    mark, n, words, i, out) {
    mark = FILENAME
    sub(/.*\//, "", mark)
    mark = sketch ? "**Sketch.**" : \
           "**Figure " (mark + 0 ? mark + 0 "." : "") ++figures ".**"
    if (line ~ /^\*\*(Figure|Sketch)/) {
        sub(/^\*\*(Figure|Sketch)[^*]*\*\*/, mark, line)
        return line
    }
    out = mark
    n = split(image, words, / +/)
    for (i = 1; i <= n; i++) {
        if (length(out) + 1 + length(words[i]) > 80 &&
            words[i] !~ /^([-+*#>]|[0-9]+[.)])$/) { print out; out = words[i] }
        else out = out " " words[i]
    }
    print out
    print ""
    return line
}

# An image that is a paragraph, over one line or several; what it is called is kept.
function see_image(line) {
    if (before == "" && line ~ /^!\[/) image = opened = ""
    if (before == "" && line ~ /^!\[/) opened = 1
    if (opened) {
        image = image (image == "" ? "" : " ") line
        if (line ~ /[.](svg|png)\)$/) {
            opened = ""
            sketch = line ~ /figures\/[a-z]*\/(step|sketch)-/
            sub(/^!\[/, "", image)
            sub(/\]\([^()]*\)$/, "", image)
            if (image !~ /[.]$/) image = image "."
            due = chaptered
        } else if (line == "") opened = image = ""
    }
    before = line
}

BEGIN { if (calls != "") load_calls() }

FNR == 1 { chaptered = FILENAME ~ /\/([0-9][0-9]-|journal\/|manual\/)[^\/]*[.]md$/ && FILENAME !~ /solutions/ }

{
    line = $0
    for (;;) {
        if (due && shut == "" && line != "") {
            due = 0
            line = caption(line)
        }
        if (shut != "") { # inside a fence everything is text
            if (line == shut) shut = ""
            print line
        } else if (line ~ /^(```+|~~~+)/) {
            match(line, /^(`+|~+)/)
            shut = substr(line, 1, RLENGTH)
            print line
        } else if (line ~ /^<!-- (code|output|tests|table) [^ ].* -->$/) {
            directive(line)
            if (ended) break
            line = held
            continue
        } else if (line == "<!-- calls -->" && calls != "") {
            print line
            skip_table()
            printf "\n%s%s", called_table(), ended || held == "" ? "" : "\n"
            if (ended) break
            line = held
            continue
        } else if (line ~ /^<!-- (code|output|tests|table)/) {
            wrong("a directive stands alone on its line")
            print line
        } else {
            see_image(line)
            print numbers(line)
        }
        break
    }
}

END {
    if (due) {
        print ""
        line = caption("")
    }
    exit failed
}
