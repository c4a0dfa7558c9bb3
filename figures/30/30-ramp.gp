# XS11 Case 1: pressure drop over the ramp of the inlet, figures/30/30-ramp-15x75.txt.
load "figures/style.gp"
set output "figures/30/30-ramp.svg"
set xlabel "U [m/s]"
set ylabel "pressure drop between the sensors [Pa]"
set xrange [0:1.55]
set yrange [0:320]
set key bottom right
plot "figures/30/30-ramp-15x75.txt" using ($1<15?$2:1/0):3 with lines linetype 1 title "up", \
     "" using ($1>15?$2:1/0):3 with lines linetype 2 title "down", \
     "figures/30/30-ramp-stiff.txt" using ($1<15?$2:1/0):3 with lines linetype 1 linewidth 0.8 linecolor "#7fb0d0" title "up, springs ten times as stiff", \
     "figures/data/xiao-sun-2011-case1.txt" using ($1<15?$2:1/0):3 with points pointtype 6 linecolor "#0b5a8a" title "XS11 Fig. 4, up", \
     "" using ($1>15?$2:1/0):3 with points pointtype 4 linecolor "#c2571a" title "down", \
     249.4 linecolor "#777777" linewidth 1 dashtype 2 title "weight of the bed"
