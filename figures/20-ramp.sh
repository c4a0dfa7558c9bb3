#!/bin/sh
# XS11 Case 1: drop between the sensors over the velocity of the inlet, means over
# 0.1 s, of the runs that tests/validate/coupling.sh left in DIR.
#
#   20-ramp.sh DIR
set -eu
for run in ramp-15x75 ramp-25x100 ramp-pcm-25x100; do
    printf '# %s\n# t [s], U [m/s], drop [Pa]\n' "$run"
    awk -F, 'NR > 2 { k = int($1 / 0.1 + 1e-6); d[k] += $2 - $3; n[k]++; last = k }
        END { for (k = 0; k <= last; k++) if (n[k] > 4) {
            t = 0.1 * k + 0.055
            printf "%.3f %.4f %.2f\n", t, t < 15 ? t / 10 : (30 - t) / 10, d[k] / n[k] } }' \
        "$1/$run/probes.csv"
    printf '\n\n'
done
