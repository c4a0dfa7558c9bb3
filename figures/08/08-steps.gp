# One full cell diffused by each scheme, from figures/08/08-cell.txt; error against
# work, from figures/08/08-steps.txt and, dashed, for the bed of 08-bed.txt.
load "figures/style.gp"
set terminal svg size 860,400 dynamic font "sans,13" background "#ffffff"
set output "figures/08/08-steps.svg"
stats "figures/08/08-cell.txt" using 5 name "cn" nooutput
set multiplot
set tmargin at screen 0.97
set bmargin at screen 0.15
set lmargin at screen 0.065
set rmargin at screen 0.535
set xlabel "distance from the full cell, in cells"
set ylabel "1000 {/:Italic ε_s}"
set xrange [-7:7]
set yrange [-1:9]
set key top right samplen 1 spacing 1.1 font "sans,10"
set label sprintf("up to %.1f,", cn_max) at -6.8,8.4 textcolor "#c2571a"
set label sprintf("and %.1f", cn_min) at -6.8,7.8 textcolor "#c2571a"
set label "in the middle" at -6.8,7.2 textcolor "#c2571a"
plot "figures/08/08-cell.txt" using 1:2 with points pointtype 7 \
         pointsize 0.7 linecolor "#333333" title "Gaussian", \
     "" using 1:3 with lines linetype 1 title "exponential", \
     "" using 1:4 with lines linetype 3 title "implicit Euler, 3", \
     "" using 1:5 with lines linetype 2 title "Crank-Nicolson, 3", \
     "" using 1:6 with lines linetype 4 title "Crank-Nicolson, 6"
unset label
set lmargin at screen 0.635
set rmargin at screen 0.985
set xlabel "products with the matrix"
set ylabel "error in time, over the amount"
set logscale xy
set xrange [20:300]
set yrange [3e-7:1e2]
set xtics (20, 50, 100, 200)
set ytics 100
set format y "10^{%L}"
one = "figures/08/08-steps.txt"
bed = "figures/08/08-bed.txt"
plot one index 0 using 2:3 with points pointtype 7 pointsize 1 \
         linecolor "#0b5a8a" title "exponential, by its series", \
     one index 2 using 2:3 with linespoints linetype 3 pointtype 7 \
         pointsize 0.4 title "implicit Euler, 1 to 32 steps", \
     one index 1 using 2:3 with linespoints linetype 2 pointtype 7 \
         pointsize 0.4 title "Crank-Nicolson, 1 to 32", \
     bed index 0 using 2:3 with points pointtype 6 pointsize 1 \
         linecolor "#0b5a8a" notitle, \
     bed index 2 using 2:3 with lines linetype 3 dashtype 2 linewidth 1.2 \
         title "in a bed", \
     bed index 1 using 2:3 with lines linetype 2 dashtype 2 linewidth 1.2 \
         notitle
unset multiplot
