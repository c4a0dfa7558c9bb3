#!/bin/sh
# Exercise 8.1: the pressure drop of the small bed after 0.01 s, by steps of
# Crank-Nicolson on two meshes. The bed settles once, for the first run; the
# others read it.
. "$(dirname "$0")/../here.sh"
mkdir -p out
rm -f out/08-solution.bed
cp cases/small-bed.cfg out/08-solution.cfg # a bed is written beside its case
drop() { # cells, options
    cells=$1
    shift
    winnow run out/08-solution.cfg -o out/solution -s output.end=0.01 --quiet \
        -j 1 -s "mesh.cells=[$cells]" -s particles.bed.file=./08-solution.bed "$@" >/dev/null 2>&1 ||
        { echo breaks down; return; }
    sh chapters/tools/last.sh out/solution pressure_drop
}
for cells in "8, 32, 1" "16, 64, 1"; do
    for steps in 1 3 12; do
        printf '%s, %2d steps: ' "$cells" $steps
        drop "$cells" -s averaging.scheme=crank-nicolson \
            -s averaging.steps=$steps
    done
    printf '%s, exponential: ' "$cells"
    drop "$cells"
done
