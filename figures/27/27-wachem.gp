# The pressure in van Wachem's bed, 45 mm above the bottom, measured and computed; each
# less its mean, the measured one moved to begin at 0.
load "figures/style.gp"
set terminal svg size 720,300 dynamic font "sans,13" background "#ffffff"
set output "figures/27/27-wachem.svg"
set xlabel "time [s]"
set ylabel "pressure less its mean [Pa]"
set key top right horizontal
set yrange [-300:450]
set xrange [0:3]
stats "< awk '!/^#/ && $1 > 1' figures/27/27-wachem.txt" using 2 nooutput
plot "figures/data/van-wachem-2001.txt" using ($1 - 3.01):2 with lines linetype 2 title "measured", \
     "< awk '!/^#/ && $1 > 1' figures/27/27-wachem.txt" using ($1 - 1):($2 - STATS_mean) \
         with lines linetype 1 title "computed, from 1 s on"
