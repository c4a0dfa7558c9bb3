# The force of a floor on a sphere that rolls over a seam, from
# figures/14/14-seam.txt.
load "figures/style.gp"
set output "figures/14/14-seam.svg"
set xlabel "behind the common edge [mm]"
set ylabel "force of the floor over the weight"
set xrange [-0.3:1.2]
set yrange [0:2.2]
set key top right
plot "<awk '/^## /{part=$2} part==\"once\"' figures/14/14-seam.txt" using ($1*1e3):2 with lines linetype 1 title "a place of the wall counts once", \
     "<awk '/^## /{part=$2} part==\"twice\"' figures/14/14-seam.txt" using ($1*1e3):2 with lines linetype 2 title "each triangle counts"
