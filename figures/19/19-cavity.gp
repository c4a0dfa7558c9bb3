# The lid-driven cavity beside the tables of Ghia, from figures/19/19-cavity.txt.
load "figures/style.gp"
set output "figures/19/19-cavity.svg"
set multiplot layout 1,2
part(re) = "< awk '/^## /{ on = $2 == \"re_" . re . \
    "\" } on && /^[0-9]/' figures/19/19-cavity.txt"
set datafile separator whitespace
set key top left samplen 1 reverse Left
set xlabel "y at x = 1/2"
set ylabel "u over that of the lid"
u = "< grep '^[01]' figures/data/ghia-1982-u.csv | tr , ' '"
v = "< grep '^[01]' figures/data/ghia-1982-v.csv | tr , ' '"
plot part("100") using 1:2 with lines linetype 1 title "Re 100", \
     part("400") using 1:2 with lines linetype 2 title "Re 400", \
     part("1000") using 1:2 with lines linetype 3 title "Re 1000", \
     u using 1:2 with points pointtype 6 linetype 1 title "Ghia et al.", \
     u using 1:3 with points pointtype 6 linetype 2 notitle, \
     u using 1:4 with points pointtype 6 linetype 3 notitle
set xlabel "x at y = 1/2"
set ylabel "v over the lid's u"
unset key
plot part("100") using 1:3 with lines linetype 1, \
     part("400") using 1:3 with lines linetype 2, \
     part("1000") using 1:3 with lines linetype 3, \
     v using 1:2 with points pointtype 6 linetype 1, \
     v using ($1 == 0.9063 ? 1/0 : $1):3 with points pointtype 6 linetype 2, \
     v using 1:4 with points pointtype 6 linetype 3
