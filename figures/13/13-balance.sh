#!/bin/sh
# The superficial velocity at which Syamlal and O'Brien's drag and the pressure
# gradient carry a bed, beta U / eps_f^2 = eps_s (rho_s - rho_f) g, by bisection.
#
#   sh figures/13/13-balance.sh eps_s rho_s rho_f mu d g
. "$(dirname "$0")/../here.sh"
eps_s=$1 rho_s=$2 rho_f=$3 mu=$4 d=$5 g=$6
low=1e-6 high=4
for i in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24; do
    U=$(awk "BEGIN { print sqrt($low * $high) }")
    u=$(awk "BEGIN { print $U / (1 - $eps_s) }")
    beta=$(winnow eval XS11:2.11 eps_s=$eps_s rho_f=$rho_f mu=$mu d=$d u_r=$u |
        awk '{ print $3 }')
    if awk "BEGIN { exit !($beta * $U / (1 - $eps_s) ^ 2 < \
        $eps_s * ($rho_s - $rho_f) * $g) }"; then low=$U; else high=$U; fi
done
awk "BEGIN { printf \"U_mf = %.4g [m/s]\n\", $low }"
