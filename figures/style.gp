# The look that all figures share: load "figures/style.gp" first.
set terminal svg size 720,430 dynamic font "sans,14" background "#ffffff"
set border 3 linecolor "#555555"
set tics nomirror textcolor "#333333"
set grid linecolor "#dddddd" linetype 1
set key noopaque spacing 1.2
set datafile commentschars "#$"
# Lines differ in their dashes and marks as well, for readers who do not see colours.
set linetype 1 linecolor "#0b5a8a" linewidth 2.5 dashtype 1 pointtype 7
set linetype 2 linecolor "#c2571a" linewidth 2.5 dashtype (16,5) pointtype 5
set linetype 3 linecolor "#3d7a3d" linewidth 2.5 dashtype (4,3) pointtype 9
set linetype 4 linecolor "#7a4a9a" linewidth 2.5 dashtype (14,4,3,4) pointtype 13
