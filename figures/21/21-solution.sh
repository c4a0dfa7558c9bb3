#!/bin/sh
# Exercise 21.1: the small bed by every method for 0.01 s, on two meshes. It
# settles once, for the first run; the others read it.
. "$(dirname "$0")/../here.sh"
mkdir -p out
rm -f out/21-solution.bed
cp cases/small-bed.cfg out/21-solution.cfg # a bed is written beside its case
for cells in "8, 32, 1" "16, 64, 1"; do
    for method in dpvm cube two-grid images diffusion; do
        printf '%s %-10s' "$cells" $method
        winnow run out/21-solution.cfg -o out/21-solution -s output.end=0.01 \
            --quiet -j 1 -s "mesh.cells=[$cells]" -s particles.bed.file=./21-solution.bed \
            -s averaging.method=$method >/dev/null 2>&1 ||
            { echo stops; continue; }
        sh chapters/tools/last.sh out/21-solution pressure_drop
    done
done
