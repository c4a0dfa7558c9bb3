#!/bin/sh
# Exercise 15.1: the heap of cases/open-heap.cfg without friction.
. "$(dirname "$0")/../here.sh"
winnow run cases/open-heap.cfg -o out/slippery -j 1 --quiet \
    -s particles.grains.friction=0 -s particles.grains.rolling_friction=0 >/dev/null 2>&1
for column in particles_out lost_in_normal_dashpots lost_by_sliding \
    energy_residual; do
    sh chapters/tools/last.sh out/slippery "$column"
done
