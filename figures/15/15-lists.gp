# Cost of the two ways to find pairs, from figures/15/15-lists.txt.
load "figures/style.gp"
set terminal svg size 760,350 dynamic font "sans,13" background "#ffffff"
set output "figures/15/15-lists.svg"
data = "figures/15/15-lists.txt"
set multiplot layout 1,2
set xlabel "skin over diameter [-]"
set ylabel "processor time a particle and step [μs]"
set logscale y
set yrange [0.01:2]
set key bottom right
plot data index 0 using 1:2 with linespoints linetype 1 pointtype 7 pointsize 0.5 title "list", \
     "" index 0 using 1:3 with lines linetype 2 dashtype 2 title "link cells"
set logscale x
set xlabel "particles [-]"
set format x "10^{%T}"
unset ylabel
plot data index 1 using 1:2 with linespoints linetype 1 pointtype 7 pointsize 0.5 title "list, skin d/6", \
     "" index 1 using 1:3 with linespoints linetype 2 dashtype 2 pointtype 4 pointsize 0.5 title "link cells"
