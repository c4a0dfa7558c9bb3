# Fluid fraction of EW18's liquid bed against height, and the correlation of the
# drag, Re_in = 11, from figures/23/23-liquid-profile.txt and -correlation.txt.
load "figures/style.gp"
set terminal svg size 760,360 dynamic font "sans,14" background "#ffffff"
set output "figures/23/23-profile.svg"
file = "figures/23/23-liquid-profile.txt"
lags = "figures/23/23-liquid-correlation.txt"
stats file using 1 nooutput
each = STATS_blocks / 3
set multiplot layout 1,2 margins 0.09,0.98,0.17,0.95 spacing 0.11
set key top left
set xlabel "height [{/:Italic d}]"
set ylabel "fluid fraction" offset 1,0
set xrange [0:15]
set yrange [0.5:1]
plot file index each - 1 using 1:2:3 with yerrorlines linetype 3 linewidth 1.2 \
         pointtype 7 pointsize 0.4 title "BC-0.6", \
     "" index 2 * each - 1 using 1:2:3 with yerrorlines linetype 1 linewidth 1.2 \
         pointtype 7 pointsize 0.4 title "GK-1", \
     "" index 3 * each - 1 using 1:2:3 with yerrorlines linetype 2 linewidth 1.2 \
         pointtype 7 pointsize 0.4 title "GK-1, random part"
set key top right
set xlabel "lag [{/:Italic d / u}_{in}]"
set ylabel "{/:Italic R} of the drag coefficient" offset 1,0
set yrange [-0.4:1]
plot lags index 2 * each - 1 using 1:2 with lines linetype 1 title "GK-1", \
     "" index 3 * each - 1 using 1:2 with lines linetype 2 title "GK-1, random part"
unset multiplot
