# Mueller's bed after 2 s, bandwidths of 8 to 2 diameters and two seeds, from
# figures/25/25-moments.sh.
dir = "out/study-sx15-bandwidth/"
points(r) = sprintf("%spoints-%d.txt", dir, r)
field(r) = sprintf("%sfield-%d.txt", dir, r)
lines(r, k) = sprintf("%sline-%d-%d.txt", dir, r, k)
set border 0
unset tics
unset key
set xrange [0:44]
set yrange [0:66]
set contour base
set cntrparam levels discrete 0.28
unset surface
do for [r = 0:1] { do for [k = 0:4] {
    set table lines(r, k)
    splot field(r) index k using 1:2:3
    unset table
} }
set terminal png size 760,500 background "#ffffff"
set output "figures/25/25-moments.png"
set multiplot
do for [r = 0:1] { do for [k = 0:4] {
    set lmargin at screen 0.05 + 0.19 * k
    set rmargin at screen 0.05 + 0.19 * k + 0.18
    set bmargin at screen 0.50 - 0.485 * r
    set tmargin at screen 0.50 - 0.485 * r + 0.43
    if (r == 0) { set title word("8 6 4 3 2", k + 1) . " d" offset 0,-0.7 } else { unset title }
    set label 1 k == 0 ? sprintf("seed %d", r) : "" at graph -0.12,0.5 center rotate by 90
    set object 1 rectangle from 0,0 to 44,66 fillstyle empty border linecolor "#999999"
    plot points(r) index k using 1:2 with points pointtype 7 pointsize 0.22 \
             linecolor "#6b8fa5", \
         lines(r, k) using 1:2 with lines linecolor "#c2571a" linewidth 2
} }
unset multiplot
