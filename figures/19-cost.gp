# Error against processor time, from figures/19-cost.txt: convection schemes on
# three meshes, time schemes with five steps.
load "figures/style.gp"
set output "figures/19-cost.svg"
set multiplot layout 1,2
set logscale xy
set format x "10^{%T}"
set format y "10^{%T}"
set style data linespoints
set pointsize 0.6
set key bottom left samplen 2 reverse Left
set xlabel "processor time [s]"
set ylabel "error of u [-]"
rows(question, setting) = sprintf("< awk '$1 == \"%s\" && $2 == \"%s\" { print $6, $5 }' figures/19-cost.txt", question, setting)
set title "convection: 16, 32, 64 cells a side"
plot rows("convection", "upwind") title "upwind", \
     rows("convection", "blended") title "blended", \
     rows("convection", "linear") title "linear", \
     rows("convection", "van-leer") title "van Leer", \
     rows("convection", "second-upwind") title "second upwind"
set title "time: Courant number 4 to 0.25"
plot rows("time", "euler") title "Euler", \
     rows("time", "bdf2") title "BDF2"
