#!/bin/sh
# What averaging costs, beside SX15 Table 3: 331 776 settled spheres in a box of
# 264 x 120 x 60 mm, on its four meshes, one thread; and, where OpenFOAM is
# installed, beside a step of its icoFoam on the same cells, air alone.
#
#   sh tests/bench/averaging.sh build/tests/bench      (part of make bench)
#
# Processor time, the least of a few steps.
set -eu
bench=$1
out=$1/run/averaging
export OMP_NUM_THREADS=1
. "$(dirname "$0")/icofoam.inc"
mkdir -p "$out"
STEPS=12 # of icoFoam; the first four do not count

make_case() { # nx ny nz, in the present folder
    solver_files "$(awk "BEGIN { print $STEPS * 2e-4 }")" 2e-4 1.5e-05
    dictionary dictionary blockMeshDict system/blockMeshDict <<END
vertices ((0 0 0) (0.264 0 0) (0.264 0.12 0) (0 0.12 0)
    (0 0 0.06) (0.264 0 0.06) (0.264 0.12 0.06) (0 0.12 0.06));
blocks (hex (0 1 2 3 4 5 6 7) ($1 $2 $3) simpleGrading (1 1 1));
boundary (
    top { type patch; faces ((3 7 6 2)); }
    bottom { type patch; faces ((1 5 4 0)); }
    sides { type wall; faces ((0 4 7 3) (2 6 5 1) (0 3 2 1) (4 5 6 7)); });
END
    fields "top { type zeroGradient; } bottom { type fixedValue; value uniform (0 0.9 0); } sides { type noSlip; }" \
        "top { type fixedValue; value uniform 0; } bottom { type zeroGradient; } sides { type zeroGradient; }"
    blockMesh >log.blockMesh 2>&1
}

icofoam() { # nx ny nz: seconds a step, or 0
    command -v icoFoam >/dev/null || { echo "icofoam 0"; return; }
    rm -rf "${out:?}/case"
    mkdir "$out/case"
    (cd "$out/case" && make_case "$@" && icoFoam >log 2>&1)
    awk -v n=$STEPS '
        /^ExecutionTime/ { t[++k] = $3 }
        END { print "icofoam", (t[n] - t[4]) / (n - 4) }' "$out/case/log"
}

bed=$out/bed.data
[ -s "$bed" ] || "$bench/dem" bed hertz "$bed" 6 0
for cells in "118 54 27" "93 42 21" "74 33 17" "59 27 13"; do
    # shellcheck disable=SC2086 # three words
    { "$bench/averaging" "$bed" $cells; icofoam $cells; } >"$out/$(echo "$cells" | tr ' ' x)"
done
for cells in "118 54 27 1" "93 42 21 1" "74 33 17 1" "59 27 13 1" \
    "59 27 13 2" "59 27 13 4" "59 27 13 8"; do
    echo "copies ${cells##* }"
    # shellcheck disable=SC2086 # four words
    "$bench/averaging" "$bed" $cells
done >"$out/copies"
# shellcheck disable=SC2046 # one word a file
cat $(for cells in 118x54x27 93x42x21 74x33x17 59x27x13; do echo "$out/$cells"; done) "$out/copies" |
    awk -f "$(dirname "$0")/averaging.awk"
