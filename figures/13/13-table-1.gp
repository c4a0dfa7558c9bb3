# XS11 Table 1 over what is computed, from figures/13/13-table-1.txt.
load "figures/style.gp"
set output "figures/13/13-table-1.svg"
set xlabel "entry of the table, row by row"
set ylabel "computed over printed"
set xrange [0:17]
set yrange [0:1.3]
set xtics 1,1,16
set key bottom left
set arrow from 8.5,0 to 8.5,1.25 nohead linecolor "#999999" dashtype 3
set label "water" at 4.5,1.22 center textcolor "#555555"
set label "air" at 12.5,1.22 center textcolor "#555555"
plot 1 with lines linecolor "#999999" notitle, \
     "figures/13/13-table-1.txt" using ($0 + 1):7 with points linetype 2 \
         pointtype 7 pointsize 0.9 title "2000 kg/m³, air 1.2 kg/m³, 1.8e-5 Pa s", \
     "" using ($0 + 1):9 with points linetype 1 \
         pointtype 5 pointsize 0.8 title "2650 kg/m³, air 1.0 kg/m³, 1e-5 Pa s"
