# EW18 Fig. 18b: moments of the bed in a gas, from figures/23/23-gas-moments.sh.
load "figures/style.gp"
set terminal png size 1000,620 background "#ffffff"
set output "figures/23/23-gas-moments.png"
dir = "out/23-gas-moments/"
set border 0
unset tics
unset key
set xrange [0:10]
set yrange [0:36]
set cbrange [-1:5]
set palette defined (-1 "#c2571a", 0 "#ffffff", 2.5 "#7fb3d3", 5 "#0b3c5d")
unset colorbox
set multiplot
do for [k = 0:7] {
    set lmargin at screen 0.01 + 0.115 * k
    set rmargin at screen 0.01 + 0.115 * k + 0.107
    set bmargin at screen 0.02
    set tmargin at screen 0.93
    set title sprintf("%d", 56 + 2 * k) offset 0,-0.7
    set object 1 rectangle from 0,0 to 10,36 fillstyle empty border linecolor "#999999"
    if (k == 7) {
        set colorbox user origin screen 0.945, screen 0.3 size screen 0.012, screen 0.4
        set cbtics 1
        set cblabel "upward velocity of the gas [{/:Italic u}_{in}]"
    }
    plot dir . "field.txt" index k using ($1 / 1000):($2 / 1000):3 with image pixels, \
         dir . "points.txt" index k using ($1 / 1000):($2 / 1000):(0.5) with circles \
             linecolor "#333333" linewidth 0.6
}
unset multiplot
