# Test 6 of Chung and Ooi by four rules for the spring, from figures/02/02-caps.txt.
load "figures/style.gp"
set output "figures/02/02-caps.svg"
data = "figures/02/02-caps.txt"
set logscale x
set xlabel "7/2 µ (1 + e) v over the slip: slides, left; sticks, right"
set ylabel "slip after over slip before"
set xzeroaxis linetype 1 linecolor "#555555" linewidth 1
set key top right
plot data using 1:6 with points pointtype 7 linecolor "#333333" \
         title "published [Chung11]", \
     data using 1:2 with lines linetype 2 title "spring and dashpot", \
     data using 1:3 with lines linetype 3 title "the spring alone", \
     data using 1:4 with lines linetype 4 title "capped first", \
     data using 1:5 with lines linetype 1 title "reduced to the cap"
