#!/bin/sh
# Figures 8 and 9 of SX15: Mueller's bed by diffusion and by the sums of each cell, from
# rest, every 0.04 s to 0.32 s: the spheres with the line eps_s = 0.28, and
# eps_s. Two runs of a minute each; what is there is not run again, and a run that was
# stopped goes on.
#
#   sh figures/26-snapshots.sh build/winnow
set -eu
PATH=$(cd "$(dirname "${1:-build/winnow}")" && pwd):$PATH
out=out/26-snapshots
python=/usr/bin/python3 # Debian's own, which python3-vtk9 belongs to
mkdir -p "$out"
for method in diffusion pcm; do
    dir=$out/$method
    set -- -s output.end=0.32 -s output.every=0.04 -s 'output.profiles=()' \
        -s output.picture=false -s output.checkpoint=0.05 -s averaging.method=$method
    [ $method = diffusion ] || set -- "$@" -s averaging.cap=0.7
    resume=
    ! ls "$dir"/checkpoint* >/dev/null 2>&1 || resume=--resume
    # shellcheck disable=SC2086 # no word, or one
    grep -qs '"exit_reason": "done"' "$dir/summary.json" ||
        winnow run cases/mueller-bed-sx15.cfg -o "$dir" -j 1 --quiet $resume "$@"
    $python figures/26-snapshots.py "$dir" 0.04 "$dir-points.txt" "$dir-field.txt"
done
gnuplot figures/26-snapshots.gp
