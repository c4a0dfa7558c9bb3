# Error against time, from figures/26-slot.txt: each line is a way, from cells of
# 6 d to 0.5 d.
load "figures/style.gp"
set terminal svg size 860,470 dynamic font "sans,13" background "#ffffff"
set output "figures/26-work.svg"
set logscale xy
set xlabel "time to average one field [ms]"
set ylabel "distance from the exact kernel field, over its sum"
set yrange [2e-5:3]
set xrange [0.02:700]
set format y "10^{%L}"
set key outside right top
# a name has spaces around it
f(name) = "< grep ' " . name . " ' figures/26-slot.txt"
plot for [w in "pcm dpvm two-grid-3d bell-2.5-cells images exponential crank-nicolson-1 crank-nicolson-3 implicit-euler-1 implicit-euler-3 sdirk2-2 sdirk2-4"] \
     f(w) using 7:3 with linespoints pointsize 0.6 linewidth 1.6 title w
