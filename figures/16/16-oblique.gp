# Oblique impacts of aluminium oxide on glass, from figures/16/16-oblique.txt, with
# the measurement of Kharaz et al. (2001).
load "figures/style.gp"
set output "figures/16/16-oblique.svg"
set terminal svg size 720,860
measured(what) = sprintf("< grep '^exp_mfix_digit,%s,' figures/data/kharaz2001_oblique_impact_exp.csv | cut -d, -f3,4 | tr , ' '", what)
set multiplot layout 3,1
set xrange [0:90]
set key left top
set ylabel "angle of the rebound [degrees]"
plot "figures/16/16-oblique.txt" index 0 using 1:2 with lines linetype 1 title "Hertz and Mindlin", \
     "" index 1 using 1:2 with lines linetype 3 dashtype 2 title "linear springs", \
     measured("rebound_angle_deg") using 1:2 with points pointtype 7 linecolor "#c2571a" title "measured"
set ylabel "v_t after / before"
set key left bottom
set yrange [0:1.05]
plot "figures/16/16-oblique.txt" index 0 using 1:3 with lines linetype 1 title "Hertz and Mindlin", \
     "" index 1 using 1:3 with lines linetype 3 dashtype 2 title "linear springs", \
     measured("e_t") using 1:2 with points pointtype 7 linecolor "#c2571a" title "measured"
set ylabel "spin [rad/s]"
set xlabel "angle of the impact, from the normal [degrees]"
set key right top
set yrange [0:700]
plot "figures/16/16-oblique.txt" index 0 using 1:4 with lines linetype 1 title "Hertz and Mindlin", \
     "" index 1 using 1:4 with lines linetype 3 dashtype 2 title "linear springs", \
     measured("omega_rad_per_s") using 1:2 with points pointtype 7 linecolor "#c2571a" title "measured"
unset multiplot
