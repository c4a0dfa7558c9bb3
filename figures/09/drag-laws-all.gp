# All laws for many spheres over Beetstra's, from figures/09/drag-laws-all.txt: at
# Re = 1 and at Re = 100. Columns follow the order of `winnow list drag`.
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
set linetype 5 linecolor "#999999" linewidth 2.5
set linetype 6 linecolor "#c9a400" linewidth 2.5 dashtype (2,4)
set linetype 7 linecolor "#d4458e" linewidth 2.5 dashtype (24,3)
set linetype 8 linecolor "#3aa6a6" linewidth 2.5 dashtype (10,3,2,3,2,3)
set linetype 9 linecolor "#111111" linewidth 2.5
set key at screen 0.52,0.12 center maxrows 4 samplen 3.5
set title "Re = 1"
file = "figures/09/drag-laws-all.txt"
plot file using 1:2 with lines linetype 1 title "syamlal-obrien", \
     "" using 1:3 with lines linetype 2 title "gidaspow", \
     "" using 1:8 with lines linetype 2 dashtype 2 title "huilin-gidaspow", \
     "" using 1:5 with lines linetype 3 title "di-felice", \
     "" using 1:6 with lines linetype 3 dashtype 2 title "di-felice-printed", \
     "" using 1:7 with lines linetype 9 title "beetstra", \
     "" using 1:9 with lines linetype 4 title "hill-koch-ladd", \
     "" using 1:10 with lines linetype 6 title "tenneti", \
     "" using 1:11 with lines linetype 7 title "rong", \
     "" using 1:12 with lines linetype 8 title "cello"
unset key
unset ylabel
set title "Re = 100"
plot file using 1:15 with lines linetype 1, \
     "" using 1:16 with lines linetype 2, \
     "" using 1:21 with lines linetype 2 dashtype 2, \
     "" using 1:18 with lines linetype 3, \
     "" using 1:19 with lines linetype 3 dashtype 2, \
     "" using 1:20 with lines linetype 9, \
     "" using 1:22 with lines linetype 4, \
     "" using 1:23 with lines linetype 6, \
     "" using 1:24 with lines linetype 7, \
     "" using 1:25 with lines linetype 8
unset multiplot
