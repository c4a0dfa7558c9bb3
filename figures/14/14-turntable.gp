# The path of a sphere on a turntable, from figures/14/14-turntable.txt.
load "figures/style.gp"
set output "figures/14/14-turntable.svg"
set size ratio -1
set xlabel "x [m]"
set ylabel "z [m]"
set xrange [-0.2:0.5]
set yrange [-0.26:0.05]
set key below
set label 1 at 0.0,0.0 point pointtype 1 pointsize 1.5 linecolor "#555555"
set label 2 "axis of the table" at 0.008,0.012 textcolor "#555555"
set parametric
set trange [0:2*pi]
plot 0.2 + 0.116667 * sin(t), 0.116667 * (cos(t) - 1) with lines linetype 1 title "circle of radius 7v/(2 Omega)", \
     "figures/14/14-turntable.txt" using 1:2 every 4 with points linetype 2 pointtype 7 pointsize 0.6 title "computed, three rounds"
