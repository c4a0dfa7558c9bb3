# Cohesion over weight against the diameter, from figures/17/17-forces.txt.
load "figures/style.gp"
set encoding utf8
set output "figures/17/17-forces.svg"
set logscale xy
set format "10^{%L}"
set xlabel "diameter [m]"
set ylabel "force over weight"
set xrange [1e-6:1e-2]
set yrange [1e-4:1e8]
set arrow from 1e-6,1 to 1e-2,1 nohead linecolor "#999999" dashtype 3
plot "figures/17/17-forces.txt" using 1:3 with linespoints linetype 1 pointtype 7 title "capillary, water", \
     "" using 1:2 with linespoints linetype 2 pointtype 5 title "van der Waals, A = 6.5e-20 J, smooth", \
     "" using 1:4 with linespoints linetype 3 pointtype 9 title "electrostatic, 26 µC/m²"
