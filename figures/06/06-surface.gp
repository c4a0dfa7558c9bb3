# Velocity and pressure at the surface of a bed, from figures/06/06-surface.txt.
load "figures/style.gp"
set output "figures/06/06-surface.svg"
set multiplot layout 1,2
data = "figures/06/06-surface.txt"
surface = 24.0 # mm
slope = 5102.04e-3 # Pa/mm, K U / eps^2
rise = 1.342 # Pa
set arrow from surface, graph 0 to surface, graph 1 nohead \
    linecolor "#999999" dashtype 2
set xlabel "height [mm]"
set style data linespoints
set pointsize 0.5
set key samplen 2 reverse Left

set xrange [0:48]
set xtics 12
set yrange [0.5:2]
set ylabel "velocity over the exact one"
set label "bed" at 12, 0.6 center textcolor "#555555"
set label "clear" at 36, 0.6 center textcolor "#555555"
set key top left
plot data using ($1*1e3):3 linetype 2 pointtype 7 title "linear", \
     "" using ($1*1e3):2 linetype 1 pointtype 7 title "Winnow"

set xrange [18:30]
set xtics 3
set yrange [-4:16]
set ytics 4
set ylabel "pressure [Pa]"
unset label
set key top right
plot data using ($1*1e3):5 with points linetype 2 pointtype 7 title "linear", \
     "" using ($1*1e3):4 with points linetype 1 pointtype 7 title "Winnow", \
     [18:24] slope*(surface-x)-rise linecolor "#777777" linewidth 1 \
         title "exact", \
     [24:30] 0 linecolor "#777777" linewidth 1 notitle
