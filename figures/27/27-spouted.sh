#!/bin/sh
# The spouted bed: mean velocities of the spheres at six heights, from the profiles of
# a run, for figures/27/27-spouted.txt.
#
#   sh figures/27/27-spouted.sh FOLDER
set -eu
end=$(sed -n 's/.*"simulated_seconds": \([0-9.]*\).*/\1/p' "$1/summary.json")
echo "# cases/spouted-bed.cfg, means from 1 s to $end s"
echo "# height [mm], x from the middle [mm], us_x, us_y [m/s]"
for y in "$1"/profiles/us_y_*.csv; do
    name=$(basename "$y" .csv)
    height=${name#us_y_y} height=${height%%mm*}
    join -t, "$1/profiles/us_x${name#us_y}.csv" "$y" |
        awk -F, -v h="$height" '
            NR == 1 { for (k = 2; k <= NF; k++) if ($k ~ /^us_y_mean/) up = k; next }
            $2 != "nan" { printf "%g %8.2f %8.5f %8.5f\n", h, 1000 * $1 - 140, $2, $up }'
done
