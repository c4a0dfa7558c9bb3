#!/bin/sh
# The page that a run leaves, as lines "key = value"; where its time went; and how
# far its mean can be trusted.
#
#   sh figures/01/01-tour.sh out/mueller-bed >figures/01/01-tour-run.txt
set -eu
echo "# slow"
echo "# sh figures/01/01-tour.sh $1, after make run"
awk -F'[:,]' '
    { gsub(/[ "]/, "") }
    /seconds:[{]/ { inside = 1; next }
    /[}]/ { inside = 0; next }
    inside && ($1 == "total" || $1 == "processor") { next }
    inside { part[++n] = $1; time[n] = $2; total += $2; next }
    $2 ~ /^[-0-9]/ && $1 !~ /^(exit_code|seed|threads)$/ { print $1 " = " $2 }
    END {
        print "\n## seconds"
        for (k = 1; k <= n; k++)
            printf "%-17s %5.1f %%\n", part[k], 100 * time[k] / total
    }' "$1/summary.json"
printf '\n## blocks\n'
sh figures/12/12-blocks.sh "$1" pressure_drop | sed -n '/^naive\|^error/p'
