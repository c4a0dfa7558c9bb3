#!/bin/sh
# Long runs of the averaging: the Mueller bed on the meshes A to E, by pcm and by
# diffusion, means from 1 s to END; SX15 fig. 4-7 have 18 s. On one core 18 s
# take ten minutes a method on A to C and forty on D; E is run to 3 s
# at most, which takes two hours.
#
#   sh tests/validate/averaging.sh build/winnow [END [MESH...]]
#
# Writes figures/26/26-mueller.txt, draws its figure, and prints the distances from
# the measurement, from the finest mesh and from the mirror image.
set -eu
PATH=$(cd "$(dirname "$1")" && pwd):$PATH
end=${2:-18}
if [ $# -gt 2 ]; then shift 2; else set -- A B "B'" C D E; fi
for mesh; do
    [ "$mesh" != E ] || end=$(awk "BEGIN { print $end < 3 ? $end : 3 }")
    sh figures/26/26-mueller.sh run "$end" "$mesh" >/dev/null
done
sh figures/26/26-mueller.sh collect >figures/26/26-mueller.txt
gnuplot figures/26/26-mueller.gp
sh figures/26/26-break.sh # how pcm ends on the finest meshes
awk -f figures/26/26-mueller.awk figures/data/mueller-2009.txt figures/26/26-mueller.txt

# Is it the averaging or the drag that leaves the walls too dilute? (chapter "Averaging, compared")
winnow run cases/mueller-bed-sx15.cfg --quiet -o out/26-mueller/gidaspow \
    -s exchange.drag=gidaspow -s output.end=5 -s output.every=0.5 >/dev/null
sh chapters/tools/transcript.sh -w "$(command -v winnow)" figures/26/26-count.txt
