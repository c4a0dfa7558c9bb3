# A sphere rolls until it stops, from figures/17/17-rolling.txt.
load "figures/style.gp"
set terminal svg size 860,330 dynamic font "sans,13" background "#ffffff"
set encoding utf8
set output "figures/17/17-rolling.svg"
set multiplot layout 1,2
set xlabel "time [s]"
set ylabel "speed [m/s]"
set xrange [0:1.5]
set yrange [-0.01:0.21]
set ytics 0.05
plot 0.2 - 5.0 / 7.0 * 0.025 * 9.81 * x with lines linetype 2 dashtype 2 \
         title "(5/7) μ_r g", \
     "figures/17/17-rolling.txt" index 0 using 1:2 with points linetype 1 \
         pointtype 7 pointsize 0.35 title "the run"
set xlabel "time around the stop [ms]"
set ylabel "size of the speed [µm/s]"
set xrange [0:120]
set logscale y
set yrange [1e-3:1e3]
set ytics 10
set format y "10^{%L}"
plot "figures/17/17-rolling.txt" index 1 using 1:(abs($3)) with lines linetype 2 \
         title "a constant moment", \
     "" index 1 using 1:(abs($2)) with lines linetype 1 \
         title "a spring that slips"
unset multiplot
