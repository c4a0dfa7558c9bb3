# Error of the spread, in two ways, from figures/12/12-mean.txt.
load "figures/style.gp"
set output "figures/12/12-mean.svg"
set logscale xy
set format "10^{%T}"
set xlabel "mean over spread"
set ylabel "relative error of the spread"
set yrange [1e-16:30]
unset key
set label 1 "mean of squares less\nsquare of mean" at 3e3, 1e-4 right textcolor linetype 2
set label 2 "mean\\_add" at 3e7, 4e-13 textcolor linetype 1
set label 3 "10^{-16} (mean / spread)^2" at 3e5, 2e-8 textcolor "#555555"
plot "figures/12/12-mean.txt" using 1:2 with linespoints linetype 2 pointtype 7 pointsize 0.6, \
     "" using 1:3 with linespoints linetype 1 pointtype 7 pointsize 0.6, \
     1e-16*x**2 linecolor "#777777" linewidth 1 dashtype 2
