#!/bin/sh
# The beds at the end of the runs of cases/studies/sx15-bandwidth.cfg, each bandwidth with
# its two seeds: the spheres with the line eps_s = 0.28, as in SX15 Fig. 8.
#
#   sh figures/25/25-moments.sh
. "$(dirname "$0")/../here.sh"
out=out/study-sx15-bandwidth
python=/usr/bin/python3 # Debian's own, which python3-vtk9 belongs to
winnow study cases/studies/sx15-bandwidth.cfg -o $out --quiet >/dev/null
for seed in 0 1; do
    : >$out/points-$seed.txt
    : >$out/field-$seed.txt
    for b in 9.6e-3 7.2e-3 4.8e-3 3.6e-3 2.4e-3; do
        $python figures/26/26-snapshots.py "$out/runs/bandwidth=$b+seed-$seed" 1.99 \
            $out/points.txt $out/field.txt
        cat $out/points.txt >>$out/points-$seed.txt
        cat $out/field.txt >>$out/field-$seed.txt
    done
done
gnuplot figures/25/25-moments.gp
