# SPDX-License-Identifier: GPL-3.0-or-later
# page.gp -- what the pictures of a bed and of a flow have in common: a page of
# page_x by page_y pixels with the title, axes, and the colours of speeds.
sx(pixels) = pixels / page_x
sy(pixels) = pixels / page_y
set terminal pngcairo size page_x, page_y font 'Sans,12' background '#ffffff'
set output png
set encoding utf8
set multiplot
set border 15 linewidth 1 linecolor rgb ink
set tics textcolor rgb ink scale 0.6
unset key
set label 1 title at screen sx(left), sy(page_y - 34) font 'Sans,17' noenhanced textcolor rgb '#111111'

# Lengths in mm, or in m for what is larger than a metre; a round step.
unit = (y1 - y0 < 1 && x1 - x0 < 1) ? 1e-3 : 1.0
mm = unit < 1 ? 'mm' : 'm'
ten(x) = 10.0**floor(log10(x))
nice(x) = x <= 2 * ten(x) ? 2 * ten(x) : x <= 5 * ten(x) ? 5 * ten(x) : 10 * ten(x)
set xrange [x0 / unit : x1 / unit]
set yrange [(turned ? y1 : y0) / unit : (turned ? y0 : y1) / unit]   # turned: down is up
set xtics nice((x1 - x0) / unit / (wide / 80)) nomirror out
set ytics nice((y1 - y0) / unit / (tall / 70)) nomirror out

# Speeds in viridis.
set palette defined (0 '#440154', 1 '#472d7b', 2 '#3b528b', 3 '#2c728e', 4 '#21918c', 5 '#28ae80', 6 '#5ec962', 7 '#addc30', 8 '#fde725')
set cbrange [0 : fast]
set cbtics nice(fast / 5) scale 0.4 offset 0, 0.5
