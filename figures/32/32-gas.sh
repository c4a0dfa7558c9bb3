#!/bin/sh
# A gas that cools: the slope of Theta^(-1/2), from 8 ms to 36 ms, over that of Haff's law
# for grains; what the budget of energy leaves, over the energy; and the momentum [N s].
#
#   sh figures/32/32-gas.sh GRAINS kept|dissipation
. "$(dirname "$0")/../here.sh"
awk -v grains="$1" -v restitution="$2" -f cases/cooling-gas.awk >"$work/gas.cfg"
winnow run "$work/gas.cfg" -o "$work/gas" --quiet -j 1
awk -F, '
    NR == 1 { for (i = 1; i <= NF; i++) { split($i, p, " "); col[p[1]] = i } next }
    { y = $col["granular_temperature"] ^ -0.5 }
    NR == 2 { energy = $col["kinetic_energy_particles"] }
    $1 > 0.008 - 1e-9 { n++; x1 += $1; y1 += y; xx += $1 * $1; xy += $1 * y }
    END {
        haff = (1 - 0.9 ^ 2) * 4 / sqrt(3.14159265359) * 0.1 * 0.95 / 0.9 ^ 3 / 1e-3
        sum = $col["momentum_x"] + $col["momentum_y"] + $col["momentum_z"]
        printf "%.3f %.4f %s\n", (n * xy - x1 * y1) / (n * xx - x1 * x1) / haff, $col["energy_residual"] / energy,
            sum * sum < 1e-30 ? 0 : sum
    }' "$work/gas/history.csv"
