# Force against overlap in a head-on impact, from figures/02/02-loops.txt.
load "figures/style.gp"
set output "figures/02/02-loops.svg"
data = "figures/02/02-loops.txt"
set xlabel "overlap [µm]"
set ylabel "force of the wall [N]"
set key top left
set xzeroaxis linetype 1 linecolor "#555555" linewidth 1
pick(law, e, y) = strcol(1) eq law && strcol(2) eq e ? y : 1/0
plot data using 3:(pick("linear", "1.0", $4)) with lines linetype 1 \
         title "linear, e = 1", \
     data using 3:(pick("linear", "0.5", $4)) with lines linetype 1 \
         dashtype 2 title "e = 0.5", \
     data using 3:(pick("hertz", "1.0", $4)) with lines linetype 2 \
         title "Hertz, e = 1", \
     data using 3:(pick("hertz", "0.5", $4)) with lines linetype 2 \
         dashtype 2 title "e = 0.5"
