# Tests 5 and 6 of Chung and Ooi (2011), from figures/16/16-slip.txt.
load "figures/style.gp"
set output "figures/16/16-slip.svg"
paper = "figures/data/chung_ooi2011_curves.csv"
taken(what) = sprintf("< grep '%s' %s | cut -d, -f4,5 | tr , ' '", what, paper)
set multiplot layout 1,2
set title "test 5: spin from sliding"
set xlabel "v_t / (μ v_n)"
set ylabel "R ω / (μ v_n)"
set xrange [0:12]
set yrange [-6:0]
plot "figures/16/16-slip.txt" index 0 using 1:2 with lines linetype 1 title "Winnow", \
     taken("^5,steel") using 1:2 with points pointtype 6 linecolor "#c2571a" title "their code", \
     taken("^5,FEM") using 1:2 with points pointtype 7 linecolor "#3d7a3d" title "finite elements"
set title "test 6: sliding stopped"
set xlabel "7 μ (1 + e) v_n / (2 R ω)"
set ylabel "speed of the surface after / before, reversed"
set xrange [0:8]
set yrange [-1:0.4]
set key right bottom
plot "figures/16/16-slip.txt" index 1 using 1:2 with lines linetype 1 title "Winnow", \
     taken("^6,Al") using 1:2 with points pointtype 6 linecolor "#c2571a" title "their code", \
     (x < 1 ? x - 1 : NaN) with lines linecolor "#999999" dashtype 2 title "all slides"
unset multiplot
