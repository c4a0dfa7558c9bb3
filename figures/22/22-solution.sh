#!/bin/sh
# Exercise 22.1: the history force of ever denser beads, estimated and measured.
. "$(dirname "$0")/../here.sh"
for density in 1e4 3e4 1e5; do
    echo "density $density kg/m^3"
    winnow check cases/history-sphere.cfg -s particles.grains.density=$density |
        grep basset
    winnow run cases/history-sphere.cfg -s particles.grains.density=$density \
        -o out/22-dense 2>/dev/null | grep basset
done
