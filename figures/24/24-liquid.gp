# The drag on the grains of EW18's bed in a liquid, with resolved flow: what EW18
# figs. 6 to 12 show, from figures/24/24-liquid-8.txt, and fig. 13. Of another bed than the
# small one: gnuplot -e "bed = '-8-12'" figures/24/24-liquid.gp
load "figures/style.gp"
if (!exists("bed")) bed = ""
set terminal svg size 900,1160 dynamic font "sans,13" background "#ffffff"
set output "figures/24/24-liquid".bed.".svg"
table = "figures/24/24-liquid-8".bed.".txt"
set multiplot layout 4,2 margins 0.10,0.97,0.055,0.985 spacing 0.12,0.07
set xlabel "{/:Italic C}_d near one Re_p and ε"
set ylabel "probability density"
plot table index "[EW18 fig. 6] C_d, share" using 1:2 with boxes linetype 1 notitle
set xlabel "samples"
set ylabel "deviation of {/:Italic C}_d"
set yrange [0:*]
set logscale x
plot table index "[EW18 fig. 7] samples, mean of C_d, its deviation" using 1:3 with lines linetype 1 notitle
unset logscale x
set xlabel "Re_p"
set xrange [0:*]
set ylabel "{/:Italic C}_d"
bins = "[EW18 figs. 8-10] Re_p, eps, samples, mean of C_d, its deviation, that over the mean, C_d of Beetstra"
plot table index bins using 1:4 with linespoints linetype 1 pointtype 7 title "resolved, each line one ε", \
     table index bins using 1:7 with lines linetype 2 dashtype 2 title "Beetstra"
set ylabel "its deviation over {/:Italic C}_d"
set yrange [0:0.6]
plot table index bins using 1:6 with linespoints linetype 1 pointtype 7 notitle
set xrange [*:*]
set yrange [0:*]
set xlabel "force over weight"
set ylabel "probability density"
plot table index "[EW18 fig. 11] force over weight of the grains at one time, share" using 1:2 with histeps linetype 1 title "all, at one time", \
     table index "[EW18 fig. 11] the same of one grain over its path, share" using 1:2 with histeps linetype 2 title "one, over its path"
set yrange [-0.4:1]
set xlabel "τ [{/:Italic d}/{/:Italic u}_{in}]"
set ylabel "autocorrelation of the force"
plot table index "[EW18 figs. 12, 13] tau, autocorrelation of the force along the flow, its integral" using 1:2 with lines linetype 1 notitle, 0 linecolor "#555555" notitle
set key left top
set xrange [0:25]
set yrange [0:*]
set xlabel "Re of the mean flow"
set ylabel "integral time [{/:Italic d}/{/:Italic u}]"
# in the periodic boxes the unit of time is that of Re = 8
plot "figures/24/24-liquid-times".bed.".txt" using 1:2 with points linetype 1 pointtype 7 title "bed, to the first zero", \
     "figures/24/24-suspension.txt" using 5:($13*$5/8) with points linetype 2 pointtype 5 title "periodic boxes"
unset multiplot
