#!/bin/sh
# The page that a run leaves, as lines "key = value", and where its time went.
#
#   sh figures/01-tour.sh out/mueller-bed >figures/01-tour-run.txt
set -eu
echo "# slow"
echo "# sh figures/01-tour.sh $1, after make run on one core"
awk -F'[:,]' '
    { gsub(/[ "]/, "") }
    /seconds:[{]/ { inside = 1; next }
    /[}]/ { inside = 0; next }
    inside && $1 == "total" { next }
    inside { part[++n] = $1; time[n] = $2; total += $2; next }
    $2 ~ /^[-0-9]/ && $1 !~ /^(exit_code|seed|threads)$/ { print $1 " = " $2 }
    END {
        print "\n## seconds"
        for (k = 1; k <= n; k++)
            printf "%-9s %6.1f s %5.1f %%\n", part[k], time[k], 100 * time[k] / total
    }' "$1/summary.json"
