# Speed of the spheres across the spouted bed at six heights, measured and computed.
load "figures/style.gp"
set terminal svg size 720,500 dynamic font "sans,12" background "#ffffff"
set output "figures/27/27-spouted.svg"
heights = "30 60 90 120 150 160"
set multiplot
set xrange [-140:140]
set yrange [0:1.2]
set xtics -100,50,100
set ytics 0,0.5,1.5
do for [k = 1:6] {
    col = (k - 1) % 3
    row = (k - 1) / 3
    set lmargin at screen 0.07 + 0.315 * col
    set rmargin at screen 0.34 + 0.315 * col
    set tmargin at screen 0.93 - 0.47 * row
    set bmargin at screen 0.61 - 0.47 * row
    h = word(heights, k)
    set title h . " mm above the bottom" font "sans,12"
    if (row == 1) { set xlabel "x from the middle [mm]" font "sans,11" } else { unset xlabel }
    if (col == 0) { set ylabel "speed [m/s]" } else { unset ylabel }
    if (k == 1) { set key top right samplen 1.5 font "sans,11" } else { unset key }
    plot sprintf("< awk '!/^#/ && $1 * 200 > %s - 0.5 && $1 * 200 < %s + 0.5' figures/data/yue-2020.txt", h, h) \
             using 2:3 with points pointtype 6 pointsize 0.6 linecolor "#333333" title "measured", \
         sprintf("< awk '$1 == %s' figures/27/27-spouted.txt", h) \
             using 2:(sqrt($3**2 + $4**2)) with lines linetype 1 linewidth 1.5 title "computed"
}
unset multiplot
