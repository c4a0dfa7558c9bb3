# Four spheres ten grains wide in a fluidized bed, from figures/24/24-ten.txt.
load "figures/style.gp"
set output "figures/24/24-ten.svg"
table = "figures/24/24-ten.txt"
set xlabel "time [s]"
set ylabel "height of the centre [mm]"
set yrange [0:24]
set key outside right top
plot table using 1:6 with filledcurves y1=0 linecolor "#e8e0d0" title "twice the grains' mean", \
     table using 1:2 with lines linetype 1 title "1100 kg/m^3", \
     table using 1:3 with lines linetype 3 title "1700 kg/m^3", \
     table using 1:4 with lines linetype 4 title "1850 kg/m^3", \
     table using 1:5 with lines linetype 2 title "2300 kg/m^3"
