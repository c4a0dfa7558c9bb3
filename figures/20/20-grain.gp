# A grain taken along by water, from figures/20/20-grain.txt; XS11 Fig. 8, (b) and (a).
load "figures/style.gp"
set terminal svg size 760,760 dynamic font "sans,14" background "#ffffff"
set output "figures/20/20-grain.svg"
set multiplot layout 2,1 margins 0.12,0.97,0.08,0.98 spacing 0,0.1
set xlabel "t [ms]"
set ylabel "velocity of the grain [m/s]"
set yrange [-0.05:0.17]
set key at 6.8, 0.165 right top
g = "< awk 'NF == 6 && /^[0-9]/' figures/20/20-grain.txt"
plot g using (1e3*$1):2 with linespoints pointtype 7 pointsize 0.6 linetype 2 title "no sub-steps", \
     g using (1e3*$1):3 with linespoints pointtype 7 pointsize 0.6 linetype 4 title "2 sub-steps", \
     g using (1e3*$1):4 with points pointtype 6 pointsize 1.1 linecolor "#0b5a8a" linewidth 2 title "50 sub-steps", \
     g using (1e3*$1):5 with points pointtype 2 pointsize 0.9 linecolor "#3d7a3d" linewidth 2 title "1, exponential", \
     "< sed -n '/^## exact/,/^## euler/p' figures/20/20-grain.txt | grep '^0'" using (1e3*$1):2 with lines linecolor "#000000" linewidth 1 title "exact", \
     "figures/data/xiao-sun-2011-case3.txt" using (1e3*$1):2 with points pointtype 4 pointsize 0.6 linecolor "#777777" title "XS11 Fig. 8"
set xrange [0:6.6]
set key at 6.5, 0.165 right top
euler = "< awk '/^## euler/ { on = 1 } on && /^[0-9]/ { for (i = 2; i <= NF; i++) print (i - 2) * $1, $i; print \"\\n\" }' figures/20/20-grain.txt"
plot for [i = 0:3] euler index i using 1:2 with linespoints pointsize 0.6 linetype word("3 1 4 2", i + 1) + 0 \
         title "forward Euler, step " . word("0.25 0.5 0.75 1.1", i + 1) . " ms", \
     "< sed -n '/^## exact/,/^## euler/p' figures/20/20-grain.txt | grep '^0'" using (1e3*$1):2 with lines linecolor "#000000" linewidth 1 title "exact"
unset multiplot
