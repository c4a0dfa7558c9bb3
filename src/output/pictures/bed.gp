# SPDX-License-Identifier: GPL-3.0-or-later
# gnuplot bed.gp                  in this folder: draws ../bed.png
# gnuplot -c bed.gp DIR PNG       draws the run in DIR to the file PNG
dir = ARGC > 0 ? ARG1 : '..'
png = ARGC > 1 ? ARG2 : dir.'/bed.png'

# Sizes [pixels]. The panels of the bed are true to scale.
tall = 720.0
wide = tall * (x1 - x0) / (y1 - y0)
if (wide > 560) { wide = 560.0; tall = wide * (y1 - y0) / (x1 - x0) }
if (wide < 60) { wide = 60.0; tall = wide * (y1 - y0) / (x1 - x0) }
if (tall > 1000) { tall = 1000.0; wide = tall * (x1 - x0) / (y1 - y0) }
roomy = wide > 250 ? wide : 250.0    # a colour bar needs some room
left = 90.0; gap = 60.0; below = 140.0; above = 105.0
shown = tall > 420 ? tall : 420.0
far = left + roomy + with_void * (roomy + gap)      # end of the bed's panels
page_x = far + (with_pressure ? 670.0 : 40.0)
if (page_x < 560) { page_x = 560.0 }
if (page_x < left + 12 * strlen(title) + 40) { page_x = left + 12.0 * strlen(title) + 40 }   # room for the title
page_y = below + shown + above
base = below + shown - tall          # the panels hang from the top

ink = '#333333'; pale = '#e2e2e2'
load 'page.gp'
set label 2 sprintf('t = %.3f s,  %d particle%s', time, particles, particles == 1 ? '' : 's') at screen sx(left), sy(page_y - 62) font 'Sans,12' textcolor rgb ink

set xlabel right_up[1:1].' ['.mm.']' offset 0, 0.4 textcolor rgb ink
set ylabel right_up[2:2].' ['.mm.']' offset 0.8, 0 textcolor rgb ink

# Particles, the nearer over the farther, in viridis; none smaller than 2.5
# pixels, or a lone one would not be seen.
least = 2.5 * (y1 - y0) / tall
set colorbox horizontal user origin sx(left), sy(base - 88) size sx(roomy), sy(12) bdefault
set cblabel 'particle speed [m/s]' offset 0, 0.9 textcolor rgb ink
set lmargin at screen sx(left); set rmargin at screen sx(left + wide)
set bmargin at screen sy(base); set tmargin at screen sy(base + tall)
plot dir.'/picture/particles.txt' using ($1 / unit):($2 / unit):(($3 > least ? $3 : least) / unit):4 \
    with circles linecolor palette linewidth 0.4 fillstyle solid 1 border linecolor rgb '#80ffffff'
if (with_walls) { plot dir.'/picture/walls.txt' using ($1 / unit):($2 / unit) with lines linewidth 2 linecolor rgb ink }
unset label

# Void fraction, cell by cell.
if (with_void) {
    at = left + roomy + gap
    set palette defined (0 '#2e1e3c', 1 '#413d7b', 2 '#37659e', 3 '#348fa7', 4 '#40b7ad', 5 '#8bdab2', 6 '#def5e5')
    set cbrange [0.3 : 1]
    set cbtics 0.2
    set colorbox horizontal user origin sx(at), sy(base - 88) size sx(roomy), sy(12)
    set cblabel 'mean void fraction over the depth [-]'
    set lmargin at screen sx(at); set rmargin at screen sx(at + wide)
    set format y ''; unset ylabel
    plot dir.'/picture/void_fraction.txt' using (0.5 * ($1 + $2) / unit):(0.5 * ($3 + $4) / unit):($1 / unit):($2 / unit):($3 / unit):($4 / unit):5 \
        with boxxyerror linecolor palette linewidth 0.6 fillstyle solid 1 border
    set format y '%h'
}

# Pressure drop in time beside what the bed weighs in the fluid.
if (with_pressure) {
    at = far + 140
    set datafile separator comma
    history = dir.'/history.csv'
    set xrange [*:*]; set yrange [*:*]
    stats history using 'time [s]' name 't' nooutput
    stats history using 'pressure_drop [Pa]' name 'drop' nooutput
    stats history using 'buoyant_weight [Pa]' name 'weight' nooutput
    late(t, drop) = t >= 0.5 * (t_min + t_max) ? drop : NaN
    stats history using (late(column('time [s]'), column('pressure_drop [Pa]'))) name 'late' nooutput
}
if (exists('late_mean')) {                          # there is a row
    set lmargin at screen sx(at); set rmargin at screen sx(page_x - 40)
    set bmargin at screen sy(below); set tmargin at screen sy(below + shown - 60)
    set xrange [t_min : t_max > t_min ? t_max : t_min + 1]
    # The weight and the second half are shown; of a jolt before, its size is told.
    most = late_max > weight_max ? late_max : weight_max
    top = drop_max > 2 * most && most > 0 ? 2 * most : 1.15 * (drop_max > most ? drop_max : most)
    bottom = drop_min < -most && late_min > -most ? -most : drop_min < 0 ? 1.15 * drop_min : 0
    beyond = (drop_max > top ? sprintf(' up to %.4g Pa', drop_max) : '').(drop_min < bottom ? sprintf(' down to %.4g Pa', drop_min) : '')
    if (strlen(beyond) > 0) { set label 'beyond the axes:'.beyond at graph 0.03, 0.96 textcolor rgb ink }
    set yrange [bottom : top > bottom ? top : bottom + 1]
    set format y '%h'
    set xtics nice((t_max > t_min ? t_max - t_min : 1.0) / 7); set ytics autofreq
    set grid linewidth 1 linecolor rgb pale dashtype 1
    set xlabel 'time [s]' offset 0, 0.4; set ylabel 'pressure drop [Pa]' offset -0.6, 0 textcolor rgb ink
    set key at screen sx(at - 4), sy(below + shown) left top Left reverse samplen 2.2 spacing 1.5 textcolor rgb ink
    plot history using 'time [s]':'pressure_drop [Pa]' with lines linewidth 1.3 linecolor rgb '#2c728e' \
             title sprintf('pressure drop; mean of the second half %.4g Pa', late_mean), \
         history using 'time [s]':'buoyant_weight [Pa]' with lines linewidth 2 dashtype (9, 5) linecolor rgb '#d1495b' \
             title sprintf('buoyant weight of the bed per area, %.4g Pa', weight_mean)
}
unset multiplot
unset output
