# tidy.awk -- what pandoc's formulas still want for today's browsers, on stdin.
#
# The TeX source beside each formula is left out; upright words such as Re,
# which pandoc writes letter by letter in a way that MathML Core has dropped,
# become one word again; dots, tildes and bars stand above the middle of their letter
# (as combining characters they stand beside it); parentheses grow only around
# something tall; and the sign of a root does not hang below a low letter.

# The formula, with parentheses that grow only around something tall.
function small(s,    n, part, k, depth, mark, out) {
    mark = "<mo stretchy=\"true\" form=\""
    n = split(s, part, mark)
    depth = 0
    for (k = 1; k <= n; k++) {
        grows[k] = 1
        if (part[k] ~ /^(pre|post)fix">[{}]/) # alone in cases
            continue
        if (part[k] ~ /^prefix/) {
            open[++depth] = k
            tall[depth] = 0
        } else if (part[k] ~ /^postfix/ && depth > 0) {
            grows[k] = grows[open[depth]] = tall[depth]
            if (tall[depth--] && depth) tall[depth] = 1
        }
        if (depth && s ~ /display="block"/ &&
            part[k] ~ /<mfrac|<mtable|<munder|<msqrt|>∑<|>∫</)
            tall[depth] = 1
    }
    out = part[1]
    for (k = 2; k <= n; k++)
        out = out (grows[k] == 0 ? "<mo stretchy=\"false\" form=\"" : mark) part[k]
    return out
}

{
    while (match($0, /<annotation[^>]*>/)) {
        head = substr($0, 1, RSTART - 1)
        while (!match($0, /<\/annotation>/))
            if ((getline) <= 0) exit 1
        $0 = head substr($0, RSTART + RLENGTH)
    }
    upright = "<mstyle mathvariant=\"normal\">(<m[ino]>[^<]*</m[ino]>)+</mstyle>"
    while (match($0, upright)) {
        word = substr($0, RSTART, RLENGTH)
        gsub(/<[^>]*>/, "", word)
        $0 = substr($0, 1, RSTART - 1) "<mi mathvariant=\"normal\">" word \
             "</mi>" substr($0, RSTART + RLENGTH)
    }
    gsub(/<mo accent="true">\314\207</, "<mo accent=\"true\">\313\231<") # dot
    gsub(/<mo accent="true">\314\203</, "<mo accent=\"true\">\313\234<") # tilde
    gsub(/<mo accent="true">\302\257</, "<mo accent=\"true\">\342\200\276<") # bar
    gsub(/<mo>\342\204\223<\/mo>/, "<mi>\342\204\223</mi>") # a script l is no operator
    gsub(/<mi>V<\/mi><mfrac>/, "<mi>V</mi><mspace width=\"0.15em\"/><mfrac>") # V leans over it
    gsub(/<msqrt>/, "<msqrt><mspace width=\"0em\" height=\"0.85em\"/>")
    done = ""
    while ((a = index($0, "<math display=")) > 0) {
        done = done substr($0, 1, a - 1)
        $0 = substr($0, a)
        a = index($0, "</math>") + 7
        done = done small(substr($0, 1, a - 1))
        $0 = substr($0, a)
    }
    print done $0
}
