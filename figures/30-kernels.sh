#!/bin/sh
# The bed of cases/fluidization-ramp.cfg at rest in air of 0.6 m/s, averaged in
# several ways: the drop between the sensors [Pa] after 0.01 s, when the bed lies
# as it was poured, and the mean from 0.1 to 0.2 s. Springs of 500 N/m.
set -eu
out=out/30-kernels
mkdir -p $out
echo "# averaging, bandwidth [mm], interpolation, drop at 0.01 s, later [Pa]"
for way in kernel,10,same kernel,10,linear kernel,6,linear kernel,4,linear \
    pcm,-,linear; do
    method=${way%%,*} rest=${way#*,}
    b=${rest%,*} seen=${rest#*,}
    wide=
    [ "$b" = - ] || wide="-s averaging.bandwidth=${b}e-3"
    # shellcheck disable=SC2086 # two words or none
    winnow run cases/fluidization-ramp.cfg --quiet -o "$out/$way" \
        -s particles.grains.stiffness=500 -s particles.step=1.2e-5 \
        -s fluid.bottom.inlet=0.6 -s output.end=0.2 \
        -s averaging.method="$method" -s averaging.interpolation="$seen" \
        $wide >"$out/$way.log" 2>&1
    awk -F, -v method=$method -v b=$b -v seen=$seen '
        NR == 3 { first = $2 - $3 }
        NR > 1 && $1 > 0.1 { sum += $2 - $3; n++ }
        END { printf "%-6s  %2s  %-6s  %3.0f  %3.0f\n", method, b, seen, first, sum / n
        }' "$out/$way/probes.csv"
done
