#!/bin/sh
# XS11 Case 2, Fig. 7: how fast the grains are at the lower sensor, 2 mm above the
# floor, and higher, whatever one changes.
#
#   30-sensor.sh DIR NAME...    runs DIR/sensor-NAME, left by tests/validate/coupling.sh
#
# Means and standard deviations from 0.4 s on.
set -eu
dir=$1
shift
echo "# drop between the sensors [Pa]; deviation of us_y at 2, 10, 25 mm and its largest"
echo "# at 2 mm [mm/s]; eps_f at 2 and 20 mm [-]"
for name in "$@"; do
    echo "## $name"
    awk -F, 'NR > 1 && $1 > 0.4 {
            n++
            drop += $2 - $3
            for (k = 0; k < 3; k++) { u = 1e3 * $(4 + k); s[k] += u; q[k] += u * u }
            a = 1e3 * ($4 < 0 ? -$4 : $4)
            if (a > top) top = a
            low += $7; high += $8
        }
        function deviation(k) { return sqrt(q[k] / n - (s[k] / n) ^ 2) }
        END {
            if (n == 0) exit
            printf "drop = %.0f [Pa]\nus_2 = %.1f [mm/s]\nus_10 = %.0f [mm/s]\n",
                drop / n, deviation(0), deviation(1)
            printf "us_25 = %.0f [mm/s]\nlargest = %.0f [mm/s]\n", deviation(2), top
            printf "eps_2 = %.3f [-]\neps_20 = %.3f [-]\n", low / n, high / n
        }' "$dir/sensor-$name/probes.csv"
done
