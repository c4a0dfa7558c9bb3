#!/bin/sh
# Speed [m/s] of the sphere of cases/rolling-sphere.cfg in time [s], then its
# last moments (17-rolling.c).
. "$(dirname "$0")/../here.sh"
winnow run cases/rolling-sphere.cfg -o out/rolling --quiet >/dev/null
columns out/rolling/history.csv time momentum_x |
    awk 'NR % 3 == 1 { printf "%.2f %.5f\n", $1, $2 / (2500 * atan2(0, -1) / 6 * 1e-6) }'
echo
echo
sh figures/run.sh figures/17/17-rolling.c
