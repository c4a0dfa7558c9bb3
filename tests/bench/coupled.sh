#!/bin/sh
# Our coupled bed beside OpenFOAM's DPMFoam, where its tutorial DPMFoam/Goldschmidt is
# installed (Debian packages openfoam, openfoam-examples; nothing is installed here):
# 24750 spheres of glass in air, a step of the fluid of 2e-5 s and as many steps of the
# particles in it as DPMFoam takes. It begins with spheres apart on a lattice, ours
# with a settled bed, which has more contacts to compute. Its spheres have 1e8 Pa, ours
# the 1e6 Pa of cases/goldschmidt-bed.cfg, with which these steps are safe (winnow
# check); how stiff they are does not change what a step costs.
#
#   sh tests/bench/coupled.sh build/tests/bench [ROUNDS]      (make bench)
#
# Times are processor time of one core for a step of the fluid with the steps of the
# particles in it, from step 20 to step 80.
set -eu
winnow=$1/../../winnow
rounds=${2:-3}
out=$1/run/coupled
steps=80
first=20
within=3
export OMP_NUM_THREADS=1
. "$(dirname "$0")/icofoam.inc"
tutorial=/usr/share/doc/openfoam-examples/examples/lagrangian/DPMFoam/Goldschmidt
there=1
if ! command -v DPMFoam >/dev/null || [ ! -d $tutorial ]; then
    there=0
    echo "DPMFoam or its tutorial is not installed: left out"
fi

theirs() { # seconds and sub-steps a step
    rm -rf "$out/tutorial"
    cp -r $tutorial "$out/tutorial"
    cd "$out/tutorial"
    find . -name '*.gz' -exec gunzip {} +
    sed -i "s/^endTime .*/endTime $(awk "BEGIN { print $steps * 2e-5 }");/
        s/^writeInterval .*/writeInterval 1000;/; s/^timePrecision .*/timePrecision 9;/" \
        system/controlDict
    blockMesh >log.blockMesh 2>&1
    DPMFoam >log 2>&1
    awk -v first=$first '
        /^Time =/ { step++ }
        /^ExecutionTime/ { t[step] = $3 }
        /move-collide subCycles/ && step > first { sub_steps += $1; n++ }
        END { print (t[step] - t[first]) / (step - first),
            n ? int(sub_steps / n + 0.5) : 1 }' log
    cd "$OLDPWD"
}

processor() { # seconds of a run of so many steps
    "$winnow" run cases/goldschmidt-bed.cfg -j 1 --quiet --fresh -o "$out/winnow" \
        -s fluid.step=2e-5 -s particles.step="$(awk "BEGIN { print 2e-5 / $within }")" \
        -s output.end="$(awk "BEGIN { print $1 * 2e-5 }")" -s output.every=1.0 \
        -s output.history=2e-5 -s output.picture=false >/dev/null
    awk -F '[:,]' '/"processor":/ { print $2 }' "$out/winnow/summary.json"
}

ours() { # seconds a step
    awk -v all="$(processor $steps)" -v begin="$(processor $first)" \
        -v n=$((steps - first)) 'BEGIN { print (all - begin) / n }'
}

mkdir -p "$out"
processor 1 >/dev/null # the bed is settled here, and kept
: >"$out/rates.txt"
round=0
while [ $round -lt "$rounds" ]; do
    round=$((round + 1))
    if [ $there = 1 ]; then
        theirs >"$out/theirs.txt"
        read -r seconds within <"$out/theirs.txt"
        echo "DPMFoam $seconds $within" >>"$out/rates.txt"
    fi
    echo "winnow $(ours) $within" >>"$out/rates.txt"
done
awk "$(cat "$(dirname "$0")/median.awk")"'
    { k = ++n[$1]; time[$1, k] = $2; within[$1] = $3 }
    END {
        for (who in n) {
            for (i = 1; i <= n[who]; i++) t[i] = time[who, i]
            printf "%-8s %8.4f s a step of the fluid, %g steps of the particles in it\n",
                   who, median(t, n[who]), within[who]
        }
        for (i = 1; i <= n["DPMFoam"]; i++)
            r[i] = time["DPMFoam", i] / time["winnow", i]
        if (i > 1) printf "Goldschmidt, winnow over DPMFoam = %.1f\n", median(r, i - 1)
    }' "$out/rates.txt"
