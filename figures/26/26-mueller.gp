# The Mueller bed in the loop: time averages across it on several meshes by
# diffusion and by pcm, from figures/26/26-mueller.txt, over what was measured.
load "figures/style.gp"
set terminal svg size 720,980 dynamic font "sans,13" background "#ffffff"
set output "figures/26/26-mueller.svg"
data = "figures/26/26-mueller.txt"
seen = "< grep '^measured' figures/data/mueller-2009.txt"
fields = "eps_f eps_f us_y us_y"
heights = "16.4 31.2 15 25"
names = "'void fraction, 16.4 mm' 'void fraction, 31.2 mm' \
    'velocity of spheres [m/s], 15 mm' 'velocity of spheres [m/s], 25 mm'"
of(mesh, method, k) = sprintf("< awk -v mesh=\"%s\" '$1 == \"at\" && \
    $2 == mesh && $3 == \"%s\" && $4 == \"%s\" && $5 == %s' %s", \
    mesh, method, word(fields, k), word(heights, k), data)
set multiplot
set xrange [0:44]
set xtics 0,10,40
do for [r = 0:1] {
    method = r == 0 ? "diffusion" : "pcm"
    do for [k = 1:4] {
        set lmargin at screen 0.08 + 0.49 * r
        set rmargin at screen 0.48 + 0.49 * r
        set tmargin at screen 0.965 - 0.24 * (k - 1)
        set bmargin at screen 0.795 - 0.24 * (k - 1)
        set title word(names, k) font "sans,13" offset 0,-0.5
        if (k > 2) { set yrange [-0.3:0.4] } else { set yrange [0.35:0.85] }
        if (k == 4) { set xlabel "x [mm]" } else { unset xlabel }
        unset label 1
        unset key
        if (k == 1) { set label 1 method at graph 0.03,0.93 font "sans,13" }
        if (k == 3) {
            set key top right samplen 2.5 spacing 1 maxrows 3 font "sans,12"
        }
        plot seen using (1000 * $4):(stringcolumn(2) eq word(fields, k) && \
                 $3 == real(word(heights, k)) ? $5 : 1/0) with points \
                 pointtype 6 pointsize 0.6 linecolor "#333333" \
                 title "measured", \
             of("A", method, k) using (1000 * $6):7 with lines \
                 linetype 4 linewidth 1.5 title "A", \
             of("B", method, k) using (1000 * $6):7 with lines \
                 linetype 3 linewidth 1.5 title "B", \
             of("B'", method, k) using (1000 * $6):7 with lines \
                 linetype 2 linewidth 1.5 title "B'", \
             of("C", method, k) using (1000 * $6):7 with lines \
                 linetype 1 linewidth 1.5 title "C", \
             of("D", method, k) using (1000 * $6):7 with lines \
                 linecolor "#c9a227" linewidth 1.5 dashtype (10,3,2,3,2,3) title "D"
    }
}
unset multiplot
