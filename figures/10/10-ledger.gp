# gnuplot figures/10/10-ledger.gp, from the top folder
load "figures/style.gp"
set terminal svg size 760,350 dynamic font "sans,13" background "#ffffff"
set output "figures/10/10-ledger.svg"
set multiplot layout 1,2
set xlabel "time [s]"
set xrange [0:0.1]
set xtics 0.02
set title "without the unpaid impulses"
set ylabel "momentum lost or gained / all momentum [%]"
plot "figures/10/10-ledger.txt" using 1:(100 * $2) with lines linetype 1 notitle
set title "with them"
set ylabel "change of (10.6) / all momentum [-]"
set logscale y
set format y "10^{%L}"
set yrange [1e-17:1e-9]
set ytics 100
plot "figures/10/10-ledger.txt" using 1:($3 + 1e-17) with lines linetype 2 notitle
unset multiplot
