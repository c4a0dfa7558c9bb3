# The grains of cases/seepage.cfg seen from the front, a panel a picture of
# out/30-moments, from figures/30/30-moments.sh: x, y, radius [mm] and class.
set terminal pngcairo size 760,430 font "Sans,11" background "#ffffff"
set output "figures/30/30-moments.png"
set border 3 linecolor "#999999"
set tics nomirror textcolor "#333333"
set size ratio -1
set xrange [0:40]
set yrange [0:42]
set xlabel "x [mm]"
set style fill solid 1.0 border linecolor "#ffffff"
unset key
set multiplot layout 1,2 margins 0.08,0.985,0.14,0.93 spacing 0.06
do for [k = 0:1] {
    set title word("0 0.6", k + 1) . " s"
    if (k == 0) { set ylabel "y [mm]" } else { unset ylabel }
    plot "out/30-moments/circles.txt" index k using ($4 == 2 ? $1 : 1/0):2:3 \
             with circles linecolor "#c9d6de" linewidth 0.5, \
         "" index k using ($4 == 1 ? $1 : 1/0):2:3 with circles linecolor "#6b8fa5" linewidth 0.5, \
         "" index k using ($4 == 0 ? $1 : 1/0):2:3 with circles linecolor "#c2571a" linewidth 0.5
}
unset multiplot
