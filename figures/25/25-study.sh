#!/bin/sh
# One of the studies in cases/studies: its table, in columns, and what it comes to.
# The picture goes to figures/25/25-NAME.svg. A study of the runs of another one names it.
#
#   25-study.sh NAME [OTHER]
. "$(dirname "$0")/../here.sh"
dir=out/study-${2:-$1}
said=$(winnow study "cases/studies/$1.cfg" -o "$dir" --quiet 2>&1) ||
    { echo "$said" && exit 1; }
# A study whose errors are all zero, as those of threads are, has no picture.
svg=$dir/study.svg
[ ! -e "$svg" ] || cp "$svg" "figures/25/25-$1.svg"
awk -F ' *[|] *' '
    function pad(text, width, left) {
        while (length(text) < width) text = left ? text " " : " " text
        return text "  "
    }
    /^[|] ---/ { next }
    /^[|]/ {
        rows++
        for (i = 2; i < NF; i++) {
            cell[rows, i] = $i
            if (length($i) > wide[i] && $i !~ /^exit code/) wide[i] = length($i)
        }
        if (NF > columns) columns = NF
        next
    }
    /^- / { advice[++lines] = substr($0, 3) }
    /, against .*:$/ && !/^Case|^#/ { advice[++lines] = $0 }
    END {
        for (r = 1; r <= rows; r++) {
            line = ""
            for (i = 2; i < columns; i++)
                line = line pad(cell[r, i], wide[i], i == 2)
            sub(/ *$/, "", line)
            print line
        }
        for (l = 1; l <= lines; l++) print advice[l]
    }' "$dir/study.md"
