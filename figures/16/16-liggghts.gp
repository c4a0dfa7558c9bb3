# Four spheres in Winnow and in LIGGGHTS, seen from above, from
# figures/16/16-liggghts.txt.
load "figures/style.gp"
set output "figures/16/16-liggghts.svg"
set xlabel "x [mm]"
set ylabel "z [mm]"
set xrange [25:145]
set yrange [30:65]
set key left bottom
plot for [i=0:3] "figures/16/16-liggghts.txt" index i using (1e3*$2):(1e3*$3) with lines linetype i+1 title sprintf("sphere %d", i+1), \
     for [i=0:3] "" index i using (1e3*$5):(1e3*$6) with points pointtype 6 linecolor "#333333" title (i == 0 ? "LIGGGHTS" : "")
