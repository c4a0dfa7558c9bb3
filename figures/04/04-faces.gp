# A small mesh, its cells and its faces, from figures/04/04-faces.txt.
load "figures/style.gp"
set output "figures/04/04-faces.svg"
data = "figures/04/04-faces.txt"
long = 0.2 # of an arrow, for a face of area 1
unset border
unset grid
unset key
set size ratio -1
set xrange [-0.7:4.7]
set yrange [-0.25:2.6]
unset xtics
unset ytics
set style arrow 1 head filled size 0.07,20 linecolor "#c2571a" linewidth 1.5
do for [i=1:4] {
    x = real(word("0 0.906 2.188 4", i))
    set arrow from x, 0 to x, 2 nohead linecolor "#555555"
}
set arrow from 0, 1 to 4, 1 nohead linecolor "#555555"
set arrow from 0, 0 to 4, 0 nohead linecolor "#999999" dashtype 3
set arrow from 0, 2 to 4, 2 nohead linecolor "#999999" dashtype 3
set label "left" at -0.5,1 center rotate textcolor "#555555"
set label "right" at 4.5,1 center rotate textcolor "#555555"
set label "the faces above are those below: y is periodic" at 2,2.55 center \
    textcolor "#555555"
plot data index 0 using 2:3:(sprintf("%d", $1)) with labels \
         font "sans,22" textcolor "#0b5a8a", \
     data index 1 using 9:10:(long*$4):(long*$5) with vectors arrowstyle 1, \
     data index 1 using 9:10:(sprintf("%d", $1)) with labels \
         offset character 0.9,-0.7 textcolor "#c2571a"
