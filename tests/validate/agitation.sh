#!/bin/sh
# The beds of EW18 without resolved flow: how much the grains fluctuate with a
# coarse averaging, with a Gaussian, and with a random part of the drag. A run that
# is done is not made again, and one that was interrupted goes on.
#
#   sh tests/validate/agitation.sh build/winnow [liquid|measured|treatments|choices|kernels|gas ...]
#
# liquid takes three to eight minutes for each Reynolds number of RE (4 6 8 11),
# choices half an hour, kernels an hour and a half (the last row half an hour), gas three
# quarters of one. END=60 in the environment ends each run at 60, to try
# the script; what it finds then goes to out/validate-agitation/figures.
. "$(dirname "$0")/runs.inc"

# NAME CASE OVERRIDES...
run() {
    [ -z "${END:-}" ] || set -- "$@" -s "output.end=$END" -s output.statistics.from=20.0
    once "$@" -s output.every=50
}

# NAME QUANTITY KEY: a number of its statistics.
value() {
    awk -v group="\"$2\":" -v key="\"$3\":" '
        $1 == group { inside = 1 }
        inside && $1 == key { sub(/,$/, "", $2); print $2; exit }
        inside && /}/ { exit }' "$out/$1/statistics/summary.json"
}

count() { # NAME KEY
    awk -v key="\"$2\":" '$1 == key { sub(/,$/, "", $2); print $2 }' \
        "$out/$1/summary.json"
}

# NAME WORDS...: a row of a table. Temperatures as their roots, with errors; seconds
# of the processor.
row() {
    name=$1
    shift
    weight=$(awk -F, 'NR == 1 { for (i = 1; i <= NF; i++)
            if ($i ~ /^buoyant_weight/) c = i }
        END { print $c }' "$out/$name/history.csv")
    cuts=$(count "$name" stochastic_drag_cuts) uses=$(count "$name" stochastic_drag_uses)
    echo "$* $(value "$name" temperature_axial mean) $(value "$name" temperature_axial error)" \
        "$(value "$name" temperature_transverse mean) $(value "$name" temperature_transverse error)" \
        "$(value "$name" bed_height mean) $(value "$name" bed_height error)" \
        "$(value "$name" pressure_drop mean) $(value "$name" pressure_drop error) $weight" \
        "$(value "$name" drag_coefficient mean) $(value "$name" drag_coefficient deviation)" \
        "$(value "$name" drag_coefficient integral_time) ${cuts:-0} ${uses:-1}" \
        "$(count "$name" processor)" |
        awk '{ n = NF - 15
            for (i = 1; i <= n; i++) printf "%s ", $i
            printf "%.4f %.4f %.4f %.4f %.3f %.3f %.4f %.4f %.2f %.3f %.3f %.4f %.0f\n",
                sqrt($(n + 1)), $(n + 2) / (2 * sqrt($(n + 1))),
                sqrt($(n + 3)), $(n + 4) / (2 * sqrt($(n + 3))),
                $(n + 5), $(n + 6), $(n + 7) / $(n + 9), $(n + 8) / $(n + 9),
                $(n + 10), $(n + 11) / $(n + 10), $(n + 12), $(n + 13) / $(n + 14), $(n + 15) }'
}
columns="sqrt_T_axial error sqrt_T_transverse error height error drop/weight error\
 C_d sigma/C_d T cuts seconds"

# PART HEADER: makes the runs and the table of lines NAME WORDS... | CASE OVERRIDES...
table() {
    lines=$(cat)
    # shellcheck disable=SC2086 # words
    echo "$lines" | while IFS='|' read -r words change; do run ${words%% *} $change </dev/null; done || exit
    {
        made "$1"
        echo "# $2 $columns"
        # shellcheck disable=SC2086
        echo "$lines" | while IFS='|' read -r words _; do row $words; done
    } >$figures/23/23-"$1".txt
}

