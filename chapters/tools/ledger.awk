# ledger.awk -- where each equation is computed, tested and explained.
#
#   awk -f c.awk -f cite.awk -f table.awk -f ledger.awk -v ledger=chapters/ledger.txt \
#       -v pending=chapters/pending.txt [-v left=FILE] FILES >chapters/equations.md
#
# FILES are sources, tests and chapters, by their paths. Prints the table for the
# book; says on standard error what is wrong, and then ends in 1. What pending
# lists may be missing for now; what of it is still missing is written to left.

function wrong(message) {
    print message >"/dev/stderr"
    failed = 1
}

# Adds a link to what a key has of a kind, once.
function add(have, k, link) {
    k = stands_for(k)
    if (!index("\n" have[k] "\n", "\n" link "\n"))
        have[k] = have[k] (have[k] == "" ? "" : "\n") link
}

# The definition of a prototype's function, as a link.
function link_to(file, i,    called, at) {
    called = name[file, i]
    at = kind[file, i] == "prototype" && called in home ? home[called] : file
    return "[`" called "`](../" at "#" called ")"
}

function note_cites(file, line, i) {
    if (unknown != "") wrong(file ":" line ": no such equation:" unknown)
    for (k = 1; i && k <= n_cited; k++)
        if (kind[file, i] == "test")
            add(tests, cited[k], link_to(file, i))
        else if (file ~ /^src/ && kind[file, i] ~ /^(function|prototype)$/)
            add(functions, cited[k], link_to(file, i))
}

function read_source(file,    i, k, n, line) {
    n = cut(file)
    i = 1
    for (k = 1; k <= n; k++) {
        while (i <= items[file] && last[file, i] < k) i++
        line = source[file, k]
        if (line ~ /\[(SX15|XS11|LS|EW18) [^]]*$/) { # goes on in the next line
            sub(/^ *\**/, "", source[file, k + 1])
            line = line source[file, k + 1]
        }
        cites(line, in_brackets)
        note_cites(file, k, i <= items[file] && first[file, i] <= k ? i : 0)
        cites(line, in_quotes)
        note_cites(file, k, 0)
        if (match(line, /[{]"(SX15|XS11|LS|EW18):[^"]*"/)) {
            line = substr(line, RSTART + 2, RLENGTH - 3)
            for (i2 = 1; i2 <= n_cited; i2++)
                evals[cited[i2]] = "`winnow eval " line "`"
        }
    }
    for (i = 1; i <= items[file]; i++)
        if (kind[file, i] == "test") {
            cites_name(name[file, i])
            note_cites(file, begin[file, i], i)
        }
}

function read_chapter(file,    line, n, shut, place, called) {
    while ((getline line < file) > 0) {
        n++
        if (shut != "") {
            if (line == shut) shut = ""
            continue
        }
        if (match(line, /^```+/)) shut = substr(line, 1, RLENGTH)
        if (line ~ /^#+ /) {
            sub(/^#+ /, "", line)
            called = line
            place = tolower(line)
            gsub(/[^a-z0-9 _-]/, "", place)
            gsub(/ /, "-", place)
        }
        cites(line, in_brackets)
        if (unknown != "") wrong(file ":" n ": no such equation:" unknown)
        for (k = 1; k <= n_cited; k++)
            add(chapters, cited[k], "[" called "](" substr(file, 10) "#" place ")")
    }
}

# What a key lacks that its status claims.
function lacks(k,    s) {
    s = ""
    if (status[k] ~ /^(done|in part)/)
        s = (functions[k] == "" ? " function" : "") \
            (tests[k] == "" ? " test" : "") (chapters[k] == "" ? " chapter" : "")
    else if (functions[k] != "" && tests[k] != "" && chapters[k] != "")
        wrong(ledger ": " k " is computed, tested and explained: say done")
    else if (functions[k] != "" && tests[k] == "")
        s = " test"
    else if (tests[k] != "" && chapters[k] == "")
        s = " chapter"
    return s
}

function check_pending(    line, k, w, n, i, s) {
    while ((getline line < pending) > 0)
        if (line !~ /^#/ && match(line, /: /))
            waits[substr(line, 1, RSTART - 1)] = substr(line, RSTART + 1)
    for (i = 1; i <= n_keys; i++) {
        k = key[i]
        if (status[k] ~ /^as /) continue
        s = lacks(k)
        if (s != "" && left != "") print k ":" s >left
        n = split(s, w, " ")
        for (; n > 0; n--)
            if (!index(waits[k] " ", " " w[n] " "))
                wrong(k " (" title[k] ") is \"" status[k] "\" without a " w[n])
    }
}

BEGIN {
    load_ledger(ledger)
    for (a = 1; a < ARGC; a++)
        if (ARGV[a] ~ /^src.*\.c$/) {
            cut(ARGV[a])
            for (i = 1; i <= items[ARGV[a]]; i++)
                if (kind[ARGV[a], i] == "function")
                    home[name[ARGV[a], i]] = ARGV[a]
        }
    for (a = 1; a < ARGC; a++)
        if (ARGV[a] ~ /\.[ch]$/) read_source(ARGV[a])
        else read_chapter(ARGV[a])
    check_pending()
    table()
    exit failed
}
