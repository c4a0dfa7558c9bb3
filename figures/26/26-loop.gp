# Mean void fraction across the small bed, in the loop, from figures/26/26-loop.txt.
load "figures/style.gp"
set terminal svg size 860,330 dynamic font "sans,13" background "#ffffff"
set output "figures/26/26-loop.svg"
set datafile separator ","
set multiplot layout 1,2
set xlabel "x [mm]"
set xrange [0:16]
set yrange [0.2:1]
do for [k = 0:1] {
    if (k == 0) {
        set title "pcm with a cap of 0.7"
        set ylabel "mean void fraction at 12 mm"
        set key bottom left
    } else {
        set title "diffusion"
        unset ylabel
        unset key
    }
    plot for [m = 0:3] "figures/26/26-loop.txt" index 2 * m + k \
        using (1000 * $1):2 with linespoints pointsize 0.5 \
        title word("4x16 8x32 12x48 16x64", m + 1)
}
unset multiplot
