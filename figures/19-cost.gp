# Error against processor time and against instructions, from
# figures/19-cost.txt: one figure a question.
load "figures/style.gp"
set terminal svg size 720,380 dynamic font "sans,13" background "#ffffff"
set linetype 5 linecolor "#777777" linewidth 2.5
set logscale xy
set format x "10^{%T}"
set format y "10^{%T}"
set style data linespoints
set pointsize 0.6
set key bottom left samplen 2 reverse Left
set ylabel "error of u [-]"
rows(question, settings, column) = sprintf("< awk '$1 == \"%s\" && $2 ~ /^(%s)$/ { print $%d, $5 }' figures/19-cost.txt", question, settings, column)
# The tolerances of one mesh.
mesh(n, column) = sprintf("< awk '$1 == \"tolerance\" && $3 == %d { print $%d, $5 }' figures/19-cost.txt", n, column)
x(column) = column == 6 ? "processor time [s]" : "instructions [-]"

set output "figures/19-cost-convection.svg"
set yrange [2e-5:1]
set multiplot layout 1,2 title "Convection: BDF2, Courant number 0.25; 16, 32, 64 cells a side"
do for [c = 6:7] {
    set xlabel x(c)
    plot rows("convection", "upwind", c) title "upwind", \
         rows("convection", "blended", c) title "blended", \
         rows("convection", "linear", c) title "linear", \
         rows("convection", "van-leer", c) title "van Leer", \
         rows("convection", "second-upwind", c) title "second upwind"
}
unset multiplot
set autoscale y
set key top right

set output "figures/19-cost-time.svg"
set multiplot layout 1,2 title "Time: linear, 64 cells a side; Courant number 4 to 0.25"
do for [c = 6:7] {
    set xlabel x(c)
    plot rows("time", "euler", c) title "Euler", rows("time", "bdf2", c) title "BDF2"
}
unset multiplot

set output "figures/19-cost-correctors.svg"
set key bottom left
set yrange [3e-4:5e-2]
set multiplot layout 1,2 title "Correctors: linear, BDF2, 48 cells a side; Courant number 4 to 0.5"
do for [c = 6:7] {
    set xlabel x(c)
    plot rows("correctors", "1", c) title "1", rows("correctors", "2", c) title "2", \
         rows("correctors", "3", c) title "3", rows("correctors", "4", c) title "4", \
         rows("correctors", "2-repeated", c) title "2, step repeated"
}
unset multiplot
set autoscale y
set key top right

set output "figures/19-cost-tolerance.svg"
set multiplot layout 1,2 title "Tolerance: linear, BDF2, Courant number 0.5; 10^{-1} to 10^{-8}"
do for [c = 6:7] {
    set xlabel x(c)
    plot mesh(24, c) title "24 cells a side", mesh(48, c) title "48 cells a side"
}
unset multiplot

set output "figures/19-cost-mesh.svg"
set multiplot layout 1,2 title "Mesh: linear, BDF2; 16 to 96 cells a side"
do for [c = 6:7] {
    set xlabel x(c)
    plot rows("mesh", "cfl-2", c) title "Courant number 2", \
         rows("mesh", "cfl-1", c) title "1", rows("mesh", "cfl-0.5", c) title "0.5"
}
unset multiplot
