# What accuracy costs in a short bed, from figures/20-accuracy.txt.
load "figures/style.gp"
set output "figures/20-accuracy.svg"
set xlabel "processor time of a run [s]"
set ylabel "mean height of the grains [mm]"
set xrange [1:7.2]
set yrange [12.4:18.4]
set key top right maxrows 5
part(w) = sprintf("< sed -n 's/^\\(.*%s.*[a-z]\\)  *\\([0-9.]*  *[0-9.]*  *[0-9.]*\\)  *[0-9.]*  *[0-9.]*$/\"\\1\" \\2/p' figures/20-accuracy.txt", w)
set style data yerrorbars
set bars 0.5
plot part("fluid step") using 2:3:4 linetype 1 pointtype 7 pointsize 0.7 title "step of the fluid, 2e-3 to 5e-5 s", \
     part("particle step") using 2:3:4 linetype 4 pointtype 5 pointsize 0.7 title "step of the particles, 2e-5 and 5e-6 s", \
     "< grep -E '^(explicit|exponential|4 sub)' figures/20-accuracy.txt | sed 's/^4 sub-steps/sub-steps/'" using 2:3:4 linetype 3 pointtype 9 pointsize 0.8 title "explicit, exponential, 4 sub-steps", \
     "< grep -E 'mm |each cell' figures/20-accuracy.txt | grep -v '^[#$]' | sed 's/^\\([^0-9]*[0-9.]* mm\\|sums of each cell\\)/\"\\1\"/'" using 2:3:4 linetype 2 pointtype 11 pointsize 0.8 title "other averages", \
     "" using (strcol(1)[1:4] eq "bell" ? 1/0 : $2):3:1 with labels left offset 1.2,-0.5 textcolor "#c2571a" font "sans,11" notitle, \
     "" using (strcol(1)[1:4] eq "bell" ? $2 : 1/0):3:1 with labels left offset 1.2,0.5 textcolor "#c2571a" font "sans,11" notitle, \
     "< grep '^as the case' figures/20-accuracy.txt | sed 's/as the case has it/x/'" using 2:3:4 linecolor "#000000" pointtype 6 pointsize 1.3 linewidth 2 title "as the case has it"
