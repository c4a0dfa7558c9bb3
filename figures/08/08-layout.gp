# One bed averaged in three ways, from figures/08/08-layout.txt.
load "figures/style.gp"
set terminal svg size 860,290 dynamic font "sans,13" background "#ffffff"
set output "figures/08/08-layout.svg"
set multiplot
unset key
set border 15
set xrange [0:18]
set yrange [0:18]
set xtics 3 format ""
set ytics 3 format ""
set tics scale 0.4
set cbrange [0:0.6]
set palette maxcolors 24
set palette defined (0 "#ffffff", 0.2 "#cfe0ea", 0.4 "#5b97bd", 0.6 "#0b3a5a")
set bmargin at screen 0.05
set tmargin at screen 0.88
unset colorbox
set lmargin at screen 0.010
set rmargin at screen 0.235
set title "particles" offset 0,-0.6
plot "figures/08/08-layout.txt" index 0 using 1:2 with points pointtype 6 \
     pointsize 1.0 linecolor "#555555" linewidth 0.8
unset grid
do for [k = 0:2] {
    set lmargin at screen 0.245 + 0.235 * k
    set rmargin at screen 0.470 + 0.235 * k
    set title word("pcm kernel diffusion", k + 1) offset 0,-0.6
    if (k == 2) {
        set colorbox user origin screen 0.945, 0.05 size screen 0.012, 0.83
        set cbtics 0.2
    }
    plot "figures/08/08-layout.txt" index 1 \
        using 1:2:(0.76):(0.76):(column(3 + k)) with boxxyerror \
        linecolor palette linewidth 0 fillstyle solid noborder
}
unset multiplot
