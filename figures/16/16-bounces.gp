# Tops of bounces, from figures/16/16-bounces.txt, and velocity in an upflow.
load "figures/style.gp"
set output "figures/16/16-bounces.svg"
set multiplot layout 1,2
set title "DEM02: tops of bounces, e = 0.9"
set xlabel "bounce"
set ylabel "height of the centre [m]"
set xrange [-0.3:5.3]
plot "figures/16/16-bounces.txt" index 0 using 1:3 with lines linecolor "#999999" title "hard sphere", \
     "" index 0 using 1:2 with points pointtype 4 linecolor "#c2571a" title "k = 5e4 N/m", \
     "" index 1 using 1:2 with points pointtype 6 linecolor "#3d7a3d" title "5e5", \
     "" index 2 using 1:2 with points pointtype 2 linecolor "#0b5a8a" title "5e6"
set title "DEM06: a fall against a stream"
set xlabel "time [s]"
set ylabel "velocity [m/s]"
set xrange [0:0.35]
set yrange [-0.065:0]
plot "< grep -v '^t' figures/data/mfix_dem06_velocity.csv | tr , ' '" using 1:2 with points pointtype 6 linecolor "#c2571a" title "reference of MFiX", \
     "figures/16/16-upflow.txt" using 1:2 with linespoints linetype 1 pointtype 7 title "Winnow"
unset multiplot
