# XS11 Case 4: mean heights of three classes of grains, figures/30/30-seepage.txt.
load "figures/style.gp"
set output "figures/30/30-seepage.svg"
set xlabel "t [s]"
set ylabel "mean height [mm]"
set key top left
plot "figures/30/30-seepage.txt" using 1:2 with linespoints pointtype 7 pointsize 0.5 title "d < 0.83 mm", \
     "" using 1:3 with linespoints pointtype 7 pointsize 0.5 title "0.83 to 1.67 mm", \
     "" using 1:4 with linespoints pointtype 7 pointsize 0.5 title "larger"
