#!/bin/sh
# The drop of cases/drop-cohesion.cfg, wet, hardly wet and dry: how high the
# grains lie in the end and how many touch, then where they are.
# Columns of the three blocks: x and y [mm], the farthest grain first.
. "$(dirname "$0")/../here.sh"
run() { # NAME TENSION
    winnow run cases/drop-cohesion.cfg -s effects.capillary.tension=$2 \
        -o out/drop-$1 --quiet >/dev/null
    for what in mean_height contacts; do
        sh chapters/tools/last.sh out/drop-$1 $what | sed "s/^/$1_/"
    done
}
run wet 0.072
run damp 0.02
run dry 1e-9
for name in wet damp dry; do
    echo
    echo
    echo "# $name"
    awk '!/^#/ { printf "%.2f %.2f\n", 1e3 * $1, 1e3 * $2 }' \
        out/drop-$name/picture/particles.txt
done
