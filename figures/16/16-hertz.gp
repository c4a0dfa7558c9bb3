# Force in time of two head-on impacts, from figures/16/16-hertz.txt, with the curves
# that Chung and Ooi (2011) print.
load "figures/style.gp"
set output "figures/16/16-hertz.svg"
paper = "figures/data/chung_ooi2011_curves.csv"
taken(test) = sprintf("< grep '^%d,.*F_kN vs time' %s | cut -d, -f4,5 | tr , ' '", test, paper)
set multiplot layout 1,2
set ylabel "force [kN]"
set xlabel "time [μs]"
set yrange [0:15]
set title "two glass spheres"
set xrange [0:45]
plot "figures/16/16-hertz.txt" index 0 using 1:3 with lines linetype 1 title "Winnow", \
     taken(1) using 1:2 with points pointtype 6 linecolor "#c2571a" title "printed"
set title "aluminium on a rigid plane"
set xrange [0:800]
plot "figures/16/16-hertz.txt" index 1 using 1:3 with lines linetype 1 title "Winnow", \
     taken(2) using 1:2 with points pointtype 6 linecolor "#c2571a" title "printed"
unset multiplot
