# SX15 Figs. 8 and 9: moments of Mueller's bed by diffusion (above) and by the sums of
# each cell (below), from the files in dir, which figures/26/26-snapshots.sh makes.
method(r) = word("diffusion pcm", r + 1)
points(r) = dir . method(r) . "-points.txt"
field(r) = dir . method(r) . "-field.txt"
set border 0
unset tics
unset key
set xrange [0:44]
set yrange [0:66]
do for [what = 0:1] {
    # The line eps_s = 0.28 of each moment.
    if (what == 0) {
        set contour base
        set cntrparam levels discrete 0.28
        unset surface
        do for [r = 0:1] { do for [k = 0:7] {
            set table sprintf("%s%s-line-%d.txt", dir, method(r), k)
            splot field(r) index k using 1:2:3
            unset table
        } }
        unset contour
        set surface
    }
    set terminal png size 1000,470 background "#ffffff"
    set output word("figures/26/26-snapshots-grains.png figures/26/26-snapshots-fields.png", what + 1)
    set multiplot
    set palette defined (0 "#ffffff", 0.3 "#9fc3d9", 0.62 "#0b3c5d")
    set cbrange [0:0.65]
    unset colorbox
    do for [r = 0:1] { do for [k = 0:7] {
        set lmargin at screen 0.035 + 0.1205 * k
        set rmargin at screen 0.035 + 0.1205 * k + 0.116
        set bmargin at screen 0.52 - 0.5 * r
        set tmargin at screen 0.52 - 0.5 * r + 0.37
        set title sprintf("%.2f s", 0.2 + 0.04 * k) offset 0,-0.7
        set label 1 k == 0 ? method(r) : "" at graph -0.14,0.5 center rotate by 90 font "Sans,12"
        set object 1 rectangle from 0,0 to 44,66 fillstyle empty border linecolor "#999999"
        if (what == 0) {
            plot points(r) index k using 1:2 with points pointtype 7 pointsize 0.22 \
                     linecolor "#6b8fa5", \
                 sprintf("%s%s-line-%d.txt", dir, method(r), k) using 1:2 with lines \
                     linecolor "#c2571a" linewidth 2
        } else {
            plot field(r) index k using 1:2:3 with image pixels
        }
    } }
    unset multiplot
    unset output
}
