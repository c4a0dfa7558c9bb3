# XS11 Case 1 on the way up: the kernel on two meshes, and sums of each cell.
load "figures/style.gp"
set output "figures/30/30-ramp-kernels.svg"
set xlabel "U [m/s]"
set ylabel "pressure drop between the sensors [Pa]"
set xrange [0.2:1.2]
set yrange [0:280]
set key bottom right
up(f) = sprintf("< awk '$1 < 15' figures/30/%s.txt", f)
plot up("30-ramp-15x75") using 2:3 with lines linetype 1 title "kernel, 15 x 75", \
     up("30-ramp-25x100") using 2:3 with lines linetype 3 title "kernel, 25 x 100", \
     up("30-ramp-pcm-25x100") using 2:3 with lines linetype 2 title "PCM, 25 x 100: ends at 0.89 m/s", \
     "< tail -n 1 figures/30/30-ramp-pcm-25x100.txt" using 2:3 with points pointtype 2 linewidth 2 linecolor "#c2571a" notitle, \
     up("../data/xiao-sun-2011-case1") using 2:3 with points pointtype 6 linecolor "#0b5a8a" title "XS11 Fig. 4, kernel", \
     249.4 linecolor "#777777" linewidth 1 dashtype 2 title "weight of the bed"
