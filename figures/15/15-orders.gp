# Orders and energy of the integrators, from figures/15/15-orders.txt.
load "figures/style.gp"
set terminal svg size 900,380
set output "figures/15/15-orders.svg"
data = "figures/15/15-orders.txt"
set multiplot layout 1,2
set logscale xy
set format y "10^{%T}"
set xlabel "steps in a contact [-]"
set ylabel "error of the overlap [-]"
set xrange [8:800]
set key bottom left
plot data index 0 using 1:2 with linespoints linetype 1 pointtype 7 pointsize 0.5 title "velocity Verlet", \
     "" index 0 using 1:3 with linespoints linetype 2 dashtype 1 pointtype 5 pointsize 0.5 title "symplectic Euler", \
     "" index 0 using 1:4 with linespoints linetype 3 dashtype 1 pointtype 9 pointsize 0.6 title "Heun", \
     "" index 1 using 1:2 with lines linetype 1 dashtype 2 title "e = 0.5", \
     "" index 1 using 1:3 with lines linetype 2 dashtype 2 notitle, \
     "" index 1 using 1:4 with lines linetype 3 dashtype 2 notitle
unset logscale
set format y "%g"
set xlabel "periods of 25 steps [-]"
set ylabel "energy over its start [-]"
set xrange [0:200]
set yrange [0:10]
set key top left
plot data index 2 using 1:2 with lines linetype 1 title "velocity Verlet", \
     "" index 2 using 1:3 with lines linetype 2 title "symplectic Euler", \
     "" index 2 using 1:4 with lines linetype 3 title "Heun"
