#!/bin/sh
# The sum of a column of a run's history: sh figures/03/03-sum.sh out/solution NAME
set -eu
awk -F, -v name="$2" '
    NR == 1 { for (i = 1; i <= NF; i++) if (index($i, name " ") == 1) c = i }
    NR > 1 { sum += $c }
    END { printf "sum of %s = %.6g\n", name, sum }' "$1/history.csv"
