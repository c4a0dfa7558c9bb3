# Mean void fraction across the Mueller bed, in the loop, from figures/21-mueller.txt.
load "figures/style.gp"
set terminal svg size 860,330 dynamic font "sans,13" background "#ffffff"
set output "figures/21-mueller.svg"
set datafile separator ","
set multiplot layout 1,2
set xlabel "x [mm]"
set xrange [0:44]
set yrange [0.45:1]
do for [k = 0:1] {
    if (k == 0) {
        set title "pcm with a cap of 0.7"
        set ylabel "mean void fraction at 16.4 mm"
        set key top right
    } else {
        set title "diffusion"
        unset ylabel
        unset key
    }
    plot for [m = 0:2] "figures/21-mueller.txt" index 2 * m + k \
        using (1000 * $1):2 with linespoints pointsize 0.5 \
        title word("A B' C", m + 1)
}
unset multiplot
