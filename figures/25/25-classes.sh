#!/bin/sh
# The mean heights of small, medium and large grains (XS11 Fig. 11) at the end of those runs
# of cases/studies/xs11-seepage.cfg that came to their end.
. "$(dirname "$0")/../here.sh"
python=/usr/bin/python3 # Debian's own, which python3-vtk9 belongs to
winnow study cases/studies/xs11-seepage.cfg -o out/study-xs11-seepage --quiet >/dev/null 2>&1
echo "# t [s], mean height of small, medium, large [mm], small over large"
for run in out/study-xs11-seepage/runs/*; do
    grep -q '"exit_reason": "done"' "$run/summary.json" || continue
    $python figures/30/30-classes.py heights "$run" | tail -n 1 | tr '\n' ' '
    echo " ${run##*/}"
done
