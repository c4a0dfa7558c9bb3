#!/bin/sh
# The bed of cases/fluidization-ramp.cfg at rest in air of 0.6 m/s, averaged in
# several ways: the drop between the sensors [Pa] after 0.01 s, when the bed lies
# as it was poured, and the mean from 0.1 to 0.2 s; for two of them of three beds
# that were poured differently. Springs of 500 N/m.
. "$(dirname "$0")/../here.sh"
out=out/30-kernels
mkdir -p $out
echo "# averaging, bandwidth [mm], interpolation, bed, drop at 0.01 s, later [Pa]"
for way in kernel,10,same,1 kernel,10,linear,1 kernel,6,linear,1 kernel,6,linear,2 \
    kernel,6,linear,3 kernel,4,linear,1 pcm,-,linear,1 pcm,-,linear,2 \
    pcm,-,linear,3; do
    method=${way%%,*} rest=${way#*,} seed=${way##*,}
    b=${rest%%,*} seen=${rest#*,}
    seen=${seen%,*}
    wide=
    [ "$b" = - ] || wide="-s averaging.bandwidth=${b}e-3"
    # shellcheck disable=SC2086 # two words or none
    winnow run cases/fluidization-ramp.cfg --quiet -o "$out/$way" \
        -s particles.grains.stiffness=500 -s particles.step=1.2e-5 \
        -s fluid.step=2e-4 -s fluid.bottom.inlet=0.6 -s output.end=0.2 -s particles.bed.seed="$seed" \
        -s averaging.method="$method" -s averaging.interpolation="$seen" \
        $wide >"$out/$way.log" 2>&1
    awk -F, -v method=$method -v b=$b -v seen=$seen -v seed="$seed" '
        NR == 3 { first = $2 - $3 }
        NR > 1 && $1 > 0.1 { sum += $2 - $3; n++ }
        END { printf "%-6s  %2s  %-6s  %d  %3.0f  %3.0f\n", method, b, seen, seed, first, sum / n
        }' "$out/$way/probes.csv"
done
