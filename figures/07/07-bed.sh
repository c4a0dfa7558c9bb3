#!/bin/sh
# The small bed after 0.04 s with several tolerances: the iterations of the last
# step, and what it leaves.
. "$(dirname "$0")/../here.sh"
echo 'tolerance  pressure  momentum  mass     drop [Pa]'
for tolerance in 1e-2 1e-4 1e-6 1e-8 1e-10; do
    winnow run cases/small-bed.cfg --quiet -o out/07-bed -s output.end=0.04 \
        -s fluid.tolerance=$tolerance >/dev/null 2>&1
    sh chapters/tools/last.sh out/07-bed pressure_iterations \
        momentum_iterations mass_residual pressure_drop |
        awk -v t=$tolerance '
        { v[NR] = $3 }
        END { printf "%9s %9d %9d  %.1e %8.3f\n", t, v[1], v[2], v[3], v[4] }'
done
