# Mueller's bed at 0.9 m/s over what was measured: with two bandwidths, and sediFoam; and in
# the shared form and in that with the whole drag, means of seeds with their errors.
load "figures/style.gp"
set terminal svg size 720,600 dynamic font "sans,13" background "#ffffff"
fields = "eps_f eps_f us_y us_y"
heights = "16.4 31.2 15 25"
names = "'void fraction, 16.4 mm' 'void fraction, 31.2 mm' \
    'velocity of spheres [m/s], 15 mm' 'velocity of spheres [m/s], 25 mm'"
of(name, k) = sprintf("< awk '$1 == \"from\" && $2 == \"%s\" && $3 == 1 && $4 == \"%s\" \
    && $5 == %s { print 1000 * $6, %s }' figures/27/27-mueller.txt", name, \
    k < 3 ? "eps_s" : "us_y", word(heights, k), k < 3 ? "1 - $7" : "$7")
wide(k) = sprintf("< awk '$1 == \"at\" && $2 == \"C\" && $3 == \"diffusion\" && \
    $4 == \"%s\" && $5 == %s { print 1000 * $6, $7 }' figures/26/26-mueller.txt", \
    word(fields, k), word(heights, k))
seen(who, k) = sprintf("< awk '$1 == \"%s\" && $2 == \"%s\" && $3 == %s && \
    ($1 == \"measured\" || ($4 > 0.0035 && $4 < 0.0405)) { print 1000 * $4, $5 }' \
    figures/data/mueller-2009.txt", who, word(fields, k), word(heights, k))
seeds(names, k) = sprintf("< python3 figures/27/27-compare.py mean %s %s %s \
    figures/27/27-forms.txt figures/27/27-mueller.txt", names, word(fields, k), word(heights, k))
do for [figure in "mueller forms"] {
set output "figures/27/27-" . figure . ".svg"
set multiplot
set xrange [0:44]
set xtics 0,10,40
do for [k = 1:4] {
    row = (k - 1) / 2
    if (row == 1) { set xlabel "x [mm]" } else { unset xlabel }
    set lmargin at screen 0.07 + 0.5 * ((k - 1) % 2)
    set rmargin at screen 0.48 + 0.5 * ((k - 1) % 2)
    set tmargin at screen 0.94 - 0.47 * row
    set bmargin at screen 0.6 - 0.47 * row
    set title word(names, k) font "sans,13"
    if (k > 2) { set yrange [-0.2:0.4] } else { set yrange [0.35:0.85] }
    if (k == 3) {
        set key top right samplen 2.5 spacing 1 maxrows 5 font "sans,12"
    } else { unset key }
    if (figure eq "forms") {
        plot seen("measured", k) with points pointtype 6 pointsize 0.6 \
                 linecolor "#333333" title "measured", \
             seeds("C-0.9-1,C-0.9-2,shared-2d+3", k) with yerrorlines linetype 1 pointsize 0.5 title "shared form", \
             seeds("whole-2d,whole-2d+2,whole-2d+3", k) with yerrorlines linetype 2 dashtype 1 pointsize 0.5 title "as printed"
        continue
    }
    plot seen("measured", k) with points pointtype 6 pointsize 0.6 \
             linecolor "#333333" title "measured", \
         seen("sediFoam", k) with lines linecolor "#999999" dashtype 2 \
             linewidth 1.5 title "sediFoam", \
         wide(k) with lines linetype 2 linewidth 1.5 title "b = 4 d", \
         of("C-0.9-1", k) with lines linetype 1 linewidth 1.5 \
             title "b = 2 d, seed 1", \
         of("C-0.9-2", k) with lines linetype 3 linewidth 1.5 title "seed 2"
}
unset multiplot
}
