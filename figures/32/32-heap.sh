#!/bin/sh
# Heaps of grains of one volume and friction: a bed that runs off at both ends, where walls
# hold it up to 2 mm and what comes there above them is taken away. Of a wedge on a layer
# the mean height gives the angle: five heaps, their mean and its standard error [degrees].
#
#   sh figures/32/32-heap.sh spheres|dumb-bells|tetrahedra
. "$(dirname "$0")/../here.sh"
d=$(awk -v n="$(case $1 in spheres) echo 1 ;; dumb-bells) echo 2 ;; tetrahedra) echo 4 ;; esac)" 'BEGIN { print 1e-3 / n ^ (1 / 3) }')
case $1 in
spheres) echo 0 0 0 ;;
dumb-bells) printf '%s\n' '-0.5 0 0' '0.5 0 0' ;;
tetrahedra) printf '%s\n' '1 1 1' '1 -1 -1' '-1 1 -1' '-1 -1 1' | awk '{ a = 0.5 / sqrt(2); print a * $1, a * $2, a * $3 }' ;;
esac | awk -v d="$d" '{ print d * $1, d * $2, d * $3, d }' >"$work/balls.txt"
grain='clump = "grain";'
[ "$1" != spheres ] || grain='diameter = 1e-3;'
for seed in 1 2 3 4 5; do
    cat >"$work/heap.cfg" <<X
title = "a heap"; mesh = { size = [0.02, 0.08, 0.004]; cells = [1, 1, 1]; periodic = [false, false, true]; };
particles = { contact = "linear"; step = 7e-6;
    grains = { density = 1000; stiffness = 50; restitution = 0.4; friction = 0.5; };
    clumps = ( { name = "grain"; file = "balls.txt"; } );
    bed = { $grain count = 1000; seed = $seed; settle = 0.15; };
    sinks = ( { from = [0.0, 0.002, 0.0]; to = [0.001, 0.08, 0.004]; },
              { from = [0.019, 0.002, 0.0]; to = [0.02, 0.08, 0.004]; } ); };
effects = { gravity = [0.0, -9.81, 0.0]; };
output = { end = 0.3; every = 0.3; history = 0.05; picture = false; };
X
    [ "$1" != spheres ] || sed -i '/clumps = /d' "$work/heap.cfg"
    winnow run "$work/heap.cfg" -o "$work/heap" --quiet --fresh -j 1
    columns "$work/heap/history.csv" mean_height | tail -1
done | awk '
    { h = $1; L = 0.01; h0 = 0.002 # of L (h0 h0/2 + H/2 (h0 + H/3)) over L (h0 + H/2)
      b = h0 / 2 - h / 2; H = 3 * (-b + sqrt(b * b - 4 / 6 * (h0 * h0 / 2 - h * h0)))
      a = atan2(H, L) * 180 / 3.14159265359; n++; sum += a; square += a * a }
    END { m = sum / n; printf "%.1f +- %.1f\n", m, sqrt((square / n - m * m) / (n - 1)) }'
