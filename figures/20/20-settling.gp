# What accuracy costs for a settling sphere, from figures/20/20-settling.txt.
load "figures/style.gp"
set terminal svg size 860,380 dynamic font "sans,13" background "#ffffff"
set output "figures/20/20-settling.svg"
set multiplot layout 1,2
set logscale xy
set format y "10^{%T}"
set ylabel "error of the velocity [-]"
set xlabel "step of the fluid / τ_p"
set xrange [0.04:3]
set yrange [3e-4:2]
set key bottom right
s = "< sed -n '/^## steps/,/^## cells/p' figures/20/20-settling.txt | awk 'NF == 6 && /^ *[0-9]/'"
plot s using 2:4 with linespoints pointtype 7 pointsize 0.6 linetype 2 title "frozen", \
     s using 2:5 with linespoints pointtype 7 pointsize 0.6 linetype 4 title "sub-steps of 0.5 ms", \
     s using 2:6 with linespoints pointtype 7 pointsize 0.6 linetype 1 title "exponential"
set xlabel "width of a cell / d"
set xrange [4:300]
set yrange [1e-5:0.3]
set key top right
c = "< sed -n '/^## cells/,$p' figures/20/20-settling.txt | awk 'NF == 4 && /^ *[0-9]/'"
plot c using 1:2 with linespoints pointtype 7 pointsize 0.6 linetype 2 title "PCM", \
     c using 1:3 with linespoints pointtype 7 pointsize 0.6 linetype 4 title "diffusion, 4 d", \
     c using 1:4 with linespoints pointtype 7 pointsize 0.6 linetype 1 title "diffusion, 16 d"
unset multiplot
