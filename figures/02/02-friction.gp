# Slip after an impact against slip before it, from figures/02/02-friction.txt.
load "figures/style.gp"
set output "figures/02/02-friction.svg"
data = "figures/02/02-friction.txt"
set xlabel "slip before [m/s]"
set ylabel "slip after [m/s]"
set key top left
set xzeroaxis linetype 1 linecolor "#555555" linewidth 1
set yrange [-0.45:1.2]
plot data using 1:2 with lines title "linear", \
     data using 1:3 with lines title "Hertz and Mindlin", \
     data using 1:($4 > -0.4 ? $4 : 1/0) with lines dashtype 2 \
         title "sliding throughout", \
     -0.7 * x with lines linetype 4 dashtype 3 title "0.7 of it comes back"
