#!/bin/sh
# Figures 8 and 9 of SX15: a slice of Mueller's bed, one cell of mesh C deep, by diffusion
# and by the sums of each cell, every 0.04 s from 0.20 to 0.48 s: the spheres with the line
# eps_s = 0.28, and eps_s. What is there is not run again, and a run that was stopped goes
# on. The whole bed: SLICE= sh figures/26/26-snapshots.sh build/winnow
#
#   sh figures/26/26-snapshots.sh
. "$(dirname "$0")/../here.sh"
out=out/26-snapshots
python=/usr/bin/python3 # Debian's own, which python3-vtk9 belongs to
slice=${SLICE-"-s mesh.size=[0.044,0.12,0.0025] -s mesh.cells=[18,50,1] -s particles.bed.count=2310"}
[ -n "$slice" ] || out=$out-whole
mkdir -p "$out"
for method in diffusion pcm; do
    dir=$out/$method
    set -- -s output.end=0.48 -s output.every=0.04 -s 'output.profiles=()' \
        -s output.picture=false -s output.checkpoint=0.05 -s averaging.method=$method
    [ $method = diffusion ] || set -- "$@" -s averaging.cap=0.7
    resume=
    ! ls "$dir"/checkpoint* >/dev/null 2>&1 || resume=--resume
    # shellcheck disable=SC2086 # words
    grep -qs '"exit_reason": "done"' "$dir/summary.json" ||
        winnow run cases/mueller-bed-sx15.cfg -o "$dir" -j 1 --quiet $resume $slice "$@"
    $python figures/26/26-snapshots.py "$dir" 0.2 "$dir-points.txt" "$dir-field.txt"
done
gnuplot -e "dir = '$out/'" figures/26/26-snapshots.gp