# The rows of such a table by name, for the text; in which columns the words are.
numbers() {
    awk -v first="$1" -v second="$2" -v columns="$columns" '
        BEGIN { n = split(columns, name, " ") }
        /^# Made/ { print }
        /^#/ { next }
        {
            print "## " $first "-" $second
            for (i = 1; i <= n; i++) {
                key = name[i] == "error" ? name[i - 1] "_error" : name[i]
                gsub("/", "_over_", key)
                print key " = " $(NF - n + i) " [-]"
            }
        }'
}

# NAME FILE [EVERY]: a block for gnuplot, of a table of the run.
block() {
    echo "# $1"
    awk -F, -v every="${3:-1}" 'NR == 1 || NR % every == 0 {
        if (NR > 1) { for (i = 1; i <= NF; i++) printf "%.5g ", $i; print "" } }' \
        "$out/$1/statistics/$2.csv"
    printf '\n\n'
}

# At the two lower velocities drag and weight are larger: the explicit drag needs
# EW18's own steps, and the grains more stiffness.
short="-s fluid.step=3e-3 -s particles.step=3e-4"
stiff="-s particles.grains.stiffness=5e4"
slow="-s fluid.viscosity=0.25 -s effects.gravity=[0.0,-24.2,0.0] $stiff $short"
middle="-s fluid.viscosity=0.1666667 -s effects.gravity=[0.0,-10.75,0.0] $stiff $short"

# Figs. 14 to 17 and Table 1, reading A: Re_in, 1 / Re_in, Fr.
liquid() {
    ways="cube gauss random"
    for re in ${RE:-4 6 8 11}; do
        case $re in
        4) scale=$slow ;;
        6) scale=$middle ;;
        8) scale="-s fluid.viscosity=0.125 -s effects.gravity=[0.0,-6.05,0.0]" ;;
        *) scale= ;;
        esac
        # shellcheck disable=SC2086 # two words or none
        {
            run cube-$re cases/ew18-liquid-cube.cfg $scale
            run gauss-$re cases/ew18-liquid.cfg $scale
            run random-$re cases/ew18-liquid-random.cfg $scale
        }
    done
    {
        made liquid
        echo "# Re_in way $columns"
        for re in ${RE:-4 6 8 11}; do
            for way in $ways; do row "$way-$re" "$re" "$way"; done
        done
    } >$figures/23/23-liquid.txt
    numbers 2 1 <$figures/23/23-liquid.txt >$figures/23/23-numbers.txt
    for file in series profile correlation; do
        {
            made liquid
            for way in $ways; do
                for re in ${RE:-4 6 8 11}; do
                    block "$way-$re" $file "$([ $file = series ] && echo 10 || echo 1)"
                done
            done
        } >$figures/23/23-liquid-$file.txt
    done
}

# The random part that resolved grains have here, at the two upper velocities; the others
# from `liquid`.
measured() {
    for re in ${RE:-8 11}; do
        case $re in
        8) scale="-s fluid.viscosity=0.125 -s effects.gravity=[0.0,-6.05,0.0] -s effects.stochastic_drag.time=0.52" ;;
        *) scale= ;;
        esac
        # shellcheck disable=SC2086 # words or none
        run measured-$re cases/ew18-liquid-measured.cfg $scale
    done
    {
        made measured
        echo "# Re_in way $columns"
        for re in ${RE:-8 11}; do
            grep "^$re [gr]" figures/23/23-liquid.txt
            row measured-$re $re measured
        done
    } >$figures/23/23-measured.txt
}

# What EW18 leaves open, varied once each, at Re_in = 11; and other random numbers.
choices() {
    grain=particles.grains random=effects.stochastic_drag
    gauss=cases/ew18-liquid.cfg with=cases/ew18-liquid-random.cfg
    table choices what <<END
gauss-11 gauss-11 | $gauss
restitution restitution | $gauss -s $grain.restitution=0.7
friction friction | $gauss -s $grain.friction=0.1
stiffness stiffness | $gauss -s $grain.stiffness=9e4
longer longer | $gauss -s output.end=350.0
step step | $gauss -s fluid.step=3e-3 -s particles.step=3e-4
random-11 random-11 | $with
seed-2 seed-2 | $with -s $random.seed=2
seed-3 seed-3 | $with -s $random.seed=3
memory-0.5 memory-0.5 | $with -s $random.time=0.5
memory-0.1 memory-0.1 | $with -s $random.time=0.1
thinner thinner | $with -s $random.sigma_low=46.8 -s $random.sigma_high=6.71
END
}

