# Velocity of a suspension over that of one sphere, by each drag law, on three sizes.
load "figures/style.gp"
set terminal svg size 720,460 dynamic font "sans,13" background "#ffffff"
set output "figures/27/27-settling.svg"
laws = "syamlal-obrien gidaspow di-felice beetstra hill-koch-ladd tenneti rong cello"
sizes = "0.1 0.5 2.0"
data = "figures/27/27-settling.txt"
of(law, d) = sprintf("< awk '$1 == \"%s\" && $2 == %s { print $4, $5 }' %s", law, d, data)
Re(d) = real(system(sprintf("awk '$1 == \"gidaspow\" && $2 == %s { print $3; exit }' %s", d, data)))
n(Re) = Re < 0.2 ? 4.65 : Re < 1 ? 4.35 * Re**-0.03 : Re < 500 ? 4.45 * Re**-0.1 : 2.39
garside(Re) = (5.1 + 0.27 * Re**0.9) / (1 + 0.1 * Re**0.9)
set multiplot
set logscale xy
set xrange [0.48:1]
set yrange [0.02:1]
set xtics (0.5, 0.6, 0.8, 1)
set xlabel "void fraction"
do for [k = 1:3] {
    set lmargin at screen 0.06 + 0.31 * (k - 1)
    set rmargin at screen 0.33 + 0.31 * (k - 1)
    set tmargin at screen 0.92
    set bmargin at screen 0.38
    d = word(sizes, k)
    now = Re(d)
    set title sprintf("u / u_t, Re_t about %s", now < 10 ? sprintf("%.1f", now) : sprintf("%.0f", now)) noenhanced font "sans,13"
    if (k == 3) { set key at screen 0.98,0.2 right maxrows 4 samplen 1.5 spacing 1.1 font "sans,12" } else { unset key }
    plot x**n(now) linecolor "#000000" linewidth 2 title "Richardson and Zaki", \
         x**garside(now) linecolor "#000000" dashtype 2 linewidth 1.5 \
             title "Garside and Al-Dibouni", \
         for [i = 1:words(laws)] of(word(laws, i), d) with points pointtype i \
             pointsize 0.8 linecolor i title word(laws, i)
}
unset multiplot
