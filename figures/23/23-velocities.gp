# EW18's liquid bed at four inlet velocities: fluid fraction against height (their
# Fig. 15), and roots of the granular temperatures with errors (Figs. 16, 17), from
# figures/23/23-liquid-profile.txt and 23-liquid.txt.
load "figures/style.gp"
set terminal svg size 960,380 dynamic font "sans,14" background "#ffffff"
set output "figures/23/23-velocities.svg"
file = "figures/23/23-liquid-profile.txt"
table = "figures/23/23-liquid.txt"
stats file using 1 nooutput
each = STATS_blocks / 3
of(way) = "<grep ' " . way . " ' " . table
re = "4 6 8 11"
set multiplot layout 1,3 margins 0.07,0.98,0.17,0.88 spacing 0.09
set key top left samplen 2
set xlabel "height [{/:Italic d}]"
set ylabel "fluid fraction" offset 1,0
set xrange [0:15]
set yrange [0.5:1]
set title "GK-1 (points: random part)"
plot for [i=1:each] file index each + i - 1 using 1:2 with lines linetype i linewidth 1.5 \
         dashtype i title "Re " . word(re, i), \
     for [i=1:each] "" index 2 * each + i - 1 using 1:2 with points linetype i \
         pointtype 5 + i pointsize 0.5 notitle
set xlabel "{/:Italic Re}_{in}"
set ylabel "root of granular temperature [{/:Italic u}_{in}]" offset 1,0
set xrange [3:12]
set yrange [0:0.6]
set title "along the flow"
unset key
plot of("cube") using 1:3:4 with yerrorlines linetype 3 pointtype 4 title "BC-0.6", \
     of("gauss") using 1:3:4 with yerrorlines linetype 1 pointtype 7 title "GK-1", \
     of("random") using 1:3:4 with yerrorlines linetype 2 pointtype 9 title "GK-1, random part"
unset ylabel
set yrange [0:0.35]
set title "across it"
set key top left
plot of("cube") using 1:5:6 with yerrorlines linetype 3 pointtype 4 title "BC-0.6", \
     of("gauss") using 1:5:6 with yerrorlines linetype 1 pointtype 7 title "GK-1", \
     of("random") using 1:5:6 with yerrorlines linetype 2 pointtype 9 title "GK-1, random part"
unset multiplot
