#!/bin/sh
# What each effect costs when it is on: the small bed in water, on its mesh and
# on one of four times as many cells, with that effect beside the weight. One
# thread; of several rounds the least. The time of its hooks is divided between
# particles and cells by the two meshes; what else the processor takes more goes
# with the steps of the particles, and is good to some 10 ns. The last column is
# all that it takes more.
#
#   sh tests/bench/effects.sh build/tests/bench [ROUNDS]    (part of make bench)
set -eu
winnow=${1%/tests/bench}/winnow
rounds=${2:-3}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export OMP_NUM_THREADS=1

effects() {
    cat <<EOF
none
pressure_gradient {}
viscous_stress {}
virtual_mass {}
basset {}
saffman {}
fluid_torque {}
magnus {}
electrostatic {range=1e-3;} particles.grains.charge=1e-13
van_der_waals {hamaker=1e-19;range=1e-5;}
capillary {tension=0.01;range=5e-5;}
stochastic_drag {sigma_low=0.1;sigma_high=0.1;time=0.01;}
lubrication {roughness=1e-6;range=1e-4;}
whole_drag {}
particle_stress {pressure=0.1;} particles.list=none particles.bed.settle=0.0
EOF
}

# Seconds in the hooks of an effect, of the particles' steps and of all, and the
# numbers of steps, particle steps, particles and cells.
run() { # effect, cells, overrides...
    name=$1 cells=$2
    shift 2
    "$winnow" run cases/small-bed.cfg -o "$work/out" --quiet -j 1 \
        -s "mesh.cells=$cells" -s output.end=0.06 -s output.every=0.06 \
        -s fluid.density=1000 -s fluid.viscosity=1e-3 \
        -s particles.grains.density=2500 -s fluid.bottom.inlet=0.03 \
        "$@" >/dev/null
    awk -v name="$name" '
        { gsub(/[",]/, "") }
        $1 == "effect_seconds:" { own = 1 }
        own && $1 == name ":" { hooks = $2 }
        $1 == "dem:" { dem = $2 }
        $1 == "processor:" { all = $2 }
        $1 == "steps:" { steps = $2 }
        $1 == "particle_steps_in_a_step:" { within = $2 }
        $1 == "particles:" { particles = $2 }
        $1 == "cells:" { cells = $2 }
        END { print name, hooks + 0, dem, all, steps, within, particles, cells }
    ' "$work/out/summary.json"
}

for round in $(seq "$rounds"); do
    effects | while read -r name group more; do
        set --
        case $name in
        none) ;;
        whole_drag) set -- -s "effects={gravity=[0.0,-9.81,0.0];$name=$group;}" ;;
        *) set -- -s "effects.$name=$group" ;;
        esac
        for key in $more; do set -- "$@" -s "$key"; done
        for cells in '[8,32,1]' '[16,64,1]'; do
            echo "$round $(run "$name" "$cells" "$@")"
        done
    done
done | awk '
{ key = $2 " " $9
  if (!(key in hooks)) { hooks[key] = $3; dem[key] = $4; all[key] = $5 }
  if ($3 < hooks[key]) hooks[key] = $3
  if ($4 < dem[key]) dem[key] = $4
  if ($5 < all[key]) all[key] = $5
  if (!($2 in seen)) { seen[$2] = 1; order[++n] = $2 }
  if (few == 0 || $9 < few) few = $9
  if ($9 > many) many = $9
  steps = $6; within = $7; particles = $8 }
END {
    print "# ns a particle and step, a cell and step, a particle and particle step; % of the run"
    for (i = 2; i <= n; i++) {
        e = order[i]; a = e " " few; b = e " " many; z = "none " few
        cell = (hooks[b] - hooks[a]) / (many - few) / steps
        if (cell < 0) cell = 0
        each = (hooks[a] / steps - cell * few) / particles
        if (each < 0) each = 0
        pair = (all[a] - all[z] - hooks[a]) / steps / within / particles
        if (pair < 0) pair = 0
        printf "%-18s %6.0f %6.0f %6.1f %6.1f\n", e, 1e9 * each, 1e9 * cell,
            1e9 * pair, 100 * (all[a] / all[z] - 1)
    }
}'
