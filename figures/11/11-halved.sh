#!/bin/sh
# The mean granular temperature of the small bed, ten times as stiff, over 0.3 s,
# for some steps of the particles.
. "$(dirname "$0")/../here.sh"
for step in 1e-4 4e-6 2e-6; do
    winnow run cases/small-bed.cfg -s particles.step=$step -o out/stiff --quiet \
        -s particles.unsafe_step=true \
        -s particles.grains.young=1.2e6 -s output.end=0.3 >/dev/null 2>&1
    columns out/stiff/history.csv granular_temperature |
        awk -v step=$step '{ sum += $1 } END { printf "at_%s = %.2e [m2/s2]\n", step, sum / NR }'
done
