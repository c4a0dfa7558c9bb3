#!/bin/sh
# XS11 Fig. 10(a) and (b): the grains of cases/seepage.cfg at rest and after 0.6 s, in three
# classes of size. Springs of 5 N/m, for a run of a minute; a run that is there is not done
# again, and one that was stopped goes on.
#
#   sh figures/30/30-moments.sh
. "$(dirname "$0")/../here.sh"
dir=out/30-moments
resume=
! ls $dir/checkpoint* >/dev/null 2>&1 || resume=--resume
# shellcheck disable=SC2086 # no word, or one
grep -qs '"exit_reason": "done"' $dir/summary.json ||
    winnow run cases/seepage.cfg -o $dir -j 1 --quiet $resume -s exchange.treatment=explicit \
        -s particles.grains.stiffness=5 -s particles.step=1.6e-6 \
        -s output.end=0.6 -s output.every=0.6 -s output.picture=false
/usr/bin/python3 figures/30/30-classes.py circles $dir >$dir/circles.txt
gnuplot figures/30/30-moments.gp
