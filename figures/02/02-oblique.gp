# Oblique impacts against the measurement, from figures/02/02-oblique.txt.
load "figures/style.gp"
set terminal svg size 720,640 dynamic font "sans,14" background "#ffffff"
set output "figures/02/02-oblique.svg"
data = "figures/02/02-oblique.txt"
measured = "figures/data/kharaz-2001.txt"
set multiplot layout 2,1
set key bottom right
set xrange [0:65]
set ylabel "angle of the rebound [deg]"
plot measured index 0 using 1:2 with points pointtype 7 linecolor "#333333" \
         title "measured [Kharaz01]", \
     data using 1:2 with lines linetype 1 title "linear", \
     data using 1:3 with lines linetype 2 title "Hertz and Mindlin"
set xlabel "angle of the impact, from the normal [deg]"
set ylabel "spin [rad/s]"
unset key
plot measured index 1 using 1:2 with points pointtype 7 linecolor "#333333", \
     data using 1:4 with lines linetype 1, \
     data using 1:5 with lines linetype 2
unset multiplot
