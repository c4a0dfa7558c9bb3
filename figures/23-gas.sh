#!/bin/sh
# What EW18's gas bed does from 40 d/u on, from the history of a run.
#
#   winnow run cases/ew18-gas.cfg -o out/gas
#   sh figures/23-gas.sh out/gas >figures/23-gas.txt
set -eu
echo "# Made by: winnow run cases/ew18-gas.cfg -o out/gas; sh figures/23-gas.sh out/gas"
awk -F, '
    NR == 1 { for (i = 1; i <= NF; i++) { name = $i; sub(/ .*/, "", name); at[name] = i } next }
    $1 >= 40 {
        n++
        h = 2 * $at["mean_height"]; height += h; square += h * h
        drop += $at["pressure_drop"]; weight = $at["buoyant_weight"]
        T += $at["granular_temperature"]
        # A wave of the height: it crosses its middle, 24.8 d, upward.
        if (before > 0 && before < 24.8 && h >= 24.8) { if (!waves++) first = $1; last = $1 }
        before = h
    }
    END {
        printf "## gas\nheight = %.2f [d]\nswing = %.2f [d]\n", height / n,
            sqrt(square / n - height * height / n / n)
        printf "drop_over_weight = %.3f [-]\n", drop / n / weight
        printf "sqrt_T = %.3f [-]\n", sqrt(T / n)
        printf "period = %.1f [d/u_in]\n", (last - first) / (waves - 1)
    }' "$1/history.csv"
