# The sizes of XS11's Case 4, from figures/15/15-sizes.txt.
load "figures/style.gp"
set output "figures/15/15-sizes.svg"
data = "figures/15/15-sizes.txt"
set xlabel "diameter [mm]"
set ylabel "share that is smaller [-]"
set xrange [0:2.5]
set yrange [0:1]
set key top left
plot data using 1:2 with lines linetype 1 title "by number, exact", \
     "" using 1:4 every 2 with points linetype 1 pointtype 7 pointsize 0.5 title "2160 drawn", \
     "" using 1:3 with lines linetype 2 title "by mass, exact", \
     "" using 1:5 every 2 with points linetype 2 pointtype 7 pointsize 0.5 title "2160 drawn"
