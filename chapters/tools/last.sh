#!/bin/sh
# The last values of columns of a run's history, for transcripts.
#
#   sh chapters/tools/last.sh out/settling mean_fall_velocity pressure_drop
set -eu
dir=$1
shift
awk -F, -v wanted="$*" '
    NR == 1 { for (i = 1; i <= NF; i++) title[i] = $i }
    { last = $0 }
    END {
        n = split(wanted, want, " ")
        split(last, value, ",")
        for (k = 1; k <= n; k++) {
            found = 0
            for (i in title)
                if (index(title[i], want[k] " ") == 1) {
                    unit = substr(title[i], length(want[k]) + 2)
                    printf "%s = %.6g %s\n", want[k], value[i], unit
                    found = 1
                }
            if (!found) { print "no column " want[k]; exit 1 }
        }
    }' "$dir/history.csv"
