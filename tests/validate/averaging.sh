#!/bin/sh
# Long runs of the averaging: the Mueller bed on the meshes A to D, by pcm and by
# diffusion, means from 1 s to END; SX15 fig. 4-7 have 18 s. An hour of one core
# for each 5 s on A to C, three for D.
#
#   sh tests/validate/averaging.sh build/winnow [END [MESH...]]
#
# Writes figures/21-mueller.txt, draws its figure, and prints the distances from
# the measurement, from the finest mesh and from the mirror image.
set -eu
PATH=$(cd "$(dirname "$1")" && pwd):$PATH
shift
[ $# -gt 0 ] || set -- 18
sh figures/21-mueller.sh run "$@" >/dev/null
sh figures/21-mueller.sh collect >figures/21-mueller.txt
gnuplot figures/21-mueller.gp
sh figures/21-break.sh # how pcm ends on the finest meshes
awk -f figures/21-mueller.awk figures/data/mueller-2009.txt figures/21-mueller.txt
