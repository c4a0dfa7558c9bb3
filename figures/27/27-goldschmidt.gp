# Mean height of the spheres of Goldschmidt's bed from the lattice on, and the pressure drop,
# by DPMFoam and by winnow with two forms of the equations.
load "figures/style.gp"
set terminal svg size 720,560 dynamic font "sans,13" background "#ffffff"
set output "figures/27/27-goldschmidt.svg"
data = "< grep -v '^#' figures/27/27-goldschmidt.txt"
set multiplot layout 2,1
set xrange [0:0.4]
set ylabel "mean height [mm]"
set key top center
plot data using 1:2 with points linetype 1 pointtype 6 pointsize 0.5 title "DPMFoam", \
     data using 1:3 with lines linetype 2 title "winnow, whole drag", \
     data using 1:4 with lines linetype 3 title "winnow, pressure gradient"
set xlabel "time [s]"
set ylabel "pressure drop [Pa]"
unset key
plot data using 1:5 with points linetype 1 pointtype 6 pointsize 0.5, \
     data using 1:6 with lines linetype 2, \
     data using 1:7 with lines linetype 3
unset multiplot
