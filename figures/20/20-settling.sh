#!/bin/sh
# What accuracy costs for the sphere of cases/settling-sphere.cfg, let go at rest.
#
#   20-settling.sh steps|cells
#
# steps: error of its velocity after 32 ms, 1.9 relaxation times, over the terminal
# one, and drag evaluations, for steps of the fluid; frozen, with sub-steps of 0.5
# ms, exponential; the first and the last without sub-steps. cells: how much faster it is, in 64 ms, than it would be alone,
# because the cells around it move along with it; by cell width over d.
. "$(dirname "$0")/../here.sh"
mkdir -p out
fall() { # OVERRIDES...: the last velocity
    winnow run cases/settling-sphere.cfg -o out/settling-cost --quiet "$@" >/dev/null
    sh chapters/tools/last.sh out/settling-cost mean_fall_velocity | cut -d' ' -f3
}
error() { awk "BEGIN { printf \" %9.2e\", ($1 - $2) / 0.137337 }"; }
steps() {
    short="-s output.end=0.032"
    # shellcheck disable=SC2086
    exact=$(fall $short -s fluid.step=2e-5 \
        -s exchange.slip_integration=exponential)
    echo "# step [ms], over tau_p [-], evaluations; error frozen, sub-steps, exponential [-]"
    for n in 32 16 8 4 2 1; do
        dt=$(awk "BEGIN { print 0.032 / $n }")
        printf '%5.1f %6.3f %3d' "$(awk "BEGIN { print 1e3 * $dt }")" \
            "$(awk "BEGIN { print $dt / 0.0167 }")" $n
        # shellcheck disable=SC2086
        {
            error "$(fall $short -s fluid.step=$dt -s exchange.substeps=1)" "$exact"
            error "$(fall $short -s fluid.step=$dt -s exchange.substeps=$((64 / n)))" "$exact"
            error "$(fall $short -s fluid.step=$dt -s exchange.substeps=1 \
                -s exchange.slip_integration=exponential)" "$exact"
        }
        echo
    done
}
cells() {
    common="-s output.end=0.064 -s fluid.step=5e-4"
    echo "# cell over d [-]; sums of each cell, diffusion over 4 d, over 16 d [-]"
    for width in 200 50 20 10 5; do
        side=$(awk "BEGIN { print 12 * $width * 1e-4 }")
        middle=$(awk "BEGIN { print 0.46 * $side }")
        high=$(awk "BEGIN { print 3 * $side }")
        start=$(awk "BEGIN { print 2.6 * $side }")
        box="-s mesh={size=[$side,$high,$side];cells=[12,36,12];}"
        place="-s particles.place.0.position=[$middle,$start,$middle]"
        printf '%3d' $width
        # shellcheck disable=SC2086
        {
            alone=$(fall $common $box $place -s exchange.coupling=one-way)
            error "$(fall $common $box $place)" "$alone"
            for b in 4e-4 16e-4; do
                error "$(fall $common $box $place \
                    -s "averaging={method=\"diffusion\";bandwidth=$b;}")" "$alone"
            done
        }
        echo
    done
}
$1
