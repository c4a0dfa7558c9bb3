# tidy.awk -- what pandoc's formulas still want for today's browsers, on stdin.
#
# The TeX source beside each formula is left out, and upright words such as Re,
# which pandoc writes letter by letter in a way that MathML Core has dropped,
# become one word again.

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
    print
}
