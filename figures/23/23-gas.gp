# EW18's gas bed (their Figs. 18 to 20), from figures/23/23-gas-series.txt and
# 23-gas-profile.txt, whose blocks are the ways cube, gauss, random, di-felice,
# gauss-2, random-2.
load "figures/style.gp"
set terminal svg size 960,720 dynamic font "sans,14" background "#ffffff"
set output "figures/23/23-gas.svg"
series = "figures/23/23-gas-series.txt"
profile = "figures/23/23-gas-profile.txt"
ways = "BC-0.6 GK-1 'GK-1, random' 'GK-1, di-felice' GK-2 'GK-2, random'"
set multiplot layout 2,2 margins 0.085,0.98,0.09,0.97 spacing 0.09,0.11
set xlabel "time [{/:Italic d / u}_{in}]"
set xrange [0:120]
set ylabel "height of the bed [{/:Italic d}]" offset 1,0
set yrange [18:28]
unset key
colour = "3 1 2 4 1 2"
style(i) = i < 4 ? 1 : 2
plot for [i=0:5] series index i using 1:4 with lines linetype word(colour, i + 1) + 0 \
         dashtype style(i) linewidth 1.5
set ylabel "root of axial granular temperature [{/:Italic u}_{in}]" offset 1,0
set yrange [0:1]
plot for [i=0:5] series index i using 1:(sqrt($2)) with lines \
         linetype word(colour, i + 1) + 0 dashtype style(i) linewidth 1
set ylabel "root of the transverse one [{/:Italic u}_{in}]" offset 1,0
set yrange [0:0.3]
plot for [i=0:5] series index i using 1:(sqrt($3)) with lines \
         linetype word(colour, i + 1) + 0 dashtype style(i) linewidth 1
set xlabel "height [{/:Italic d}]"
set ylabel "fluid fraction" offset 1,0
set xrange [0:50]
set yrange [0.4:1]
set key bottom right samplen 2 font "sans,11"
plot for [i=0:5] profile index i using 1:2 with lines linetype word(colour, i + 1) + 0 \
         dashtype style(i) linewidth 1.5 title word(ways, i + 1)
unset multiplot
