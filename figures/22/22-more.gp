# The bead, the spin, the cloud and the channel of the chapter on further forces,
# from figures/22/22-scenes.txt and figures/22/22-carry.txt.
load "figures/style.gp"
set terminal svg size 900,640 dynamic font "sans,13" background "#ffffff"
set output "figures/22/22-more.svg"
set multiplot layout 2,2
part(p) = sprintf("< awk '/^## /{p = ($2 == \"%s\")} p && /^ *[0-9-]/' figures/22/22-scenes.txt", p)
b = part("bead")
set title "a bead of foam in water"
set xlabel "t [ms]"
set ylabel "v upwards [m/s]"
set yrange [-0.06:0.84]
set key top right
plot b using 1:2 with lines linetype 1 title "with both", \
     b using 1:3 with lines linetype 2 title "no virtual mass", \
     b using 1:4 with lines linetype 4 title "no buoyancy", \
     [0:12] 14.715e-3 * x with lines linecolor "#000000" linewidth 1 dashtype 2 title "1.5 g"
t = part("turn")
set title "a spinning grain in water"
set ylabel "omega / omega_0"
set yrange [0:1.05]
set key at 4, 0.85 right top
plot t using 1:2 with points pointtype 7 pointsize 0.6 linecolor "#0b5a8a" title "with torque", \
     t using 1:3 with lines linetype 2 title "without", \
     t using 1:4 with lines linecolor "#000000" linewidth 1 title "exact"
c = part("cloud")
set title "a cloud of beads in oil"
set xlabel "t [s]"
set ylabel "fall [mm/s]"
set yrange [0:34]
set key at 0.59, 23 right top
plot c using 1:2 with lines linetype 2 title "one-way", \
     c using 1:3 with lines linetype 1 title "two-way", \
     c using 1:4 with points pointtype 6 pointsize 0.8 linecolor "#000000" title "four-way"
set title "a bead that oil carries along a channel"
set ylabel "ahead of the oil [μm/s]"
set yrange [-16:28]
set key at 0.59, 16 right top
c = "< grep '^[0-9]' figures/22/22-carry.txt"
plot c using 1:3 with lines linetype 1 title "pressure and stress", \
     c using 1:4 with lines linetype 2 title "no stress", \
     c using 1:5 with lines linetype 4 title "neither"
unset multiplot
