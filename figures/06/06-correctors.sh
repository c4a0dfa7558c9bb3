#!/bin/sh
# The small bed with more correctors, and with other tolerances: what the last
# step leaves of momentum and of volume, with no further correctors where it leaves much.
. "$(dirname "$0")/../here.sh"
echo 'correctors tolerance  splitting  mass       momentum   drop [Pa]'
for pair in '1 1e-8' '2 1e-8' '3 1e-8' '2 1e-4' '2 1e-12'; do
    # shellcheck disable=SC2086 # two words
    set -- $pair
    winnow run cases/small-bed.cfg --quiet -o out/06-correctors \
        -s output.end=0.04 -s fluid.correctors="$1" -s fluid.tolerance="$2" -s fluid.piso_tolerance=0 \
        >/dev/null 2>&1
    sh chapters/tools/last.sh out/06-correctors piso_splitting mass_residual \
        momentum_residual pressure_drop | awk -v c="$1" -v t="$2" '
        { v[NR] = $3 }
        END {
            printf "%10d %9s %10.1e %10.1e %10.1e %10.3f\n", c, t, v[1], v[2],
                v[3], v[4]
        }'
done