# The drag law as the whole force or beside the pressure gradient, and two ways of
# giving it to the fluid, at Re_in = 4 with two steps; and both forms at 11.
treatments() {
    brief="$slow -s output.end=80.0 -s output.statistics.from=20.0"
    long="-s fluid.step=1e-2 -s particles.step=1e-3"
    semi="-s exchange.treatment=semi-implicit"
    whole=cases/ew18-liquid.cfg shared=cases/ew18-liquid-shared.cfg
    table treatments "Re_in, form, treatment, step," <<END
whole 4 whole explicit 3e-3 | $whole $brief
shared-long 4 shared explicit 1e-2 | $shared $brief $long
shared 4 shared explicit 3e-3 | $shared $brief
semi-long 4 whole semi-implicit 1e-2 | $whole $brief $semi $long
semi 4 whole semi-implicit 3e-3 | $whole $brief $semi
gauss-11 11 whole explicit 1e-2 | $whole
shared-11 11 shared explicit 1e-2 | $shared
END
}

# Figs. B.1 and B.2 at Re_in = 6: cells a diameter, and the width of the kernel, that on two
# cells a diameter (GK-2) from 50 to 80.
kernels() {
    scale="cases/ew18-liquid.cfg $middle"
    table kernels "cells a d, delta_05/d," <<END
cells-0.5 0.5 1 | $scale -s mesh.cells=[4,8,4]
gauss-6 1 1 | $scale
cells-1.5 1.5 1 | $scale -s mesh.cells=[12,22,12]
cells-2 2 1 | $scale -s mesh.cells=[16,30,16]
width-1.5 1 1.5 | $scale -s averaging.delta_05=1.5
width-2 1 2 | $scale -s averaging.delta_05=2.0
fine-width-1.5 2 1.5 | $scale -s mesh.cells=[16,30,16] -s averaging.delta_05=1.5 -s output.end=80.0
fine-width-2 2 2 | $scale -s mesh.cells=[16,30,16] -s averaging.delta_05=2.0 -s output.end=80.0
cells-3 3 1 | $scale -s mesh.cells=[24,45,24]
END
}

# Figs. 18 to 20: coarse, with a Gaussian on cells of one diameter, with a random
# part, with Di Felice's own law; and with two cells a diameter (EW18's GK-2).
gas() {
    sigma="-s effects.stochastic_drag.sigma_low=43.9 -s effects.stochastic_drag.Re_low=16.54"
    sigma="$sigma -s effects.stochastic_drag.sigma_high=16.0 -s effects.stochastic_drag.Re_high=28.0"
    sigma="$sigma -s effects.stochastic_drag.linear=true -s effects.stochastic_drag.time=1.0"
    case=cases/ew18-gas.cfg fine="-s mesh.cells=[20,100,20]"
    ways="cube gauss random di-felice gauss-2 random-2"
    table gas "bed way" <<END
gas-cube gas cube | $case -s mesh.cells=[6,30,6] -s averaging={method="cube";interpolation="linear";}
gas-gauss gas gauss | $case
gas-random gas random | $case $sigma
gas-di-felice gas di-felice | $case -s exchange.drag=di-felice
gas-gauss-2 gas gauss-2 | $case $fine
gas-random-2 gas random-2 | $case $fine $sigma
END
    {
        numbers 1 2 <$figures/23/23-gas.txt
        for way in $ways; do
            echo "## swing-$way"
            echo "height = $(value gas-$way bed_height deviation) [-]"
        done
    } >$figures/23/23-gas-numbers.txt
    for file in series profile; do
        {
            made gas
            for way in $ways; do
                block gas-$way $file "$([ $file = series ] && echo 5 || echo 1)"
            done
        } >$figures/23/23-gas-$file.txt
    done
}

[ $# -gt 0 ] || set -- liquid measured treatments choices kernels gas
for part in "$@"; do $part; done
