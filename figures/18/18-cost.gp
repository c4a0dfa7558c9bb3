# What a particle costs in a step, from figures/18/18-cost.txt.
load "figures/style.gp"
set output "figures/18/18-cost.svg"
unset key
set logscale x
set xlabel "spheres"
set ylabel "ns a particle and step"
set xrange [5e3:2e6]
set format x "10^{%T}"
set yrange [0:110]
plot "figures/18/18-cost.txt" using 1:2 with linespoints linetype 1 pointtype 7
