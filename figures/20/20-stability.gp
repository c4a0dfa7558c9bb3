# Where each treatment of drag is stable: figures/20/20-suspension.txt, 20-one.txt,
# 20-bed.txt. Lines: where theory puts the edge.
load "figures/style.gp"
set terminal svg size 900,800 dynamic font "sans,14" background "#ffffff"
set output "figures/20/20-stability.svg"
set multiplot layout 3,4 margins 0.11,0.99,0.17,0.94 spacing 0.015,0.03
set logscale xy
set xrange [0.05:2e4]
set yrange [4e-4:2.5e3]
set ytics 1e-3, 1000
set xtics 0.1, 10
set format "10^{%T}"
unset key
eps = 0.45
c = 1/eps**2 - 1
swing = ((1 - eps)/eps)**2
set samples 300
coth(x) = (1 + exp(-x))/(1 - exp(-x))
frozen(x) = x < 2 ? 2/x - 1 : 1/0
late(x) = x > 0.5 && x < 2 ? (2 - x)/(x*(2*x - 1)) : 1/0
systems = "suspension one bed"
shown = "suspension one-sphere bed"
treatments = "explicit-frozen explicit-exponential semi-implicit-frozen semi-implicit-exponential"
do for [r = 1:3] {
    do for [k = 1:4] {
        name = word(treatments, k)
        file = "figures/20/20-" . word(systems, r) . ".txt"
        of(v) = sprintf("< awk '$1 == \"%s\" && $4 == \"%s\" {print $2, $3}' %s", name, v, file)
        set title (r == 1 ? name : "") offset 0,-0.6 noenhanced
        if (k == 1) { set ylabel word(shown, r) . "\nmass loading M"; set format y "10^{%T}" } else { unset ylabel; set format y "" }
        if (r == 3) { set xlabel "step / relaxation time"; set format x "10^{%T}" } else { unset xlabel; set format x "" }
        unset arrow
        if (r == 3 && k == 4) { # once: the key
            set label 1 "•" at screen 0.11,0.06 font ",24" textcolor "#0b5a8a"
            set label 2 "stable" at screen 0.13,0.06
            set label 3 "△" at screen 0.24,0.06 textcolor "#b98200"
            set label 4 "oscillates" at screen 0.26,0.06
            set label 5 "×" at screen 0.50,0.06 font ",18" textcolor "#c2571a"
            set label 6 "diverges" at screen 0.52,0.06
            set label 7 "○" at screen 0.64,0.06 textcolor "#0b5a8a"
            set label 8 "slower than it should be" at screen 0.66,0.06
            set label 9 "lines: the limits of stability by theory" at screen 0.11,0.025
        }
        edge = (k % 2 == 1) ? 2*eps**2 : log((1 + c)/(c - 1))
        if (r == 3) {
            set arrow 1 from edge, swing to edge, (k < 3 && k % 2 == 1 ? 2/edge : 2.5e3) nohead linecolor "#000000" linewidth 1.5 front
            set arrow 2 from 0.05, swing to edge, swing nohead linecolor "#000000" linewidth 1.5 front
        }
        curve(x) = r < 3 ? (k == 1 ? frozen(x) : k == 2 ? coth(x/2) : k == 3 ? late(x) : 1/0) : (k == 1 && x < edge ? 2/x : 1/0)
        plot of("diverged") using 2:1 with points pointtype 2 pointsize 0.6 linecolor "#c2571a" linewidth 1.2, \
             of("oscillating") using 2:1 with points pointtype 8 pointsize 0.8 linecolor "#b98200", \
             of("sluggish") using 2:1 with points pointtype 6 pointsize 0.8 linecolor "#0b5a8a" linewidth 1.2, \
             of("stable") using 2:1 with points pointtype 7 pointsize 0.8 linecolor "#0b5a8a", \
             curve(x) with lines linecolor "#000000" linewidth 1.5
    }
}
unset multiplot
