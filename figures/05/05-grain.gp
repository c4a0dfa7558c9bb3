# What a face lacks while a grain passes it, from figures/05/05-grain.txt.
load "figures/style.gp"
set output "figures/05/05-grain.svg"
set multiplot layout 1,2
data = "figures/05/05-grain.txt"
set xlabel "time [ms]"
set xrange [0:96]
set xtics 24
set style data lines
set key samplen 2 top right reverse Left width -6

set ylabel "missing superficial velocity [m/s]"
set yrange [0:1]
plot data using ($1*1e3):3 linetype 2 notitle, \
     "" using ($1*1e3):2 linetype 1 notitle, \
     "" using ($1*1e3):4 linetype 3 notitle

unset ylabel
set yrange [0:0.01]
set ytics 0.002
plot data using ($1*1e3):3 linetype 2 title "void-rate", \
     "" using ($1*1e3):2 linetype 1 title "mixture", \
     "" using ($1*1e3):4 linetype 3 title "void-rate, spread"
