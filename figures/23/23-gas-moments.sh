#!/bin/sh
# Figure 18b of EW18: the bed in a gas with a Gaussian on cells of half a diameter (GK-2),
# every 2 d/u_in from 56 to 70: the grains that the plane through the middle cuts, over the
# upward velocity of the gas there. What is there is not run again, and a run that was
# stopped goes on: four minutes of a core.
#
#   sh figures/23/23-gas-moments.sh
. "$(dirname "$0")/../here.sh"
out=out/23-gas-moments
python=/usr/bin/python3 # Debian's own, which python3-vtk9 belongs to
resume=
! ls $out/checkpoint* >/dev/null 2>&1 || resume=--resume
grep -qs '"simulated_seconds": 70,' $out/summary.json ||
    winnow run cases/ew18-gas.cfg -o $out -j 1 --quiet $resume -s 'mesh.cells=[20,100,20]' \
        -s output.end=70 -s output.every=2 -s output.picture=false -s output.checkpoint=10
$python figures/26/26-snapshots.py $out 56 $out/points.txt $out/field.txt 0.5
gnuplot figures/23/23-gas-moments.gp
