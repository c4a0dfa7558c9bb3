# gnuplot figures/10-ledger.gp, from the top folder
set terminal svg size 720,330 font 'sans-serif,13' background 'white'
set output 'figures/10-ledger.svg'
set multiplot layout 1,2
set grid linecolor rgb '#dddddd'
set xlabel 'time [s]'
set title 'what would be lost without the unpaid impulse' font ',13'
set ylabel 'share of all momentum [%]'
plot 'figures/10-ledger.txt' using 1:(100 * $2) with lines linewidth 2 linecolor rgb '#2c728e' notitle
set title 'what is lost with it' font ',13'
set ylabel 'share of all momentum [-]'
set logscale y
set format y '10^{%L}'
set yrange [1e-17:1e-9]
plot 'figures/10-ledger.txt' using 1:($3 + 1e-17) with lines linewidth 2 linecolor rgb '#d1495b' notitle
