#!/bin/sh
# Velocity of the sphere of cases/upflow-sphere.cfg after one fluid step of 0.1
# and of 0.01 ms, with the pressure gradient of the fluid acting on it.
. "$(dirname "$0")/../here.sh"
for step in 1e-4 1e-5; do
    winnow run cases/upflow-sphere.cfg -o out/first-step --quiet \
        -s effects.pressure_gradient={} -s fluid.step=$step \
        -s output.end=$step -s output.every=$step -s output.history=$step >/dev/null 2>&1
    sh chapters/tools/last.sh out/first-step mean_fall_velocity
done
