# Agitation of EW18's liquid bed in time, Re_in = 11, from
# figures/23/23-liquid-series.txt: blocks by way (cube, gauss, random), and in each
# by the Reynolds numbers, of which the last is meant.
load "figures/style.gp"
set terminal svg size 760,360 dynamic font "sans,14" background "#ffffff"
set output "figures/23/23-liquid.svg"
file = "figures/23/23-liquid-series.txt"
stats file using 1 nooutput
each = STATS_blocks / 3
set multiplot layout 1,2 margins 0.09,0.98,0.17,0.88 spacing 0.11
set xrange [30:150]
set xlabel "time [{/:Italic d / u}_{in}]"
set yrange [0:0.8]
set ylabel "root of granular temperature [{/:Italic u}_{in}]" offset 1,0
set title "along the flow"
unset key
plot file index each - 1 using 1:(sqrt($2)) with lines linetype 3 linewidth 1.2, \
     "" index 2 * each - 1 using 1:(sqrt($2)) with lines linetype 1 linewidth 1.2, \
     "" index 3 * each - 1 using 1:(sqrt($2)) with lines linetype 2 linewidth 1.2
set yrange [0:0.5]
unset ylabel
set title "across it"
set key top right
plot file index each - 1 using 1:(sqrt($3)) with lines linetype 3 linewidth 1.2 \
         title "BC-0.6", \
     "" index 2 * each - 1 using 1:(sqrt($3)) with lines linetype 1 linewidth 1.2 \
         title "GK-1", \
     "" index 3 * each - 1 using 1:(sqrt($3)) with lines linetype 2 linewidth 1.2 \
         title "GK-1, random part"
unset multiplot
