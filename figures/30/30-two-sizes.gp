# XS11 Case 2 (Figs. 6 and 7): drop and velocity of the grains at the lower sensor on
# two meshes, with the kernel and with PCM; figures/30/30-two-sizes.txt.
load "figures/style.gp"
set terminal svg size 860,560 dynamic font "sans,13" background "#ffffff"
set output "figures/30/30-two-sizes.svg"
set multiplot layout 2,2 columnsfirst
set xrange [0:6]
set key top right horizontal samplen 2
f = "figures/30/30-two-sizes.txt"
do for [k=0:1] {
    set title (k == 0 ? "kernel, 10 mm" : "PCM")
    set xlabel ""
    set ylabel "drop between the sensors [Pa]"
    set yrange [150:850]
    plot f using 1:(column(2 + 4*k)) with lines linewidth 1.3 title "12 x 60", \
         f using 1:(column(4 + 4*k)) with lines linewidth 1.3 title "8 x 40"
    set title ""
    set xlabel "t [s]"
    set ylabel "u_{s,y} at 2 mm [mm/s]"
    set yrange [-6:6]
    plot f using 1:(column(3 + 4*k)) with lines linewidth 1.3 title "12 x 60", \
         f using 1:(column(5 + 4*k)) with lines linewidth 1.3 title "8 x 40"
}
unset multiplot
