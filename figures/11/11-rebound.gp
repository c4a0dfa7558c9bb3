# The error of a rebound against the steps in it, from figures/11/11-rebound.txt.
load "figures/style.gp"
set output "figures/11/11-rebound.svg"
set logscale xy
set format y "10^{%L}"
set xlabel "steps in the contact"
set ylabel "largest miss of the speed, over that of the impact"
set xrange [1.6:260]
set yrange [1e-6:3]
set arrow from 25,1e-6 to 25,3 nohead linecolor "#999999" dashtype 3
set arrow from 15,1e-6 to 15,3 nohead linecolor "#999999" dashtype 3
plot "figures/11/11-rebound.txt" using 1:3 with linespoints linetype 2 dashtype 1 pointtype 7 title "e = 0.7", \
     "" using 1:2 with linespoints linetype 1 pointtype 5 title "e = 1", \
     0.4 / x with lines linecolor "#999999" dashtype 2 title "one over the steps"
