#!/bin/sh
# Every effect in every coupled case: what `winnow check` estimates, and what a
# short run with all of them on measures. In a row "-" stands for a case that
# cannot have the effect.
#
#   sh figures/22-shares.sh build/winnow >figures/22-shares.txt
set -u
winnow=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export OMP_NUM_THREADS=1

forces="pressure_gradient viscous_stress virtual_mass basset saffman magnus"

shares() { # case, end [s]
    overrides="output.end=$2 output.every=$2"
    for effect in $forces fluid_torque; do
        grep -q "$effect = {" "cases/$1.cfg" ||
            overrides="$overrides effects.$effect={}"
    done
    set -- "$1" $(for o in $overrides; do echo "-s $o"; done)
    name=$1
    shift
    "$winnow" check "cases/$name.cfg" "$@" >"$work/check" || return
    "$winnow" run "cases/$name.cfg" "$@" -o "$work/$name" --quiet \
        >/dev/null 2>&1 || echo "$name broke down"
    for effect in $forces; do
        awk -v name="$name" -v effect="$effect" '
            FILENAME ~ /check$/ && $1 == effect { estimate = $2 }
            $1 == "\"" effect "\":" && $2 == "{" { within = 1 }
            within && /mean_share/ { measured = 100 * $2; within = 0 }
            END { printf "%-22s %-18s %9.3g %9.3g %6.2f\n", name, effect,
                  estimate, measured, (measured > 0) ? estimate / measured : 0 }
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
shares fed-bed 0.3
shares mueller-bed 0.15
shares fluidization-ramp 0.05
shares fluidization-two-sizes 0.1
shares seepage 0.02
