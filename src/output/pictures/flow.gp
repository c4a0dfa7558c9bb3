# SPDX-License-Identifier: GPL-3.0-or-later
# gnuplot bed.gp                  in this folder: draws ../bed.png
# gnuplot -c bed.gp DIR PNG       draws the run in DIR to the file PNG
dir = ARGC > 0 ? ARG1 : '..'
png = ARGC > 1 ? ARG2 : dir.'/bed.png'

# Sizes [pixels]. The panels are true to scale: side by side, or below each
# other where they are wide.
below_each_other = (x1 - x0) > 1.4 * (y1 - y0)
wide = below_each_other ? 900.0 : 420.0
tall = wide * (y1 - y0) / (x1 - x0)
if (tall > 640) { tall = 640.0; wide = tall * (x1 - x0) / (y1 - y0) }
if (tall < 40) { tall = 40.0 }
roomy = wide > 250 ? wide : 250.0
left = 90.0; gap = below_each_other ? 120.0 : 90.0; below = 120.0; above = 95.0
page_x = left + (below_each_other ? roomy : 2 * roomy + gap) + 40
page_y = below + (below_each_other ? 2 * tall + gap : tall) + above
if (page_x < 560) { page_x = 560.0 }

ink = '#333333'
load 'page.gp'
set label 2 sprintf('t = %.3f s', time) at screen sx(left), sy(page_y - 62) font 'Sans,12' textcolor rgb ink
set xlabel right_up[1:1].' ['.mm.']' offset 0, 0.4
set ylabel right_up[2:2].' ['.mm.']' offset 0.8, 0 textcolor rgb ink

# Speed, and streamlines over it.
base = below + (below_each_other ? tall + gap : 0)
set colorbox horizontal user origin sx(left), sy(base - 66) size sx(roomy), sy(10) bdefault
set cblabel 'speed [m/s]' offset 0, 0.9 textcolor rgb ink
set lmargin at screen sx(left); set rmargin at screen sx(left + wide)
set bmargin at screen sy(base); set tmargin at screen sy(base + tall)
plot dir.'/picture/flow.txt' using ($1 / unit):($2 / unit):3 with image, \
     dir.'/picture/streamlines.txt' using ($1 / unit):($2 / unit) with lines linewidth 0.8 linecolor rgb '#90ffffff'
unset label

# Pressure.
at = below_each_other ? left : left + roomy + gap
set palette defined (0 '#2166ac', 1 '#92c5de', 2 '#f7f7f7', 3 '#f4a582', 4 '#b2182b')
set cbrange [low : high]
set cbtics nice((high - low) / 5)
set colorbox horizontal user origin sx(at), sy(below - 66) size sx(roomy), sy(10) bdefault
set cblabel 'pressure [Pa]' offset 0, 0.9 textcolor rgb ink
set lmargin at screen sx(at); set rmargin at screen sx(at + wide)
set bmargin at screen sy(below); set tmargin at screen sy(below + tall)
plot dir.'/picture/flow.txt' using ($1 / unit):($2 / unit):4 with image
unset multiplot
unset output
