# The velocity of four falling spheres against their gap to the floor, from
# figures/24/24-courses.txt.
load "figures/style.gp"
set output "figures/24/24-falls.svg"
set xrange [125:0]
set yrange [0:0.135]
set xlabel "gap to the floor [mm]"
set ylabel "velocity downward [m/s]"
set key right bottom
plot "figures/24/24-courses.txt" index 3 using (1000 * $2):(-$3) with lines linetype 4 title "E4, Re 32", \
     "" index 2 using (1000 * $2):(-$3) with lines linetype 3 title "E3, Re 12", \
     "" index 1 using (1000 * $2):(-$3) with lines linetype 2 title "E2, Re 4.1", \
     "" index 0 using (1000 * $2):(-$3) with lines linetype 1 title "E1, Re 1.5"
