# The scenes of the chapter on further forces with and without what they show, from
# figures/22/22-forces.txt and figures/22/22-scenes.txt.
load "figures/style.gp"
set terminal svg size 900,760 dynamic font "sans,13" background "#ffffff"
set output "figures/22/22-forces.svg"
set multiplot layout 2,2
part(p, f) = sprintf("< awk '/^## /{p = ($2 == \"%s\")} p && /^ *[0-9-]/' figures/22/22-%s.txt", p, f)
h = part("history", "forces")
set title "a light bead in oil: Basset"
set xlabel "t / T"
set ylabel "v / v_t"
set yrange [0:1.05]
set key bottom right
plot h using 1:2 with lines linetype 2 title "without", \
     h using 1:3 with points pointtype 7 pointsize 0.6 linecolor "#0b5a8a" title "with", \
     h using 1:4 with lines linecolor "#000000" linewidth 1 title "exact"
s = part("shear", "scenes")
set title "a grain in a shear: Saffman"
set xlabel "t [s]"
set ylabel "x [mm]"
set yrange [0.9:2]
set key top left
plot s using 1:2 with lines linetype 1 title "with", \
     s using 1:3 with lines linetype 2 title "without"
f = part("spin", "forces")
set title "a grain with backspin: Magnus"
set xlabel "x [mm]"
set ylabel "y [mm]"
set yrange [0:45]
set key bottom center
plot f using 1:2 with lines linetype 1 title "lift and torque", \
     f using 3:4 with lines linetype 4 dashtype 2 title "lift", \
     f using 5:6 with lines linetype 2 title "neither"
r = part("rebound", "scenes")
set title "a steel ball on the floor: lubrication"
set xlabel "St"
set ylabel "rebound / impact"
set logscale x
set yrange [0:1.05]
set key at 1000, 0.52 right top
plot r using 1:2 with linespoints pointtype 7 pointsize 0.5 linetype 2 title "without", \
     r using 1:3 with linespoints pointtype 7 pointsize 0.5 linetype 1 title "with", \
     r using 1:4 with linespoints pointtype 7 pointsize 0.5 linetype 4 title "and history", \
     0.97 * exp(-35 / x) with lines linecolor "#000000" linewidth 1 title "measured, fit"
unset multiplot
