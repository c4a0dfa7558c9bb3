# unshown.awk -- the functions of src/ that no chapter shows.
#
#   awk -f c.awk -f unshown.awk -v exempt=chapters/unshown.txt [-v names=1] \
#       chapters/*.md SOURCES
#
# Prints how many each file has, or their names. A line of the list of exemptions
# is a file, or a file and a function; one that exempts nothing ends in 1.

FILENAME ~ /\.md$/ {
    if ($0 ~ /^```/) fenced = !fenced
    if (!fenced && $0 ~ /^<!-- code [^ ]+ .* -->$/) {
        n = split($0, w, " ")
        for (k = 4; k < n; k++) show(w[3], w[k])
    }
    next
}

# A part, @label, shows the function that it is in.
function show(file, called,    k, i) {
    cut(file)
    if (called ~ /^@/) {
        called = "/*> " substr(called, 2) " */"
        for (k = 1; k <= lines[file] && !index(source[file, k], called); k++) ;
        for (i = 1; i <= items[file]; i++)
            if (begin[file, i] <= k && k <= last[file, i])
                called = name[file, i]
    }
    shown[file, called] = 1
}

FNR == 1 {
    file = FILENAME
    cut(file)
    for (i = 1; i <= items[file]; i++)
        if (kind[file, i] == "function") {
            all++
            if ((file, name[file, i]) in shown) seen++
            else hidden[file] = hidden[file] " " name[file, i]
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
            print file ":" (names ? hidden[file] : " " n) | "sort"
        }
    close("sort")
    print "unshown: " left + 0 " of " all " functions in src; " seen + 0 \
        " are shown, " spared + 0 " exempt"
    exit failed
}
