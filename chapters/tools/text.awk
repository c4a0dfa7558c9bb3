# text.awk -- checks what the chapters say, before anything is rendered.
#
#   awk -f c.awk -f text.awk PAGES SOURCES
#
# Headings and equations are numbered as the file is, every reference leads to
# an equation or a source that exists, every link to a file, every name in the
# notation to the source; formulas hold no blank line and are displayed on lines
# of their own, in chapters with a number. Chapters are cited by their titles,
# because their numbers move. Says what is wrong as file:line, and ends in 1.

function wrong(message) {
    print FILENAME ":" FNR ": " message >"/dev/stderr"
    failed = 1
}

function there(path,    line, got) {
    got = (getline line < path)
    close(path)
    return got >= 0
}

# Every key in brackets, but those of the four documents, which are the ledger's.
function sources(s,    key) {
    while (match(s, /\[[A-Z][A-Za-z]+[0-9][0-9]+[],]/)) {
        key = substr(s, RSTART + 1, RLENGTH - 2)
        s = substr(s, RSTART + RLENGTH)
        if (key !~ /^(SX15|XS11|EW18)$/) cite[key] = FILENAME ":" FNR
    }
}

function equations(s,    n) {
    while (match(s, /\([0-9]+\.[0-9]+[a-z]?\)[^]]/)) {
        n = substr(s, RSTART + 1, RLENGTH - 3)
        if (substr(s, 1, RSTART) !~ /\[(SX15|XS11|LS|EW18)[^]]*$/)
            refer[n] = FILENAME ":" FNR
        s = substr(s, RSTART + RLENGTH - 1)
    }
}

function links(s,    to, folder) {
    while (match(s, /\]\([^)#]+/)) {
        to = substr(s, RSTART + 2, RLENGTH - 2)
        s = substr(s, RSTART + RLENGTH)
        folder = FILENAME
        sub(/[^\/]*$/, "", folder)
        if (to !~ /^[a-z]+:/ && !there(folder to))
            wrong("no file " to)
    }
}

function titles(s) {
    if (s ~ /[Cc]hapters? [0-9]/) wrong("a chapter is cited by its title")
}

FNR == 1 {
    shut = ""
    formula = 0
    number = FILENAME
    sub(/.*\//, "", number)
    number = number ~ /^[0-9]/ ? number + 0 : 0
    chapter = FILENAME ~ /\.md$/ && FILENAME !~ /README|equations\.md$/
    tags = letters = 0
    if (chapter && number && $0 !~ "^# " number " [A-Z]")
        wrong("the heading is not \"# " number " Title\"")
}

!chapter {
    if (FILENAME ~ /\.[ch]$/) sources($0)
    titles($0)
    next
}

shut != "" {
    if ($0 == shut) shut = ""
    next
}

/^```/ {
    match($0, /^`+/)
    shut = substr($0, 1, RLENGTH)
    if ($0 ~ /^`+[a-z]+ /) wrong("a fence of two words")
    next
}

/^    / && before == "" { next } # indented: code

{
    before = $0
    line = $0
    gsub(/`[^`]*`/, "", line)
}

line ~ /\$\$/ {
    if (line !~ /^\$\$$/) wrong("$$ does not stand alone on its line")
    if (formula && numbered == all && number && FILENAME !~ /solutions/)
        wrong("a displayed formula without \\tag")
    numbered = all
    formula = !formula
    next
}

formula && line == "" { wrong("a blank line in a formula") }

formula && line ~ /^ *([-+*>#]|[0-9]+[.)]) / {
    wrong("a line of a formula begins like a list")
}

match(line, /\\tag[{][^}]*[}]/) {
    tag = substr(line, RSTART + 5, RLENGTH - 6)
    if (!formula) wrong("\\tag outside of $$")
    if (tag in tagged) wrong("(" tag ") is there twice")
    # (5.3a), (5.3b), ... are the lines of a derivation after (5.3).
    if (tag ~ /[a-z]$/) due = tags substr("abcdefghijklmnopqrstuvwxyz", ++letters, 1)
    else {
        due = ++tags
        letters = 0
    }
    all++
    if (tag != number "." due)
        wrong("equation (" tag ") should be (" number "." due ")")
    tagged[tag] = 1
}

!formula {
    n = line
    gsub(/\\\$/, "", n)
    if (n == "" && dollars % 2) wrong("a $ without its pair above")
    dollars = n == "" ? 0 : dollars + gsub(/\$/, "", n)
    sources(line)
    equations(line " ")
    links(line)
    titles(line)
    if (line ~ /[^ ] ##+ /) wrong("a heading within a line")
    while (FILENAME ~ /references/ && match(line, /<a id="[^"]*/)) {
        known[substr(line, RSTART + 7, RLENGTH - 7)] = 1
        line = substr(line, RSTART + RLENGTH)
    }
}

# Files and folders of src, or of the top, in the last column of the list of pages.
FILENAME ~ /chapters\/README/ && /^\| \[/ && (n = split($0, column, " [|] ")) == 5 {
    while (match(column[n], /`[^`]*`/)) {
        place = substr(column[n], RSTART + 1, RLENGTH - 2)
        column[n] = substr(column[n], RSTART + RLENGTH)
        if (system("for of in " place " src/" place " src/" place ".c src/" place ".h; do [ -e $of ] && exit; done; exit 1"))
            wrong("there is no " place)
    }
}

FILENAME ~ /notation/ && /^\|/ && split($0, column, / [|] /) > 2 {
    while (match(column[2], /`[^`]*`/)) {
        names[substr(column[2], RSTART + 1, RLENGTH - 2)] = FILENAME ":" FNR
        column[2] = substr(column[2], RSTART + RLENGTH)
    }
}

END {
    for (key in cite)
        if (!(key in known)) {
            print cite[key] ": [" key "] is not in references.md" >"/dev/stderr"
            failed = 1
        }
    for (n in refer)
        if (!(n in tagged)) {
            print refer[n] ": there is no equation (" n ")" >"/dev/stderr"
            failed = 1
        }
    for (n in names)
        if (n !~ /^_/ && system("grep -rqw -- '" n "' src")) {
            print names[n] ": no " n " in src" >"/dev/stderr"
            failed = 1
        }
    exit failed
}
