# EW18's liquid bed at four inlet velocities, a column each: fluid fraction against height
# (their Fig. 15) and the agitation in time along the flow and across it (Figs. 16, 17), by
# three ways, from figures/23/23-liquid-profile.txt and -series.txt: blocks by way (cube,
# gauss, random), and in each by the Reynolds number; and the small bed of resolved grains,
# which ends at 8 d / u, where figures/24/24-liquid-RE.txt has these blocks
# (END=8 sh tests/validate/resolved-bed.sh build/winnow 4 6 8 11).
load "figures/style.gp"
set terminal svg size 1100,860 dynamic font "sans,13" background "#ffffff"
set output "figures/23/23-liquid.svg"
profile = "figures/23/23-liquid-profile.txt"
series = "figures/23/23-liquid-series.txt"
resolved(re) = system("grep -l 'EW18 fig. 15' figures/24/24-liquid-" . re . ".txt")
re = "4 6 8 11"
ways = "'BC-0.6' 'GK-1' 'GK-1, random part'"
colours = "3 1 2"
part(i) = word(colours, i + 1) + 0
set multiplot layout 3,4 margins 0.07,0.985,0.07,0.95 spacing 0.045,0.085
do for [c = 1:4] {
    set title "Re_{in} = " . word(re, c)
    set xlabel "height [{/:Italic d}]"
    set xrange [0:15]
    set yrange [0.4:1]
    if (c == 1) { set ylabel "fluid fraction" } else { unset ylabel }
    if (c == 4) { set key at 13.5,0.62 right top samplen 1.5 font "sans,10" spacing 0.9 noopaque } else { unset key }
    plot for [i = 0:2] profile index 4 * i + c - 1 using 1:2 with lines linetype part(i) linewidth 1.5 title word(ways, i + 1), \
         for [file in resolved(word(re, c))] file index "[EW18 fig. 15] height, fluid fraction" using 1:2 with points linetype 4 pointsize 0.6 title "resolved, small bed"
}
unset title
unset key
set xlabel "time [{/:Italic d / u}_{in}]"
set xrange [0:150]
do for [k = 2:3] {
    do for [c = 1:4] {
        if (c == 1) { set ylabel (k == 2 ? "root of {/:Italic T} along the flow" : "the same across it") } else { unset ylabel }
        set yrange [0:(k == 2 ? 0.8 : 0.4)]
        plot for [i = 0:2] series index 4 * i + c - 1 using 1:(sqrt(column(k))) with lines linetype part(i) linewidth 1, \
             for [file in resolved(word(re, c))] file index "[EW18 figs. 16, 17] time, granular temperature along the flow, across it" \
                 using 1:(sqrt(column(k))) with lines linetype 4 linewidth 2
    }
}
unset multiplot
