# The grains of cases/seepage.cfg seen from the front, a panel a picture of
# out/30-moments, from figures/30/30-moments.sh: x, y, radius [mm] and class, every 0.1 s.
set terminal pngcairo size 1080,560 font "Sans,11" background "#ffffff"
set output "figures/30/30-moments.png"
set border 3 linecolor "#999999"
set tics nomirror textcolor "#333333"
set size ratio -1
set xrange [0:40]
set yrange [0:56]
set xlabel "x [mm]"
set style fill solid 1.0 border linecolor "#ffffff"
unset key
set multiplot layout 1,3 margins 0.06,0.985,0.11,0.94 spacing 0.05
do for [k in "0 6 41"] {
    at = int(k)
    set title sprintf("%g s", 0.1 * at)
    if (at == 0) { set ylabel "y [mm]" } else { unset ylabel }
    plot "out/30-moments/circles.txt" index at using ($4 == 2 ? $1 : 1/0):2:3 \
             with circles linecolor "#c9d6de" linewidth 0.5, \
         "" index at using ($4 == 1 ? $1 : 1/0):2:3 with circles linecolor "#6b8fa5" linewidth 0.5, \
         "" index at using ($4 == 0 ? $1 : 1/0):2:3 with circles linecolor "#c2571a" linewidth 0.5
}
unset multiplot
