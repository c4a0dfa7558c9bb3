# tidy.awk -- what pandoc's formulas still want for today's browsers, on stdin.
#
# The TeX source beside each formula is left out; upright words such as Re,
# which pandoc writes letter by letter in a way that MathML Core has dropped,
# become one word again; and parentheses in a line of text do not grow.

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
    done = ""
    while ((a = index($0, "<math display=\"inline\"")) > 0) {
        done = done substr($0, 1, a - 1)
        $0 = substr($0, a)
        a = index($0, "</math>") + 7
        formula = substr($0, 1, a - 1)
        gsub(/stretchy="true"/, "stretchy=\"false\"", formula)
        done = done formula
        $0 = substr($0, a)
    }
    print done $0
}
