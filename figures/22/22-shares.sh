#!/bin/sh
# Every effect in every coupled case: what `winnow check` estimates, and what a
# short run with all of them on measures. The ratio of the two is told where one
# of them is over 1 %.
#
#   sh figures/22/22-shares.sh >figures/22/22-shares.txt
. "$(dirname "$0")/../here.sh"
export OMP_NUM_THREADS=1

all="pressure_gradient viscous_stress virtual_mass basset saffman magnus"

shares() { # case, end [s], overrides
    name=$1
    overrides="output.end=$2 output.every=$2"
    shift 2
    overrides="$overrides $*"
    forces=$all
    ! grep -q "whole_drag = {" "cases/$name.cfg" ||
        forces="whole_drag ${all#* }" # in place of the pressure gradient
    for effect in $forces fluid_torque; do
        grep -q "$effect = {" "cases/$name.cfg" ||
            overrides="$overrides effects.$effect={}"
    done
    # shellcheck disable=SC2046 # one word an override
    set -- $(for o in $overrides; do echo "-s $o"; done)
    winnow check "cases/$name.cfg" "$@" >"$work/check" || return 0
    winnow run "cases/$name.cfg" "$@" -o "$work/$name" --quiet \
        >/dev/null 2>&1 || echo "$name broke down"
    for effect in $forces; do
        awk -v name="${label:-$name}" -v effect="$effect" '
            FILENAME ~ /check$/ && $1 == effect { bound = sub(/</, "", $2); estimate = $2 }
            $1 == "\"" effect "\":" && $2 == "{" { within = 1 }
            within && /mean_share/ { measured = 100 * $2; within = 0 }
            END {
                ratio = bound ? "bound" : estimate < 1 && measured < 1 ? "small" \
                    : measured > 0 ? sprintf("%.2f", estimate / measured) : "-"
                printf "%-22s %-18s %9.3g %9.3g %6s\n", name, effect, estimate,
                    measured, ratio
            }
        ' "$work/check" "$work/$name/summary.json"
    done
}

echo "# case effect estimated_% measured_% ratio"
shares settling-sphere 0.2
shares upflow-sphere 0.35
shares one-grain 0.0066
shares closed-box 0.05
shares packed-column 0.5
shares small-bed 0.3
water="fluid.density=1000 fluid.viscosity=1e-3 particles.grains.density=2500"
label=small-bed,water,rest
shares small-bed 0.3 $water fluid.bottom.inlet=0.005
label=small-bed,water
shares small-bed 0.3 $water fluid.bottom.inlet=0.05
label=
shares fed-bed 0.3
shares mueller-bed 0.1
shares fluidization-ramp 0.05 fluid.bottom.inlet=1.5 particles.bed.settle=0.1
shares fluidization-two-sizes 0.05 particles.bed.settle=0.6 particles.grains.stiffness=100 particles.step=1.4e-5
shares tapered-bed 0.1
shares van-wachem-bed 0.02
shares seepage 0.02 particles.bed.settle=0.02
shares history-sphere 2e-3
shares shear-grain 6.5
shares saltating-grain 0.17
shares wet-rebound 0.012
shares rising-bead 0.03
shares falling-cloud 0.2
shares spinning-grain 0.004
shares settling-suspension 0.1
shares mueller-bed-06 0.02 particles.bed.settle=0.1
shares ew18-liquid 10 fluid.bottom.inlet=1.0
shares ew18-liquid-cube 10 fluid.bottom.inlet=1.0
shares ew18-liquid-random 10 fluid.bottom.inlet=1.0
shares ew18-liquid-shared 10 fluid.bottom.inlet=1.0
shares ew18-gas 4 fluid.bottom.inlet=1.0
shares carried-bead 0.6
