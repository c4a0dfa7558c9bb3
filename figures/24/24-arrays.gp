# The error of the drag of three arrays against the cells in a diameter, from
# figures/24/24-arrays.txt.
load "figures/style.gp"
set output "figures/24/24-arrays.svg"
set logscale xy
set xrange [7:28]
set yrange [0.1:20]
set xtics (8, 12, 16, 24)
set xlabel "cells in a diameter"
set ylabel "error of the drag [%]"
plot 500 / x ** 2 with lines linecolor "#999999" dashtype 3 title "second order", \
     "figures/24/24-arrays.txt" index 2 using 3:(abs($6)) with linespoints linetype 3 pointtype 9 title "solid fraction 0.45", \
     "" index 1 using 3:(abs($6)) with linespoints linetype 2 pointtype 5 title "0.216", \
     "" index 0 using 3:(abs($6)) with linespoints linetype 1 pointtype 7 title "0.064"
