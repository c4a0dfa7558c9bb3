# The drag of an array by three methods against nu dt / h^2, from
# figures/24/24-methods.txt.
load "figures/style.gp"
set output "figures/24/24-methods.svg"
set logscale x
set xrange [0.02:15]
set yrange [0:1.3]
set key left bottom
set xlabel "nu dt / h^2"
set ylabel "drag over that of Zick and Homsy"
plot 1 with lines linecolor "#999999" dashtype 3 notitle, \
     "figures/24/24-methods.txt" using 1:4 with linespoints linetype 3 pointtype 9 title "PISO-IB", \
     "" using 1:2 with linespoints linetype 1 pointtype 7 title "friction by distance", \
     "" using 1:3 with linespoints linetype 2 pointtype 5 title "fictitious domain"
