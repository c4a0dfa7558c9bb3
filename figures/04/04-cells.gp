# A mesh from files seen from above, and which cell owns a point.
load "figures/style.gp"
set terminal svg size 560,560 dynamic font "sans,14" background "#ffffff"
set output "figures/04/04-cells.svg"
data = "figures/04/04-cells.txt"
unset border
unset grid
unset key
unset colorbox
set size ratio -1
set xrange [-20:20]
set yrange [-20:20]
set xlabel "x [mm]"
set ylabel "z [mm]"
set palette defined (0 "#0b5a8a", 1 "#c2571a", 2 "#3d7a3d", 3 "#7a4a9a")
plot data index 1 using 1:2:(int($3) * 29 % 17) with points \
         pointtype 7 pointsize 0.45 palette, \
     data index 0 using 1:2 with lines linetype 1 linecolor "#333333" linewidth 1.2
