# A signal with a memory, and its correlation, from figures/23/23-signal.txt.
load "figures/style.gp"
set terminal svg size 760,340 dynamic font "sans,14" background "#ffffff"
set output "figures/23/23-signal.svg"
set multiplot layout 1,2 margins 0.1,0.97,0.2,0.95 spacing 0.12
set xlabel "time / {/:Italic T}"
set ylabel "{/:Italic C'} / {/:Italic σ}"
unset key
plot "figures/23/23-signal.txt" index 0 using 1:2 with lines linetype 1 \
         linewidth 1.2 title "step 0.02 T", \
     "" index 1 using 1:2 with linespoints linetype 2 pointtype 7 \
         pointsize 0.3 linewidth 1.2 title "step 0.2 T"
set key top right
set xlabel "lag / {/:Italic T}"
set ylabel "{/:Italic R}"
plot [0:5] "figures/23/23-signal.txt" index 2 using 1:4 with lines linetype 4 \
         title "exp(-τ/{/:Italic T})", \
     "" index 2 using 1:2 with points linetype 1 pointtype 7 pointsize 0.4 \
         title "step 0.02 T", \
     "" index 2 using 1:3 with points linetype 2 pointtype 6 pointsize 0.6 \
         title "step 0.2 T"
unset multiplot
