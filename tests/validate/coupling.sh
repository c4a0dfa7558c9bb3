#!/bin/sh
# Long runs of the coupling: Cases 1, 2 and 4 of XS11, with the kernel and with
# sums of each cell, on two meshes. Hours; the figures of chapter 20 are made of
# what they leave.
#
#   sh tests/validate/coupling.sh build/winnow [two|ramp|seepage|weight ...]
set -eu
PATH=$(cd "$(dirname "$1")" && pwd):$PATH
shift
out=out/validate-coupling
export OMP_NUM_THREADS="${OMP_NUM_THREADS:-1}"
mkdir -p $out

run() { # NAME CASE OVERRIDES...: a run that breaks down is a result
    name=$1 case=$2
    shift 2
    winnow run "cases/$case.cfg" -o "$out/$name" --quiet "$@" >"$out/$name.log" 2>&1 ||
        tail -n 3 "$out/$name.log"
}

# Case 2, Figs. 6 and 7. 4e-6 s is safe for the springs; XS11 take 1e-6.
two() {
    two="fluidization-two-sizes -s particles.step=4e-6"
    coarse="-s mesh.cells=[8,40,1]" sums="-s averaging.method=pcm"
    # shellcheck disable=SC2086 # one word an argument
    {
        run kernel-12x60 $two
        run kernel-8x40 $two $coarse
        run pcm-12x60 $two $sums
        run pcm-8x40 $two $sums $coarse
        run short-step $two -s particles.step=2e-6 -s output.end=1.6
    }
    made="# Made by: sh tests/validate/coupling.sh build/winnow two"
    { echo "$made"; sh figures/20-two-sizes.sh series $out; } >figures/20-two-sizes.txt
    { echo "$made"; sh figures/20-two-sizes.sh numbers $out; } >figures/20-two-numbers.txt
    { echo "$made"; sh figures/20-two-sizes.sh steps $out; } >figures/20-two-steps.txt
}

# Case 1, Figs. 4 and 5, with springs ten times as soft.
ramp() {
    ramp="fluidization-ramp -s particles.grains.stiffness=500 -s particles.step=1.2e-5"
    fine="-s mesh.cells=[25,100,1]"
    # shellcheck disable=SC2086
    {
        run ramp-15x75 $ramp
        run ramp-seed2 $ramp -s particles.bed.seed=2 -s output.end=15
        run ramp-25x100 $ramp $fine -s output.end=15
        run ramp-pcm-25x100 $ramp $fine -s averaging.method=pcm -s output.end=15
    }
    made="# Made by: sh tests/validate/coupling.sh build/winnow ramp"
    for name in ramp-15x75 ramp-seed2 ramp-25x100 ramp-pcm-25x100; do
        sh figures/20-ramp.sh series $out $name >figures/20-$name.txt
    done
    # the sums of each cell do not get as far as 1 m/s
    files="figures/20-ramp-stiff.txt figures/20-ramp-15x75.txt"
    files="$files figures/20-ramp-seed2.txt figures/20-ramp-25x100.txt"
    # shellcheck disable=SC2086
    { echo "$made"; sh figures/20-ramp.sh numbers $files; } >figures/20-ramp-numbers.txt
}

# Case 4, Figs. 10 and 11.
seepage() {
    run seepage seepage
    python3 figures/20-classes.py $out/seepage
}

# Who carries the bed of Case 1.
weight() {
    sh chapters/tools/transcript.sh figures/20-weight.txt
}

for part in "${@:-two}"; do $part; done
[ $# -gt 0 ] || { ramp; seepage; weight; }
