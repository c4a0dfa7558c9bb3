#!/bin/sh
# In the loop: a bed by pcm with a cap and by diffusion, on meshes from coarse to
# fine. Mean void fraction on a line; what became of each run.
#
#   sh figures/21-loop.sh small          the small bed, some seconds a run
#   sh figures/21-loop.sh mueller END    SX15 fig. 4-7 to END [s], minutes to hours
set -eu
which=$1
end=${2:-0.4}
case $which in
small)
    case_file=cases/small-bed.cfg
    meshes="4,16,1 8,32,1 12,48,1 16,64,1"
    height=0.012
    ;;
mueller)
    case_file=cases/mueller-bed.cfg
    meshes="6,16,1 9,25,2 12,32,3 18,50,4 36,100,8"
    height=0.0164
    ;;
esac
for cells in $meshes; do
    for method in pcm diffusion; do
        cap=
        [ $method = pcm ] && cap="-s averaging.cap=0.7"
        dir=out/21-$which/$method-$(echo "$cells" | tr , -)
        code=0
        # shellcheck disable=SC2086 # two words or none
        winnow run $case_file -o "$dir" -s mesh.cells="[$cells]" \
            -s averaging.method=$method $cap -s output.end="$end" \
            -s output.profiles="({field=\"eps_f\";height=$height;from=0.15;})" \
            --quiet >"$dir.log" 2>&1 || code=$?
        echo "# cells $cells, $method: exit $code," \
            "steps with a capped cell:" \
            "$(sed -n 's/.*"steps_with_capped_cells": \([0-9]*\).*/\1/p' "$dir/summary.json")," \
            "steps: $(sed -n 's/.*"steps": \([0-9]*\).*/\1/p' "$dir/summary.json")"
        cat "$dir"/profiles/*.csv
        echo
        echo
    done
done
