# The Mueller bed in the loop: time averages on several meshes by diffusion and by pcm,
# across the bed over what was measured, and along its height, from figures/26/26-mueller.txt.
load "figures/style.gp"
set terminal svg size 720,980 dynamic font "sans,13" background "#ffffff"
data = "figures/26/26-mueller.txt"
seen = "< grep '^measured' figures/data/mueller-2009.txt"
fields = "eps_f eps_f us_y us_y"
of(kind, mesh, method, k, where) = sprintf("< awk -v mesh=\"%s\" '$1 == \"%s\" && \
    $2 == mesh && $3 == \"%s\" && $4 == \"%s\" && $5 == %s' %s", \
    mesh, kind, method, word(fields, k), where, data)
do for [page = 0:1] {
    set output word("figures/26/26-mueller.svg figures/26/26-mueller-up.svg", page + 1)
    kind = word("at up", page + 1)
    places = page == 0 ? "16.4 31.2 15 25" : "11 22 11 22"
    set xrange [0:(page == 0 ? 44 : 80)]
    set xtics 0,(page == 0 ? 10 : 20),80
    set multiplot
    do for [r = 0:1] {
        method = r == 0 ? "diffusion" : "pcm"
        do for [k = 1:4] {
            set lmargin at screen 0.08 + 0.49 * r
            set rmargin at screen 0.48 + 0.49 * r
            set tmargin at screen 0.965 - 0.24 * (k - 1)
            set bmargin at screen 0.795 - 0.24 * (k - 1)
            set title (k < 3 ? "void fraction, " : "velocity of spheres [m/s], ") . \
                (page == 0 ? "" : "x = ") . word(places, k) . " mm" \
                font "sans,13" offset 0,-0.5
            if (k > 2) { set yrange [-0.3:0.4] } else { set yrange [0.35:(page == 0 ? 0.85 : 1)] }
            if (k == 4) { set xlabel (page == 0 ? "x [mm]" : "height [mm]") } else { unset xlabel }
            unset label 1
            unset key
            if (k == 1) { set label 1 method at graph 0.03,0.93 font "sans,13" }
            if (k == 3) {
                set key top right samplen 2.5 spacing 1 maxrows 3 font "sans,12"
            }
            plot seen using (1000 * $4):(page == 0 && stringcolumn(2) eq word(fields, k) && \
                     $3 == real(word(places, k)) ? $5 : 1/0) with points \
                     pointtype 6 pointsize 0.6 linecolor "#333333" \
                     title page == 0 ? "measured" : "", \
                 of(kind, "A", method, k, word(places, k)) using (1000 * $6):7 with lines \
                     linetype 4 linewidth 1.5 title "A", \
                 of(kind, "B", method, k, word(places, k)) using (1000 * $6):7 with lines \
                     linetype 3 linewidth 1.5 title "B", \
                 of(kind, "B'", method, k, word(places, k)) using (1000 * $6):7 with lines \
                     linetype 2 linewidth 1.5 title "B'", \
                 of(kind, "C", method, k, word(places, k)) using (1000 * $6):7 with lines \
                     linetype 1 linewidth 1.5 title "C", \
                 of(kind, "D", method, k, word(places, k)) using (1000 * $6):7 with lines \
                     linecolor "#c9a227" linewidth 1.5 dashtype (10,3,2,3,2,3) title "D"
        }
    }
    unset multiplot
    unset output
}
