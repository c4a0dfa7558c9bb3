# Every key of `winnow list keys` is in a case of the pairs, or in untried.txt with its
# reason. Prints what is in neither, and what need not be in untried.txt.
#
#   awk -v winnow=winnow -f tried.awk untried.txt *.cfg *.set

FILENAME ~ /untried[.]txt$/ {
    if (/^[a-z]/) reason[substr($1, 1, length($1) - 1)]
    next
}
FNR == 1 { depth = 0 }
{
    gsub(/"[^"]*"/, "")
    while (match($0, /[A-Za-z_.0-9]+ *=|[;{}]/)) {
        word = substr($0, RSTART, RLENGTH)
        $0 = substr($0, RSTART + RLENGTH)
        if (word == "{") within[++depth] = path == "" ? within[depth] : path
        if (word == "}") depth--
        path = ""
        if (word !~ /=/) continue
        sub(/ *=/, "", word)
        path = depth ? within[depth] "." word : word
        sub(/^fluid[.](left|right|bottom|top|back|front)/, "fluid.<patch>", path)
        tried[path]
    }
}

END {
    while ((("\"" winnow "\" list keys") | getline line) > 0) {
        if (line !~ /^[a-z]/) continue
        sub(/ = .*/, "", line)
        if (line in tried && line in reason)
            wrong[++n] = line " is tried by pairs, and in untried.txt"
        else if (!(line in tried) && !(line in reason))
            wrong[++n] = line " is tried by no pair of choices: see tests/pairs/choices.awk"
        delete reason[line]
    }
    for (line in reason) wrong[++n] = "untried.txt names " line ", which is no key"
    for (i = 1; i <= n; i++) print wrong[i]
    exit n > 0
}
