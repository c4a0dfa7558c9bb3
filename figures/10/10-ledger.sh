#!/bin/sh
# Data of figures/10/10-ledger.svg: the fluid's unpaid impulse, step by step, in the
# closed box. From the top folder: sh figures/10/10-ledger.sh
. "$(dirname "$0")/../here.sh"
run=$work
winnow run cases/closed-box.cfg -o "$run" -j 1 --quiet >"$run/said"
awk -F, -v sums=figures/10/10-ledger-sums.txt 'BEGIN { print "# cases/closed-box.cfg, momenta over that at the start"
        print "# time [s], sum of the unpaid impulse [-], |change of the total| [-]" }
    NR == 1 { for (i = 1; i <= NF; i++) {
        if ($i ~ /^momentum_x/) m = i
        if ($i ~ /^unpaid_impulse_x/) o = i } }
    NR == 2 { first = $m }
    NR > 2 { sum += $o; d = ($m - first) / first; if (d < 0) d = -d
        if (d > worst) worst = d
        printf "%.4f %.6e %.1e\n", $1, sum / first, d }
    END { printf "unpaid = %.4f\ndrift = %.1e\n", sum / first, worst >sums }' \
    "$run/history.csv" >figures/10/10-ledger.txt
gnuplot figures/10/10-ledger.gp
