# What EW18's Figs. 1 to 5 draw: (a) the share of each cell of a grain by its
# bounding cube; (b) a Gaussian at a wall and its image; (c) the Gaussian and its
# slope; (d) the parts of a force. The beds of Fig. 4 are in figures/sketches/beds.awk.
load "figures/style.gp"
set terminal svg size 960,300 dynamic font "sans,13" background "#ffffff"
set output "figures/23/23-sketch.svg"
set multiplot
unset key
blue = "#0b5a8a"
orange = "#c2571a"
gray = "#777777"

# (a) a cell is 1/0.6 d wide; what the grain gives to each is that share of
# the cube around it
set border 0
unset tics
unset grid
set size 0.22,0.96
set origin 0.0,0.02
set size ratio -1
set title "(a) bounding cube" offset 0,-0.5
a = 5.0 / 3.0
x = 1.55
y = 2.35
set xrange [0:2*a]
set yrange [0:2*a]
set object 1 rectangle from x-0.5,y-0.5 to a,y+0.5 fillcolor rgb "#b8d0e0" fillstyle solid noborder
set object 2 rectangle from a,y-0.5 to x+0.5,y+0.5 fillcolor rgb "#f0cdb8" fillstyle solid noborder
set object 3 circle at x,y size 0.5 fillstyle empty border linecolor rgb "#000000"
do for [i=0:2] {
    set arrow from i*a,0 to i*a,2*a nohead linecolor rgb gray
    set arrow from 0,i*a to 2*a,i*a nohead linecolor rgb gray
}
set label 1 "0.62" at x-0.25,y+0.68 center textcolor rgb blue
set label 2 "0.38" at x+0.4,y+0.68 center textcolor rgb orange
set label 3 "a cell, 1.67 {/:Italic d}" at 1.5*a,0.35 center
plot NaN
unset arrow
unset object
unset label

# (b) the wall at 0, the grain at 0.4 d; delta_05 = d
s = 1.0 / (2 * sqrt(2 * log(2)))
g(r) = exp(-r * r / (2 * s * s)) / (s * sqrt(2 * pi))
c = 0.4
set size noratio
set size 0.26,0.96
set origin 0.23,0.02
set border 1
set xtics 1
set title "(b) Gaussian at a wall" offset 0,-0.5
set xrange [-1.5:2]
set yrange [0:1.35]
set xlabel "distance from the wall [{/:Italic d}]"
set object 1 rectangle from -1.5,0 to 0,1.35 fillcolor rgb "#e4e4e4" fillstyle solid noborder behind
set samples 300
set label 1 "grain" at 1.0,0.85 textcolor rgb blue
set label 2 "image" at -1.3,0.6 textcolor rgb orange
set label 3 "both" at 0.35,1.22
plot g(x - c) with lines linewidth 2 linecolor rgb blue, \
     g(x + c) with lines linewidth 2 dashtype 2 linecolor rgb orange, \
     (x >= 0 ? g(x - c) + g(x + c) : NaN) with lines linewidth 2 linecolor rgb "#000000"
unset object
unset label

# (c) over its maximum, with its slope
set size 0.27,0.96
set origin 0.5,0.02
set title "(c) Gaussian and its slope" offset 0,-0.5
set xrange [-1.5:1.5]
set yrange [-1:1.1]
set ytics 0.5
set border 3
set xlabel "{/:Italic r} / δ_{0.5} [-]"
set arrow 1 from -0.5,0.5 to 0.5,0.5 heads linecolor rgb gray
set label 1 "δ_{0.5}" at 0,0.3 center textcolor rgb gray
set label 2 "{/:Italic W}" at 0.3,0.95 textcolor rgb blue
set label 3 "d{/:Italic W}/d{/:Italic r}" at 0.45,-0.85 textcolor rgb orange
w(r) = exp(-r * r / (2 * s * s))
plot w(x) with lines linewidth 2 linecolor rgb blue, \
     -x / s * w(x) * exp(0.5) * 0.7 with lines linewidth 2 dashtype 2 linecolor rgb orange
unset arrow
unset label

# (d) of the force on a grain the part along the slip is its drag
set border 0
unset tics
unset xlabel
set size ratio -1
set size 0.24,0.96
set origin 0.77,0.02
set title "(d) parts of a force" offset 0,-0.5
set xrange [-1.2:2.4]
set yrange [-1.2:2.4]
set object 1 circle at 0,0 size 0.5 fillcolor rgb "#dddddd" fillstyle solid border linecolor rgb "#000000"
set arrow 1 from 0,0 to 0,1.8 linewidth 2 linecolor rgb blue
set arrow 2 from 0,0 to 0.9,1.8 linewidth 2 linecolor rgb "#000000"
set arrow 3 from 0,0 to 0.9,0 linewidth 2 linecolor rgb orange
set arrow 4 from 0.9,0 to 0.9,1.8 nohead dashtype 2 linecolor rgb gray
set arrow 5 from 0,1.8 to 0.9,1.8 nohead dashtype 2 linecolor rgb gray
set arrow 6 from -0.9,-1 to -0.9,-0.1 linewidth 2 linecolor rgb gray
set label 1 "drag, along the slip" at 0,2.1 center textcolor rgb blue
set label 2 "force" at 1.0,1.4
set label 3 "across it" at 1.0,0.1 textcolor rgb orange
set label 4 "slip {/:Bold w}" at -0.75,-0.75 textcolor rgb gray
plot NaN
unset multiplot
