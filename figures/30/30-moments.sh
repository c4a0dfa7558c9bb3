#!/bin/sh
# XS11 Fig. 10: the grains of cases/seepage.cfg at rest and after 0.6 and 4.1 s, in three
# classes of size. Springs of 5 N/m, for a run of five minutes; a run that is there is not
# done again, and one that was stopped goes on.
#
#   sh figures/30/30-moments.sh
#
# Prints Fig. 9 and the heights at these times, too.
. "$(dirname "$0")/../here.sh"
dir=out/30-moments
resume=
! ls $dir/checkpoint* >/dev/null 2>&1 || resume=--resume
# shellcheck disable=SC2086 # no word, or one
grep -qs '"exit_reason": "done"' $dir/summary.json ||
    winnow run cases/seepage.cfg -o $dir -j 1 --quiet $resume \
        -s particles.grains.stiffness=5 -s particles.step=1.6e-6 \
        -s particles.expected_overlap=0.15 -s output.picture=false
/usr/bin/python3 figures/30/30-classes.py circles $dir >$dir/circles.txt
gnuplot figures/30/30-moments.gp
# XS11 Fig. 9: the share of the mass of smaller grains.
awk 'NF < 4 { exit }
    { m = $3 ^ 3; all += m; for (d = 0.83; d < 2.6; d += 0.42) if (2 * $3 < d) below[d] += m }
    END { for (d = 0.83; d < 2.6; d += 0.42) printf "%.2f mm %.3f\n", d, below[d] / all }' $dir/circles.txt
/usr/bin/python3 figures/30/30-classes.py heights $dir | grep -E '^#|^0[.][06] |^4.1 '
