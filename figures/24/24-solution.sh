#!/bin/sh
# The tube of cases/tube-on-spring.cfg without grains: how often it swings in a
# second, about its mean height of all rows, from the rises through this height.
. "$(dirname "$0")/../here.sh"
dir=out/24-solution
mkdir -p "$dir"
sed '/^particles = {/,/^};/d; /^averaging/d; /^exchange/d; s/pressure_gradient = {};//' \
    cases/tube-on-spring.cfg >"$dir/alone.cfg"

swings() { # name, setting...
    name=$1
    shift
    winnow run "$dir/alone.cfg" -o "$dir/run" --quiet -s output.history=1e-3 \
        -s output.every=0.4 -s output.end=0.4 "$@"
    awk -F, -v name="$name" '
        NR > 1 { t[++n] = $1; y[n] = $4; mean += $4 }
        END {
            mean /= n
            for (i = 2; i <= n; i++) {
                if (y[i - 1] >= mean || y[i] < mean) continue
                at = t[i - 1] + (mean - y[i - 1]) / (y[i] - y[i - 1]) * (t[i] - t[i - 1])
                if (!rises++) first = at
            }
            printf "%s: %.2f Hz, %.3f mm below the rest of the spring\n", name,
                (rises - 1) / (at - first), 1e3 * (y[1] - mean)
        }' "$dir/run/bodies.csv"
}

swings "in air"
water="-s fluid.density=1000 -s fluid.viscosity=1e-3 -s fluid.bottom.inlet=0.0"
wide="-s bodies.cylinders.0.position=[0.045,0.06,0.002] -s mesh.size=[0.09,0.12,0.004]"
# shellcheck disable=SC2086 # words
{
    swings "in water" $water
    swings "in water, three times as wide, twice as high" $water $wide -s mesh.cells=[90,120,4]
}
