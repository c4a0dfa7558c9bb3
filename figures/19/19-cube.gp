# The cubic cavity beside the tables of Albensoeder and Kuhlmann, from
# figures/19/19-cube.txt.
load "figures/style.gp"
set output "figures/19/19-cube.svg"
set multiplot layout 1,2
part(re) = "< awk '/^## /{ on = $2 == \"re_" . re . \
    "\" } on && /^[0-9]/' figures/19/19-cube.txt"
set datafile separator whitespace
set key top left samplen 1 reverse Left
set xlabel "y at x = z = 1/2"
set ylabel "u over that of the lid"
table = "< grep '^[01]' figures/data/albensoeder-kuhlmann-2005.csv | tr , ' '"
plot part("100") using 1:2 with lines linetype 1 title "Re 100", \
     part("400") using 1:2 with lines linetype 2 title "Re 400", \
     part("1000") using 1:2 with lines linetype 3 title "Re 1000", \
     part("1000") using 1:4 with lines linetype 3 linecolor "#222222" dashtype (12,3,2,3) \
         title "its limit", \
     table using 1:2 with points pointtype 6 linetype 3 \
         title "Albensoeder et al."
set xlabel "x at y = z = 1/2"
set ylabel "v over the lid's u"
unset key
plot part("100") using 1:3 with lines linetype 1, \
     part("400") using 1:3 with lines linetype 2, \
     part("1000") using 1:3 with lines linetype 3, \
     part("1000") using 1:5 with lines linetype 3 linecolor "#222222" dashtype (12,3,2,3), \
     table using 3:4 with points pointtype 6 linetype 3
