#!/bin/sh
# The virtual mass in the small bed at rest under water, as a mean over the weight, for
# runs of three lengths, and for a material that rebounds less.
. "$(dirname "$0")/../here.sh"
dir=out/22-rest
rest() { # key, end of the run [s], restitution
    winnow run cases/small-bed.cfg --quiet -o "$dir" -s fluid.density=1000 \
        -s fluid.viscosity=1e-3 -s particles.grains.density=2500 \
        -s fluid.bottom.inlet=0.005 -s 'effects.virtual_mass={}' \
        -s output.picture=false -s output.end="$2" \
        -s particles.grains.restitution="$3" >"$dir.log" 2>&1
    awk -v key="$1" '
        /"virtual_mass": {/ { named = 1 }
        named && /"mean_share"/ {
            sub(/.*: /, "")
            printf "%s = %.3f [%%]\n", key, 100 * $0
            exit
        }' "$dir/summary.json"
}
mkdir -p out
rest in_5_ms 0.005 0.9
rest in_0.1_s 0.1 0.9
rest in_0.4_s 0.4 0.9
rest with_little_rebound 0.1 0.1
