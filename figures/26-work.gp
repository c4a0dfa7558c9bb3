# Error against time, from figures/26-slot.txt: each line is a method, from cells of
# 6 d to 0.5 d. Left: methods with a width of their own kind; right: diffusion.
load "figures/style.gp"
set terminal svg size 860,460 dynamic font "sans,13" background "#ffffff"
set output "figures/26-work.svg"
set multiplot layout 1,2 margins 0.09,0.98,0.14,0.9 spacing 0.06
set logscale xy
set xlabel "time to average one field [ms]"
set ylabel "distance from the exact kernel field / its sum [-]"
set xrange [0.02:200]
set yrange [1e-6:5]
set format xy "10^{%L}"
set key bottom left samplen 3 spacing 1.1
# a name has spaces around it
f(name) = "< grep ' " . name . " ' figures/26-slot.txt"
set title "by cells, kernels and grids"
plot f("pcm") using 7:3 with linespoints lt 1 pt 7 ps 0.7 lw 1.8 title "pcm", \
     f("dpvm") using 7:3 with linespoints lt 2 pt 5 ps 0.7 lw 1.8 dt 2 title "dpvm", \
     f("two-grid-3d") using 7:3 with linespoints lt 3 pt 9 ps 0.8 lw 1.8 dt 4 title "two-grid-3d", \
     f("bell-2.5-cells") using 7:3 with linespoints lt 4 pt 4 ps 0.8 lw 1.8 title "bell-2.5-cells", \
     f("images") using 7:3 with linespoints lc "#333333" pt 6 ps 0.8 lw 1.8 dt 3 title "images"
unset ylabel
set format y ""
set title "by diffusion"
plot f("exponential") using 7:3 with linespoints lt 1 pt 7 ps 0.7 lw 1.8 title "exponential", \
     f("crank-nicolson-1") using 7:3 with linespoints lt 2 pt 5 ps 0.7 lw 1.8 title "crank-nicolson-1", \
     f("crank-nicolson-3") using 7:3 with linespoints lt 2 pt 4 ps 0.8 lw 1.8 dt 2 title "crank-nicolson-3", \
     f("implicit-euler-1") using 7:3 with linespoints lt 3 pt 9 ps 0.8 lw 1.8 title "implicit-euler-1", \
     f("implicit-euler-3") using 7:3 with linespoints lt 3 pt 8 ps 0.8 lw 1.8 dt 2 title "implicit-euler-3", \
     f("sdirk2-2") using 7:3 with linespoints lt 4 pt 13 ps 0.8 lw 1.8 title "sdirk2-2", \
     f("sdirk2-4") using 7:3 with linespoints lt 4 pt 12 ps 0.8 lw 1.8 dt 2 title "sdirk2-4"
unset multiplot
