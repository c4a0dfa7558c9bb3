#!/bin/sh
# The means across Mueller's bed of the study bed-parcels (figures/25/25-study.sh): at three
# places, void fraction 16.4 mm above the floor, and upward velocity of the solids at 15 mm.
. "$(dirname "$0")/../here.sh"
echo '# variant; x [mm]: eps_f [-], us_y [m/s]'
for run in out/study-bed-parcels/runs/*/; do
    paste -d, "$run/profiles/eps_f_y16.4mm.csv" "$run/profiles/us_y_y15mm.csv" |
        awk -F, -v name="$(basename "$run")" '
            NR == 1 { for (i = 1; i <= NF; i++) if ($i ~ /^us_y_mean/) us = i; printf "%-37s", name }
            NR == 2 || NR == 7 || NR == 13 { printf "  %4.1f: %.3f %7.3f", 1000 * $1, $2, $us }
            END { print "" }'
done
