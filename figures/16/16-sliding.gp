# What a rule of sliding changes, from figures/16/16-sliding.txt.
load "figures/style.gp"
set output "figures/16/16-sliding.svg"
set xlabel "angle of the impact from the normal [degrees]"
set ylabel "difference (% of the speed before)"
set xrange [0:60]
set yrange [0:1]
set key at 59,0.35
plot "figures/16/16-sliding.txt" using 1:4 with linespoints title "Winnow and LIGGGHTS", \
     "" using 1:5 with linespoints title "Winnow and its own rule", \
     "" using 1:6 with linespoints title "LIGGGHTS and its rule by itself"
