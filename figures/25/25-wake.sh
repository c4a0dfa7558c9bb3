#!/bin/sh
# SX15 Fig. 10: how the defect of velocity fades behind a sphere in a stream, on its axis.
# Laminar, far behind: Re C_d d / (32 x), which has the momentum that the drag takes (C_d by
# Schiller and Naumann); and a resolved sphere at Re = 50, 8 cells in a diameter, in a box of
# 6 x 16 x 6 diameters with slip walls. (At Re = 5 the wake is as wide as this box.) Minutes.
#
#   sh figures/25/25-wake.sh
. "$(dirname "$0")/../here.sh"
c=${CELLS:-8} out=out/25-wake probes=
for x in 1 2 3 4 6 8 10; do
    probes="$probes{ field = \"u_y\"; position = [3.0, $((4 + x)).0, 3.0]; },"
done
mkdir -p $out
Re=50
cat >$out/$Re.cfg <<CASE
title = "The wake of a sphere, Re = $Re";
mesh = { size = [6.0, 16.0, 6.0]; cells = [$((6 * c)), $((16 * c)), $((6 * c))]; };
fluid = { density = 1.0; viscosity = $(awk "BEGIN { print 1 / $Re }"); step = 0.05; time = "bdf2"; convection = "linear";
          bottom = { inlet = 1.0; }; top = { outlet = 0.0; }; sides = "slip"; front_back = "slip"; };
bodies = { spheres = ( { position = [3.0, 4.0, 3.0]; diameter = 1.0; motion = "fixed"; } ); };
output = { end = 20.0; every = 20.0; history = 1.0; picture = false;
           probes = ( ${probes%,} ); };
CASE
grep -qs '"exit_reason": "done"' $out/$Re/summary.json ||
    winnow run $out/$Re.cfg -o $out/$Re --quiet -j 1 --fresh >/dev/null
echo "# x/d; laminar, Re = 0.5, 5, 50; resolved, Re = 50"
k=1
for x in 1 2 3 4 6 8 10; do
    printf '%2d' $x
    for r in 0.5 5 50; do
        winnow eval drag:schiller-naumann eps_f=1 Re=$r |
            awk -v x=$x '{ printf " %6.3f", 24 * $3 / 32 / x }' # Re C_d is 24 F
    done
    k=$((k + 1))
    tail -n 1 $out/$Re/probes.csv | cut -d, -f$k | awk '{ printf " %6.3f\n", 1 - $1 }'
done
