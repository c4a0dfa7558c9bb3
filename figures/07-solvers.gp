# Iterations against the number of cells, and residuals, from figures/07-scale.txt
# and figures/07-history.txt.
load "figures/style.gp"
set output "figures/07-solvers.svg"
set multiplot layout 1,2
set logscale xy
set xlabel "cells"
set ylabel "iterations to 1e-8"
set format x "10^{%T}"
set xrange [700:1.4e6]
set yrange [4:2000]
set key top left Left reverse samplen 2
scale = "< sed -n '/^## scale/,/^## accuracy/p' figures/07-scale.txt"
plot scale using 1:2 with linespoints linetype 2 pointtype 7 pointsize 0.6 \
         title "diagonal", \
     scale using 1:3 with linespoints linetype 1 pointtype 7 pointsize 0.6 \
         title "multigrid", \
     7.1*x**(1.0/3) linecolor "#777777" linewidth 1 dashtype 2 \
         title "as the cells along a side"

unset logscale x
set format x "%g"
set xlabel "iterations"
set ylabel "residual"
set format y "10^{%T}"
set xrange [0:120]
set yrange [1e-11:2]
set key top right
plot "figures/07-history.txt" using 1:2 with lines linetype 2 \
         title "diagonal", \
     "" using (column(0)<13?$1:1/0):3 with linespoints linetype 1 \
         pointtype 7 pointsize 0.5 title "multigrid"
