#!/bin/sh
# Speed [m/s] of the sphere of cases/rolling-sphere.cfg in time [s], then its
# last moments (17-rolling.c).
. "$(dirname "$0")/../here.sh"
winnow run cases/rolling-sphere.cfg -o out/rolling --quiet >/dev/null
awk -F, 'NR == 1 { for (k = 1; k <= NF; k++) if ($k ~ /^momentum_x/) at = k; next }
    NR % 3 == 2 { printf "%.2f %.5f\n", $1, $at / (2500 * atan2(0, -1) / 6 * 1e-6) }' \
    out/rolling/history.csv
echo
echo
sh figures/run.sh figures/17/17-rolling.c
