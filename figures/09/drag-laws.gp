# Two drag laws against the fluid fraction, from figures/09/drag-laws.txt.
load "figures/style.gp"
set output "figures/09/drag-laws.svg"
set logscale y
set xlabel "fluid fraction {/:Italic  ε_f} [-]"
set ylabel "resistance over that of Stokes"
set xrange [0.35:1]
set yrange [0.8:60]
set label "Re = 100" at 0.40,28 textcolor "#555555"
set label "Re = 1" at 0.40,5.6 textcolor "#555555"
plot "figures/09/drag-laws.txt" using 1:2 with lines linetype 1 \
         title "Syamlal-O'Brien", \
     "" using 1:3 with lines linetype 2 title "Gidaspow (Ergun, Wen-Yu)", \
     "" using 1:4 with lines linetype 1 notitle, \
     "" using 1:5 with lines linetype 2 notitle
