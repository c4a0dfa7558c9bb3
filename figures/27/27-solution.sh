#!/bin/sh
# Exercise 27.1: the small bed for 2 s with two bandwidths.
. "$(dirname "$0")/../here.sh"
for b in 4.8e-3 2.4e-3; do
    winnow run cases/small-bed.cfg --quiet -j 1 -o out/27-solution -s output.end=2.0 \
        -s output.every=2.0 -s averaging.bandwidth=$b \
        -s 'effects.mixing={sample=0.004;}' >/dev/null
    echo "b = $b m"
    grep '_rms' out/27-solution/summary.json
    sh chapters/tools/last.sh out/27-solution mixing
done
