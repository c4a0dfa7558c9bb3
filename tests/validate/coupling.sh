#!/bin/sh
# Long runs of the coupling: Cases 1, 2 and 4 of XS11, with the kernel and with
# sums of each cell, on two meshes, with other seeds and springs. Hours; the
# figures of chapter "Which treatment is stable" are made of what they leave.
#
#   sh tests/validate/coupling.sh build/winnow [two|sensor|ramp|seepage|springs|weight ...]
#
# END=1.3 in the environment ends each run at 1.3 s, to try the scripts; what they
# find then goes to out/validate-coupling/figures and nothing of ours changes.
. "$(dirname "$0")/runs.inc"
python=/usr/bin/python3 # Debian's own, which python3-vtk9 belongs to
[ -x $python ] || python=python3

# NAME CASE OVERRIDES...: END comes before what is asked for here; a run that breaks down is a
# result, one that cannot begin is not.
run() {
    name=$1 case=$2
    shift 2
    code=0
    [ -z "${END:-}" ] || set -- "$@" -s "output.end=$END"
    winnow run "$case" -o "$out/$name" --quiet "$@" >"$out/$name.log" 2>&1 || code=$?
    [ $code = 0 ] || tail -n 3 "$out/$name.log" >&2
    [ $code = 0 ] || [ $code = 3 ] || exit $code
}

# Case 2, Figs. 6 and 7. 4e-6 s is safe for the springs; XS11 take 1e-6.
two() {
    two="cases/fluidization-two-sizes.cfg -s particles.step=4e-6"
    coarse="-s mesh.cells=[8,40,1]" sums="-s averaging.method=pcm"
    # shellcheck disable=SC2086 # one word an argument
    {
        run kernel-12x60 $two
        run kernel-8x40 $two $coarse
        run pcm-12x60 $two $sums
        run pcm-8x40 $two $sums $coarse
        run short-step $two -s particles.step=2e-6 -s output.end=1.6
    }
    { made two; sh figures/30/30-two-sizes.sh series $out; } >$figures/30/30-two-sizes.txt
    { made two; sh figures/30/30-two-sizes.sh numbers $out; } >$figures/30/30-two-numbers.txt
    { made two; sh figures/30/30-two-sizes.sh steps $out; } >$figures/30/30-two-steps.txt
}

# Case 2 again, Fig. 7: what moves the grains at the lower sensor?
sensor() {
    at="position=[0.02,0.002,0.00375]"
    probes="{field=\"p\";$at;},{field=\"p\";position=[0.02,0.15,0.00375];},{field=\"us_y\";$at;}"
    probes="$probes,{field=\"us_y\";position=[0.02,0.01,0.00375];},{field=\"us_y\";position=[0.02,0.025,0.00375];}"
    probes="$probes,{field=\"eps_f\";$at;},{field=\"eps_f\";position=[0.02,0.02,0.00375];}"
    tried=
    try() { # NAME OVERRIDES...
        tried="$tried $1"
        name=$1
        shift
        run "sensor-$name" "$scene" -s particles.grains.stiffness=500 \
            -s particles.step=1.2e-5 -s output.end=1.5 -s "output.probes=($probes)" "$@"
    }
    scene=cases/fluidization-two-sizes.cfg
    try kernel
    try kernel-5mm -s averaging.bandwidth=0.005
    try kernel-3mm -s averaging.bandwidth=0.003
    try linear -s averaging.interpolation=linear
    try coarse -s "mesh.cells=[8,40,1]"
    try sums -s averaging.method=pcm
    try frictionless -s particles.grains.friction=0.0
    try seed -s particles.bed.seed=2
    try gidaspow -s exchange.drag=gidaspow
    for U in 1.15 1.3 1.5; do try $U -s fluid.bottom.inlet=$U; done
    sed '/front_back/d' cases/fluidization-two-sizes.cfg >$out/periodic.cfg
    scene=$out/periodic.cfg
    try periodic -s "mesh.periodic=[false,false,true]"
    # shellcheck disable=SC2086
    { made sensor; sh figures/30/30-sensor.sh $out $tried; } >$figures/30/30-sensor.txt
}

# Case 1, Figs. 4 and 5, with springs ten times as soft. (30-ramp-stiff.txt is the
# same without them; half an hour.) PCM's uneven cells need shorter steps of the fluid; that
# run is of the ramp from 5 s on.
ramp() {
    ramp="cases/fluidization-ramp.cfg -s particles.grains.stiffness=500 -s particles.step=1.2e-5"
    fine="-s mesh.cells=[25,100,1]"
    # shellcheck disable=SC2086
    {
        run ramp-stiff cases/fluidization-ramp.cfg
        run ramp-15x75 $ramp
        run ramp-seed2 $ramp -s particles.bed.seed=2 -s output.end=15
        run ramp-25x100 $ramp $fine -s output.end=15
        run ramp-pcm-25x100 $ramp $fine -s averaging.method=pcm -s fluid.step=2e-4 \
            -s "fluid.bottom.inlet=([0.0,0.5],[10.0,1.5])" -s output.end=10
    }
    for name in stiff 15x75 seed2 25x100 pcm-25x100; do
        # shellcheck disable=SC2046,SC2086 # a word or none
        sh figures/30/30-ramp.sh series $out ramp-$name $([ $name != pcm-25x100 ] || echo 5) \
            >$figures/30/30-ramp-$name.txt
    done
    set -- $figures/30/30-ramp-stiff.txt $figures/30/30-ramp-15x75.txt $figures/30/30-ramp-seed2.txt \
        $figures/30/30-ramp-25x100.txt $figures/30/30-ramp-pcm-25x100.txt
    { made ramp; sh figures/30/30-ramp.sh numbers "$@"; } >$figures/30/30-ramp-numbers.txt
}

# Case 4, Figs. 10 and 11.
seepage() {
    run seepage cases/seepage.cfg
    { made seepage; $python figures/30/30-classes.py heights $out/seepage; } >$figures/30/30-seepage.txt
}

# Case 4 again, all grains from one bed: with springs of 50 N/m, with ten times as
# stiff ones, and with 50 N/m once more, 1 um beside.
springs() {
    stiff="-s particles.grains.stiffness=500 -s particles.step=1.6e-7"
    # shellcheck disable=SC2086
    {
        run poured cases/seepage.cfg $stiff -s output.end=1e-3
        $python figures/30/30-classes.py scene $out/poured 0.0 >$out/placed.cfg
        $python figures/30/30-classes.py scene $out/poured 1e-6 >$out/moved.cfg
        run k500 $out/placed.cfg $stiff -s output.end=0.3
        run k50 $out/placed.cfg -s output.end=0.3
        run k50-moved $out/moved.cfg -s output.end=0.3
    }
    set -- $out/k50 $out/k50-moved $out/k500
    { made springs; $python figures/30/30-classes.py compare "$@"; } >$figures/30/30-springs.txt
}

# Who carries the bed of Case 1.
weight() {
    if [ -z "${END:-}" ]; then sh chapters/tools/transcript.sh figures/30/30-weight.txt
    else sh figures/run.sh figures/30/30-weight.c -- "$END" 1.0; fi
}

[ $# -gt 0 ] || set -- two sensor ramp seepage springs weight
for part in "$@"; do $part; done
