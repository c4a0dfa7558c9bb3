#!/bin/sh
# In the loop: the small bed by pcm with a cap and by diffusion, on meshes from
# coarse to fine. Mean void fraction on a line; what became of each run.
#
#   sh figures/26/26-loop.sh END [s]          some seconds a run
. "$(dirname "$0")/../here.sh"
end=${1:-0.4}
mkdir -p out/21-small
for cells in 4,16,1 8,32,1 12,48,1 16,64,1; do
    for method in pcm diffusion; do
        cap=
        [ $method = pcm ] && cap="-s averaging.cap=0.7"
        dir=out/21-small/$method-$(echo "$cells" | tr , -)
        code=0
        # shellcheck disable=SC2086 # two words or none
        winnow run cases/small-bed.cfg -o "$dir" -s mesh.cells="[$cells]" \
            -s averaging.method=$method $cap -s output.end="$end" \
            -s output.profiles="({field=\"eps_f\";height=0.012;from=0.15;})" \
            --quiet >"$dir.log" 2>&1 || code=$?
        echo "# cells $cells, $method: exit $code," \
            "steps with a capped cell:" \
            "$(summary "$dir" steps_with_capped_cells)," \
            "steps: $(summary "$dir" steps)"
        cat "$dir"/profiles/*.csv
        echo
        echo
    done
done
