# What refines EW18's liquid bed, Re_in = 6: cells a diameter (their Fig. B.1), and
# the width of the kernel (Fig. B.2), from figures/23/23-kernels.txt.
load "figures/style.gp"
set terminal svg size 760,360 dynamic font "sans,14" background "#ffffff"
set output "figures/23/23-kernels.svg"
table = "figures/23/23-kernels.txt"
set multiplot layout 1,2 margins 0.09,0.98,0.17,0.92 spacing 0.11
set yrange [0:0.6]
set ylabel "root of granular temperature [{/:Italic u}_{in}]" offset 1,0
set xlabel "cells in a diameter"
set xrange [0.3:3.2]
set xtics 0.5
set key bottom right
plot "<awk '$2 == 1' " . table using 1:3:4 with yerrorlines linetype 1 pointtype 7 title "along the flow", \
     "<awk '$2 == 1' " . table using 1:5:6 with yerrorlines linetype 2 pointtype 9 title "across it"
unset ylabel
set xlabel "δ_{0.5} [{/:Italic d}]"
set xrange [0.8:2.2]
set key top right
plot "<awk '$1 == 1' " . table using 2:3:4 with yerrorlines linetype 1 pointtype 7 title "along, one cell a diameter", \
     "<awk '$1 == 1' " . table using 2:5:6 with yerrorlines linetype 2 pointtype 9 title "across", \
     "<awk '$1 == 2' " . table using 2:3:4 with yerrorlines linetype 3 pointtype 7 title "along, two cells", \
     "<awk '$1 == 2' " . table using 2:5:6 with yerrorlines linetype 4 pointtype 9 title "across"
unset multiplot
