# Iterations against the number of cells, and residuals, from figures/07/07-scale.txt
# and figures/07/07-history.txt.
load "figures/style.gp"
set output "figures/07/07-solvers.svg"
set multiplot layout 1,2
set logscale xy
set xlabel "cells"
set ylabel "iterations to 1e-8"
set format x "10^{%T}"
set xrange [700:1.4e6]
set yrange [4:2000]
unset key
set label 1 "diagonal" at 1.5e3, 320 textcolor linetype 2
set label 2 "multigrid" at 3e3, 16 textcolor linetype 1
set label 3 "cells^{1/3}" at 1.2e5, 190 textcolor "#555555"
scale = "< sed -n '/^## scale/,/^## accuracy/p' figures/07/07-scale.txt"
plot scale using 1:2 with linespoints linetype 2 pointtype 7 pointsize 0.6 \
         notitle, \
     scale using 1:3 with linespoints linetype 1 pointtype 7 pointsize 0.6 \
         notitle, \
     7.1*x**(1.0/3) linecolor "#777777" linewidth 1 dashtype 2 \
         notitle

unset logscale x
set format x "%g"
set xlabel "iterations"
set ylabel "residual"
set format y "10^{%T}"
set xrange [0:300]
set xtics 100
set yrange [1e-11:2]
unset label 3
set label 1 at 120, 3e-2
set label 2 at 22, 1e-7
plot "figures/07/07-history.txt" using 1:2 with lines linetype 2 \
         notitle, \
     "" using (column(0)<14?$1:1/0):3 with linespoints linetype 1 \
         pointtype 7 pointsize 0.5 notitle
