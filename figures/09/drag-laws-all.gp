# All laws for many spheres over Beetstra's, from figures/09/drag-laws-all.txt: at
# Re = 1 and at Re = 100.
load "figures/style.gp"
set terminal svg size 720,620 dynamic font "sans,14" background "#ffffff"
set output "figures/09/drag-laws-all.svg"
set datafile missing "?"
set multiplot layout 1,2 margins 0.09,0.98,0.34,0.93 spacing 0.09
set xrange [0.36:0.98]
set yrange [0.4:2.0]
set xtics 0.2
set xlabel "fluid fraction {/:Italic  ε_f} [-]"
set ylabel "drag over that of Beetstra's law" offset 1,0
set linetype 6 linecolor "#c9a400" linewidth 2.5 dashtype (2,4)
set linetype 7 linecolor "#d4458e" linewidth 2.5 dashtype (24,3)
set linetype 8 linecolor "#3aa6a6" linewidth 2.5 dashtype (10,3,2,3,2,3)
set linetype 9 linecolor "#111111" linewidth 2.5
set linetype 10 linecolor "#c2571a" linewidth 2.5 dashtype 2
set linetype 11 linecolor "#3d7a3d" linewidth 2.5 dashtype 2
set key at screen 0.52,0.12 center maxrows 4 samplen 3.5
laws = "syamlal-obrien gidaspow huilin-gidaspow di-felice di-felice-printed beetstra hill-koch-ladd tenneti rong cello"
do for [Re in "1 100"] {
    set title "Re = ".Re
    plot for [i=1:10] "figures/09/drag-laws-all.txt" using "eps_f":word(laws, i)."_".Re \
        with lines linetype word("1 2 10 3 11 9 4 6 7 8", i) + 0 title word(laws, i)
    unset key
    unset ylabel
}
unset multiplot
