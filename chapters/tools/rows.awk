# rows.awk -- turns chapters/equations.md into the table of `winnow explain KEY`.
#
#   awk -f rows.awk chapters/equations.md >equation_index_rows.c
#
# The book's table is the only one: this follows it, row by row.

BEGIN {
    print "/* Made from chapters/equations.md by chapters/tools/rows.awk. */"
    print "#include \"tell/check.h\"\n"
    print "const struct equation_index_row equation_index_rows[] = {"
}

function emit(kind, name, file) {
    gsub(/["\\]/, "\\\\&", name)
    printf "    {\"%s\", EQUATION_INDEX_%s, \"%s\", \"%s\"},\n", key, kind, name, file
}

# Each link of a cell, [name](file#place).
function links(cell, kind,    part, n, i, name, file) {
    n = split(cell, part, /<br>/)
    for (i = 1; i <= n; i++) {
        if (!match(part[i], /\]\([^)]*\)/)) continue
        name = substr(part[i], 1, RSTART - 1)
        sub(/^ *\[/, "", name)
        gsub(/`/, "", name)
        file = substr(part[i], RSTART + 2, RLENGTH - 3)
        sub(/#.*/, "", file)
        if (!sub(/^\.\.\//, "", file)) file = "chapters/" file
        emit(kind, name, file)
    }
}

/^\| <a id=/ {
    split($0, column, / [|] ?/)
    says = column[1]
    match(says, /[*][*][^*]*[*][*]/)
    key = substr(says, RSTART + 2, RLENGTH - 4)
    says = substr(says, RSTART + RLENGTH + 1)
    status = ""
    if (match(says, /; \*[^*]*\*$/)) {
        status = substr(says, RSTART + 3, RLENGTH - 4)
        says = substr(says, 1, RSTART - 1)
    }
    as = ""
    if (match(says, /; as \[[^]]*\]/)) {
        as = substr(says, RSTART + 6, RLENGTH - 7)
        says = substr(says, 1, RSTART - 1)
    }
    emit("SAYS", says, "")
    if (status != "") emit("STATUS", status, "")
    if (as != "") { emit("AS", as, ""); next }
    links(column[2], "FUNCTION")
    links(column[3], "TEST")
    links(column[4], "SECTION")
}

END { print "    {0}};" }
