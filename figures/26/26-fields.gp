# One layout by eight ways on three meshes, from figures/26/26-fields.txt.
load "figures/style.gp"
set terminal pngcairo size 1240,520 font "sans,15" background "#ffffff"
set output "figures/26/26-fields.png"
set multiplot
unset key
unset grid
set border 15
set xrange [0:24]
set yrange [0:24]
unset xtics
unset ytics
set cbrange [-0.2:0.8]
set palette defined (-0.2 "#b00020", -0.001 "#f7c6cc", 0 "#ffffff", \
                     0.2 "#cfe0ea", 0.4 "#5b97bd", 0.6 "#0b3a5a", \
                     0.8 "#000000")
unset colorbox
names = "exact pcm dpvm two-grid kernel images series Crank-N."
sizes = "4 2 0.5"
do for [r = 0:2] {
    set tmargin at screen 0.945 - 0.315 * r
    set bmargin at screen 0.945 - 0.315 * r - 0.30
    do for [k = 0:7] {
        set lmargin at screen 0.028 + 0.1135 * k
        set rmargin at screen 0.028 + 0.1135 * k + 0.109
        if (r == 0) {
            set title word(names, k + 1) offset 0,-0.8
        } else {
            unset title
        }
        unset ylabel
        if (k == 0) {
            set ylabel "cells of ".word(sizes, r + 1)." d" offset 1,0
        }
        if (r == 2 && k == 7) {
            set colorbox user origin screen 0.94, 0.06 size screen 0.010, 0.85
            set cbtics 0.2 format "%.1f"
        }
        plot "figures/26/26-fields.txt" index r \
            using 1:2:($3 / 2):($3 / 2):(column(4 + k)) with boxxyerror \
            linecolor palette linewidth 0 fillstyle solid noborder
    }
}
unset multiplot
