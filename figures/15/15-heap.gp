# Where the energy of cases/open-heap.cfg goes, from figures/15/15-heap.txt.
load "figures/style.gp"
set terminal svg size 900,400 dynamic font "sans,14" background "#ffffff"
set output "figures/15/15-heap.svg"
data = "figures/15/15-heap.txt"
set xlabel "time [s]"
set ylabel "energy [μJ]"
set xrange [0:0.7]
set key outside right reverse Left
set style fill solid 1.0 noborder
plot data index 0 using 1:($6+$7+$8+$9+$10+$11) with filledcurves y1=0 linecolor "#e0b84c" title "rolling", \
     "" index 0 using 1:($6+$7+$8+$9+$10) with filledcurves y1=0 linecolor "#b79ac8" title "sliding", \
     "" index 0 using 1:($6+$7+$8+$9) with filledcurves y1=0 linecolor "#8fbc8f" title "tangential dashpots", \
     "" index 0 using 1:($6+$7+$8) with filledcurves y1=0 linecolor "#e39a6b" title "normal dashpots", \
     "" index 0 using 1:($6+$7) with filledcurves y1=0 linecolor "#4a90c2" title "moving, springs", \
     "" index 0 using 1:5 with lines linecolor "black" linewidth 2 title "gains"
