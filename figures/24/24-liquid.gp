# The drag on the grains of EW18's two beds, with resolved flow: what EW18 figs. 6 to 13
# show, from figures/24/24-liquid-8.txt (the small bed in a liquid) and 24-gas-22.txt (a
# periodic box in the gas). Of another bed than the small one:
# gnuplot -e "bed = '-8-12'" figures/24/24-liquid.gp
load "figures/style.gp"
if (!exists("bed")) bed = ""
set terminal svg size 900,1450 dynamic font "sans,13" background "#ffffff"
set output "figures/24/24-liquid".bed.".svg"
liquid = "figures/24/24-liquid-8".bed.".txt"
gas = "figures/24/24-gas-22.txt"
laws = "[EW18 fig. 6] C_d of a law, its name"
bins = "[EW18 figs. 8-10] Re_p, eps, samples, mean of C_d, its deviation, that over the mean, C_d of Beetstra"
lags = "[EW18 figs. 12, 13] tau, autocorrelation of the force along the flow, its integral"
array files[2] = [liquid, gas]
array names[2] = ["liquid", "gas"]
set multiplot layout 5,2 margins 0.10,0.975,0.045,0.975 spacing 0.13,0.07
set yrange [0:*]
do for [f = 1:2] {
    set title names[f]." (Fig. 6)"
    set xlabel "{/:Italic C}_d near one Re_p and ε"
    set ylabel "probability density"
    set xrange [0:*]
    set key top right samplen 1.5
    stats files[f] index "[EW18 fig. 6] C_d, share" using 2 nooutput
    plot files[f] index "[EW18 fig. 6] C_d, share" using 1:2 with histeps linetype 1 title "resolved", \
         "" index laws using 1:(strcol(2) eq "beetstra" ? 0 : 1/0):(0):(STATS_max) with vectors nohead linetype 2 title "Beetstra", \
         "" index laws using 1:(strcol(2) eq "huilin-gidaspow" ? 0 : 1/0):(0):(STATS_max) with vectors nohead linetype 3 title "Huilin, Gidaspow", \
         "" index laws using 1:(strcol(2) eq "di-felice-printed" ? 0 : 1/0):(0):(STATS_max) with vectors nohead linetype 4 title "Di Felice, as printed"
}
set xrange [*:*]
set logscale x
do for [f = 1:2] {
    set title names[f]." (Fig. 7)"
    set xlabel "samples"
    set ylabel "{/:Italic C}_d"
    set key center right
    plot files[f] index "[EW18 fig. 7] samples, mean of C_d, its deviation" using 1:2 with lines linetype 1 title "mean", \
         "" index "[EW18 fig. 7] samples, mean of C_d, its deviation" using 1:3 with lines linetype 2 title "deviation"
}
unset logscale x
set key top right
do for [f = 1:2] {
    set title names[f]." (Fig. 8)"
    set xlabel "Re_p"
    set xrange [0:*]
    set ylabel "{/:Italic C}_d"
    plot files[f] index bins using 1:4 with linespoints linetype 1 pointtype 7 title "resolved, each line one ε", \
         "" index bins using 1:7 with lines linetype 2 dashtype 2 title "Beetstra"
}
set title "deviation of {/:Italic C}_d over its mean (Figs. 9, 10)"
unset ylabel
set yrange [0:0.6]
plot liquid index bins using 1:6 with linespoints linetype 1 pointtype 7 title "liquid", \
     gas index bins using 1:6 with linespoints linetype 2 pointtype 5 title "gas"
set title "liquid (Fig. 11)"
set yrange [0:*]
set xlabel "force over weight"
set ylabel "probability density"
plot liquid index "[EW18 fig. 11] force over weight of the grains at one time, share" using 1:2 with histeps linetype 1 title "all, at one time", \
     "" index "[EW18 fig. 11] the same of one grain over its path, share" using 1:2 with histeps linetype 2 title "one, over its path"
set title "both (Fig. 12)"
set yrange [-0.6:1]
set xlabel "τ [{/:Italic d}/{/:Italic u}_{in}]"
set ylabel "autocorrelation of the force"
plot liquid index lags using 1:2 with lines linetype 1 title "liquid", \
     gas index lags using 1:2 with lines linetype 2 title "gas", 0 linecolor "#555555" notitle
set title "liquid (Fig. 13)"
set xrange [0:25]
set yrange [0:3]
set xlabel "Re of the mean flow"
set ylabel "integral time [{/:Italic d}/{/:Italic u}]"
times = "figures/24/24-liquid-times".bed.".txt"
stats times using 1:2 nooutput
# in the periodic boxes the unit of time is that of Re = 8
plot times using 1:2 with points linetype 1 pointtype 7 title "bed, to the first zero", \
     [3:12] STATS_intercept + STATS_slope * x with lines linetype 1 linewidth 1 title "a line through these", \
     "figures/24/24-liquid-times-8-8.txt" using 1:2 with points linetype 3 pointtype 9 title "bed twice as wide", \
     "" using 1:3 with points linetype 3 pointtype 8 title "the same, mean from 4 to 5", \
     "figures/24/24-suspension.txt" using 5:($13*$5/8) with points linetype 2 pointtype 5 title "periodic boxes"
unset multiplot
