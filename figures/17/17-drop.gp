# Where the grains of a drop lie in the end, from figures/17/17-drop.txt.
load "figures/style.gp"
set terminal pngcairo size 1400,330 font "Sans,22" background "#ffffff"
set output "figures/17/17-drop.png"
set multiplot layout 1,3 margins 0.03, 0.985, 0.36, 0.87 spacing 0.045
unset key
unset grid
set size ratio -1
set xrange [0:40]
set yrange [0:9]
set xtics 10
set ytics 3
set xlabel "x [mm]"
set palette defined (0 "#35566b", 0.6 "#8fb3c8", 1 "#e4eef4")
unset colorbox
do for [k = 1:3] {
    name = word("wet,_0.072 damp,_0.020 dry", k)
    sub = strstrt(name, "_")
    set title sub ? name[1:sub - 1]." ".name[sub + 1:sub + 5]." N/m" : name
    plot "figures/17/17-drop.txt" index k using 1:2:(0.5):0 with circles \
        linewidth 0.4 linecolor palette fillstyle solid border linecolor "#22333d"
}
unset multiplot
