# SPDX-License-Identifier: GPL-3.0-or-later
# study.gp -- error against cost: gnuplot -c study.gp svg FILE    or png FILE
#
# A panel a measure, two of them one above the other, so that its letters can be read at
# half the width of a page. A line goes along the axis of the study; lines differ by the
# shape of their points and by their dashes, so that no colour is needed to tell them
# apart. The grey steps are the front: the least error that so much buys.
wide = panels > 2 ? 2 : 1
rows = (panels + wide - 1) / wide
size_x = 130.0 + 8.0 * (longest > 56 ? longest : 56)
size_y = 490.0 + 27.0 * (most + 1 + meanings + (along ne ''))
if (ARG1 eq 'png') {
    set terminal pngcairo size 2*wide*size_x, 2*rows*size_y font 'Sans,16' fontscale 2 linewidth 2 pointscale 2 background '#ffffff'
} else {
    set terminal svg size wide*size_x, rows*size_y dynamic font 'sans,16' background '#ffffff'
}
set output ARG2
set border 3 linecolor rgb '#555555'
set tics nomirror font ',14' textcolor rgb '#333333'
set grid linecolor rgb '#dddddd' linetype 1
set key outside bottom left horizontal Left reverse spacing 1.2 samplen 4 font ',14' noenhanced
set logscale xy
set format '%g'
set bars 0.6
# Shape, dashes and shade differ from line to line.
shades = '#0b3c5d #c2571a #3d7a3d #7a4a9a #222222 #b8860b #2a8a8a #a03060'
dashes = '1 2 4 3 1 2 4 3'; shapes = '7 5 9 13 6 4 8 12'
do for [i = 1:8] {
    set linetype i linecolor rgb word(shades, i) dashtype int(word(dashes, i)) pointtype int(word(shapes, i)) linewidth (i > 4 ? 1.4 : 2)
}
set linetype cycle 8
set pointsize 0.9

# The marks of an axis: decades; 1, 2, 5 of each where there are few of them; more where
# the range is narrow.
marks = '1 2 5 3 1.5 1.2 4 2.5 6 8'
first(low) = floor(log10(low))
last(high) = ceil(log10(high))
every(low, high) = last(high) - first(low) > 8 ? 2 : 1
many(low, high) = high < 3 * low ? 10 : high < 6 * low ? 5 : last(high) - first(low) <= 3 ? 3 : 1
set multiplot layout rows, wide title title noenhanced
set xlabel cost noenhanced
do for [p = 1:panels] {
    set title titles[p]."\n".errors[p].references[p] font ',15' noenhanced offset 0,-0.5
    set ylabel word(errors[p], 1).' [%]'
    set xrange [x_low[p] : x_high[p]]
    set yrange [y_low[p] : y_high[p]]
    set xtics () ; set ytics ()
    do for [d = first(x_low[p]):last(x_high[p]):every(x_low[p], x_high[p])] {
        do for [i = 1:many(x_low[p], x_high[p])] { set xtics add (10.0**d * word(marks, i)) }
    }
    do for [d = first(y_low[p]):last(y_high[p]):every(y_low[p], y_high[p])] {
        do for [i = 1:many(y_low[p], y_high[p])] { set ytics add (10.0**d * word(marks, i)) }
    }
    f = front[p]
    plot NaN with lines linetype nodraw title ' ', \
        $data index f using 1:2 with steps linecolor rgb '#cccccc' linewidth 6 dashtype 1 title 'least '.word(errors[p], 1).' for the cost', \
        for [i = 1:meanings] NaN with lines linetype nodraw title differ[i].(i < meanings ? ';' : ':'), \
        for [i = 1:lines[p]] $data index f+i using 1:($4 > $3 ? $2 : NaN):3:4 with yerrorbars linetype i dashtype 1 pointtype 0 notitle, \
        for [i = 1:lines[p]] $data index f+i using 1:2 with linespoints linetype i title columnheader(1), \
        for [i = 1:(along ne '')] NaN with lines linetype nodraw title 'beside the points: '.along, \
        for [i = 1:(labels[p] > 0)] $data index f+lines[p]+1 using 1:2:3 with labels center font ',13' textcolor rgb '#444444' noenhanced notitle
}
unset multiplot
