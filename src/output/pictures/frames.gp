# SPDX-License-Identifier: GPL-3.0-or-later
dir = ARGC > 0 ? ARG1 : '..'
gif = ARGC > 1 ? ARG2 : dir.'/bed.gif'
tall = 600.0
wide = tall * (x1 - x0) / (y1 - y0)
if (wide > 900) { wide = 900.0; tall = wide * (y1 - y0) / (x1 - x0) }
page = wide + 190.0
if (page < 7 * strlen(title) + 40) { page = 7.0 * strlen(title) + 40 }   # room for the title
set terminal gif animate optimize delay 8 loop 0 size page, tall + 130 background '#ffffff'
set output gif
unit = (y1 - y0 < 1 && x1 - x0 < 1) ? 1e-3 : 1.0
mm = unit < 1 ? 'mm' : 'm'
set xrange [x0 / unit : x1 / unit]
set yrange [(turned ? y1 : y0) / unit : (turned ? y0 : y1) / unit]
set xlabel right_up[1:1].' ['.mm.']'; set ylabel right_up[2:2].' ['.mm.']'
set tics out nomirror
unset key
left = 0.5 * (page - wide)
set lmargin at screen left / page; set rmargin at screen (left + wide) / page
set bmargin at screen 60.0 / (tall + 130); set tmargin at screen (tall + 60.0) / (tall + 130)
set palette defined (0 '#440154', 1 '#472d7b', 2 '#3b528b', 3 '#2c728e', 4 '#21918c', 5 '#28ae80', 6 '#5ec962', 7 '#addc30', 8 '#fde725')
set cbrange [0 : fast]
set cblabel 'particle speed [m/s]'
least = 2.5 * (y1 - y0) / tall        # a lone particle would not be seen
do for [i = 1:words(times)] {
    set title sprintf("%s\nt = %s s", title, word(times, i)) noenhanced
    plot sprintf('frame_%05d.txt', i) \
        using ($1 / unit):($2 / unit):(($3 > least ? $3 : least) / unit):4 \
        with circles linecolor palette fillstyle solid 1 border linecolor rgb '#ffffff'
}
unset output
