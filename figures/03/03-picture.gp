# A bed one grain deep in two chunks, and the neighbours of one sphere, from
# figures/03/03-picture.txt.
load "figures/style.gp"
set terminal svg size 720,500 dynamic font "sans,14" background "#ffffff"
set output "figures/03/03-picture.svg"
data = "figures/03/03-picture.txt"
unset key
unset grid
set border 0
unset xtics
unset ytics
set multiplot layout 1,2
set size ratio -1
set xrange [0:40]
set yrange [0:55]
set title "two chunks"
plot data index 0 using ($3 == 0 ? $1 : 1/0):2 with points pointtype 7 \
         pointsize 0.3 linecolor "#0b5a8a", \
     data index 0 using ($3 == 1 ? $1 : 1/0):2 with points pointtype 7 \
         pointsize 0.3 linecolor "#c2571a"
stats data index 1 every ::0::0 using 1:2 nooutput
px = STATS_min_x
py = STATS_min_y
stats data index 2 using 1:3 nooutput
x0 = STATS_min_x
y0 = STATS_min_y
stats data index 2 using 2:4 nooutput
wx = STATS_min_x
wy = STATS_min_y
a = floor((px - x0) / wx)
b = floor((py - y0) / wy)
do for [k=-1:2] {
    set arrow from x0+(a+k)*wx, y0+(b-1)*wy to x0+(a+k)*wx, y0+(b+2)*wy \
        nohead linecolor "#555555"
    set arrow from x0+(a-1)*wx, y0+(b+k)*wy to x0+(a+2)*wx, y0+(b+k)*wy \
        nohead linecolor "#555555"
}
set object circle at px,py size 1.1667 front fillstyle empty \
    border linecolor "#c2571a"
set xrange [px-3:px+3]
set yrange [py-4.1:py+4.1]
set title "one sphere, its cells and its neighbours"
near(u, v) = abs(u - px) < 2.6 && abs(v - py) < 3.6
plot data index 0 using (near($1, $2) ? $1 : 1/0):2:(0.5) with circles \
         fill solid 0.15 border \
         linewidth 0.5 linecolor "#0b5a8a", \
     data index 1 using 1:2:(0.5) with circles fill solid 0.6 border \
         linewidth 0.5 linecolor "#0b5a8a", \
     data index 1 every ::0::0 using 1:2:(0.5) with circles \
         linecolor "#c2571a" fill solid 0.9 noborder
unset multiplot
