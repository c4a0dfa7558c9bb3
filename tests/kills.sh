#!/bin/sh
# Runs that are killed at any moment go on to the same bits: each case is run in
# one piece, and then stopped at random moments, by a signal, by kill -9, on a
# full disk, or by the loss of its folder, and resumed with another number of
# threads. Whatever happens, the resumed run has the same files, bit for bit, or
# says in one line why it cannot go on. The same holds where a file of a run that
# has ended is lost.
#
#   sh tests/kills.sh build/winnow          (one kill of each case)
#   sh tests/kills.sh build/winnow 40       (40 of each, and of a bed that
#                                            settles: 240 in all)
#   sh tests/kills.sh build/winnow 40 7     (at other moments)
#   sh tests/kills.sh build/winnow 40 7 fed (of one case)
set -u
winnow=$(cd "$(dirname "${1:-build/winnow}")" && pwd)/winnow
kills=${2:-1}
seed=${3:-1}
top=$PWD
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
failed=0
made=0
resumed=0
refused=0
export OMP_WAIT_POLICY=passive
export XDG_CACHE_HOME=$work/cache

# --- the cases: what each of them keeps from step to step ---------------------

box='mesh = { size = [0.012, 0.024, 0.006]; cells = [6, 12, 3]; };'
air='fluid = { density = 1.2; viscosity = 1.8e-5; step = 2e-4;
    bottom = { inlet = ((0.0, 0.2), (0.02, 0.8)); }; top = { outlet = 0.0; };
    sides = "no-slip"; front_back = "slip";'
grains='grains = { density = 1000; stiffness = 100; restitution = 0.9;
    friction = 0.3; rolling_friction = 0.05; };'

# The past of BDF2, averaging by diffusion, a settled bed, forces with a memory,
# statistics of each grain.
cat >coupled.cfg <<END
title = "a bed in air";
$box
$air time = "bdf2"; };
particles = { contact = "linear"; step = 1e-5; $grains
    bed = { count = 120; diameter = 1.2e-3; seed = 1; }; };
averaging = { method = "diffusion"; bandwidth = 4e-3; };
exchange = { drag = "gidaspow"; slip_integration = "exponential"; };
effects = { gravity = [0.0, -9.81, 0.0]; pressure_gradient = {};
    virtual_mass = {}; basset = {}; time_average = { time = 0.01; };
    energy_budget = {}; };
output = { end = 0.015; every = 0.0015; animation = true;
    profiles = ( { field = "eps_f"; height = 0.003; from = 0.005; } );
    probes = ( { field = "p"; position = [0.006, 0.012, 0.003]; } );
    statistics = { from = 0.005; blocks = 2; lags = 0.002; }; contacts = true; };
END

# Who comes and goes, moving walls, a prescribed particle, random places.
cat >fed.cfg <<END
title = "grains that come and go";
$box
particles = { contact = "linear"; step = 5e-6; $grains
    place = ( { position = [0.006, 0.012, 0.003]; diameter = 1e-3; } );
    insert = ( { count = 4000; diameter = 8e-4; rate = 2e4; seed = 3;
        from = [0.0, 0.018, 0.0]; to = [0.012, 0.024, 0.006];
        velocity = [0.0, -0.5, 0.0]; } );
    sinks = ( { side = "bottom"; } );
    prescribed = ( { id = 0; amplitude = [2e-3, 0.0, 0.0]; frequency = 50.0; } );
    surfaces = ( { name = "ramp"; shape = "plane"; point = [0.0, 0.004, 0.0];
        normal = [1.0, 2.0, 0.0]; amplitude = [0.0, 1e-3, 0.0];
        frequency = 40.0; } ); };
effects = { gravity = [0.0, -9.81, 0.0]; };
output = { end = 0.03; every = 0.003; history = 3e-4; };
END

# Polyhedral cells, particles removed from a flow, the kernel method.
mkdir dual
cp "$top"/tests/data/poly/dual/* dual
awk '/^\([-0-9.e ]*\)$/ {
         gsub(/[()]/, "")
         $0 = sprintf("(%.12g %.12g %.12g)", 0.012 * $1, 0.012 * $2, 0.012 * $3)
     }
     { print }' "$top/tests/data/poly/dual/points" >dual/points
cat >cells.cfg <<END
title = "polyhedral cells";
mesh = { polymesh = "dual"; };
particles = { contact = "hertz"; step = 1e-5;
    grains = { density = 1000; young = 1.2e5; poisson = 0.3; restitution = 0.9;
        friction = 0.3; };
    bed = { count = 60; diameter = 1.2e-3; seed = 2; }; };
effects = { gravity = [0.0, -9.81, 0.0]; };
output = { end = 0.025; every = 0.0025; history = 5e-4; };
END

# The readable loop, several materials and an attraction, round a period.
cat >linked.cfg <<END
title = "cells that are linked";
mesh = { size = [0.012, 0.012, 0.006]; cells = [4, 4, 2]; periodic = [true, false, true]; };
particles = { contact = "hertz"; step = 1e-5; list = "link-cells";
    grains = { density = 1000; young = 1.2e5; poisson = 0.3; restitution = 0.9;
        friction = 0.3; };
    bed = { count = 100; diameter = 1e-3; seed = 2; settle = 0.0; }; };
effects = { gravity = [2.0, -9.81, 0.0];
    van_der_waals = { hamaker = 1e-19; range = 1e-5; }; };
output = { end = 0.015; every = 0.0015; history = 3e-4; };
END

# A flow alone, whose steps are divided, with outer iterations.
cat >flow.cfg <<END
title = "a flow alone";
mesh = { size = [0.012, 0.024, 0.006]; cells = [8, 16, 4]; };
$air time = "bdf2"; convection = "van-leer"; outer_correctors = 1; cfl = 0.5; };
output = { end = 0.03; every = 0.003;
    profiles = ( { field = "u_y"; height = 0.012; from = 0.01; } ); };
END

# A bed of several sizes that settles on a sheet for longer than it runs.
cat >sheet.stl <<END
solid sheet
facet normal 0 1 0
outer loop
vertex -0.8 0.000003 -0.8
vertex 0.8 0.000005 -0.8
vertex 0 0.000005 0.8
endloop
endfacet
endsolid sheet
END
cat >settling.cfg <<END
title = "a bed that settles";
mesh = { size = [0.03, 0.03, 0.03]; cells = [3, 3, 3]; };
particles = { contact = "linear"; step = 1e-5; $grains
    sizes = ( { name = "s"; distribution = "uniform"; min = 1.1e-3; max = 1.6e-3; } );
    surfaces = ( { name = "sheet"; shape = "stl"; file = "sheet.stl"; } );
    bed = { count = 2000; sizes = "s"; seed = 1; jitter = 0.0; settle = 0.1; }; };
effects = { gravity = [0.0, -9.81, 0.0]; };
output = { end = 0.001; every = 0.001; };
END

# A bed that is worth keeping.
cat >wide.cfg <<END
title = "a wide bed";
mesh = { size = [0.06, 0.012, 0.06]; cells = [6, 2, 6]; };
particles = { contact = "linear"; step = 1e-5; $grains
    bed = { count = 2000; diameter = 1.2e-3; seed = 1; }; };
effects = { gravity = [0.0, -9.81, 0.0]; };
output = { end = 0.001; every = 0.001; };
END

# --- one kill ----------------------------------------------------------------

# A number between 0 and 1 that depends on the seed, the case and the kill.
chance() { # number
    awk -v n="$1" -v s="$seed" 'BEGIN { srand(1000 * s + n); rand(); print rand() }'
}

# In the foreground `timeout` waits for what it killed: a process holds the lock
# on its folder until the last of its threads is gone.
run() { # seconds, signal, case, folder, options...
    for_long=$1 signal=$2 name=$3 folder=$4
    shift 4
    rm -rf cache
    timeout --foreground -s "$signal" "$for_long" env PATH=/none "$winnow" \
        run "$name.cfg" -o "$folder" -s output.checkpoint=0.02 --quiet "$@" \
        >out 2>said
}

# Everything that two runs wrote but the time that they took.
same() { # folder, folder
    diff -rq -x summary.json -x 'checkpoint*' -x gnuplot.log -x '*.png' \
        -x '*.gif' "$1" "$2" &&
        for folder in "$1" "$2"; do
            sed '/seconds": {/,/}/d; /"threads"/d; /peak_memory/d; /_per_second/d' \
                "$folder/summary.json" >"$folder.told"
        done && diff "$1.told" "$2.told"
}

wrong() { # what
    echo "FAILED $name, kill $kill by $how after $moment s: $1"
    cat said
    failed=$((failed + 1))
}

stop() { # by what, after how long; the run is in the folder part
    case $1 in
    KILL | TERM | HUP) run "$2" "$1" "$name" part -j $threads $resume ;;
    disk) (
        ulimit -f $((4 + kill % 40))
        run "$2" KILL "$name" part -j $threads $resume
    ) ;;
    folder)
        run "$2" KILL "$name" part -j $threads $resume
        find part -type f | sort | awk -v r="$(chance $((kill + 7)))" \
            '{ f[NR] = $0 } END { print f[1 + int(r * NR)] }' | xargs rm -f
        ;;
    esac
}

# Stops the run twice, then lets it go on to its end.
kill_once() {
    how=$(echo KILL TERM disk KILL HUP folder |
        awk -v k="$kill" '{ print $(1 + k % NF) }')
    rm -rf part
    resume=
    for turn in 1 2; do
        moment=$(awk -v T="$whole" -v r="$(chance $((10 * kill + turn)))" \
            'BEGIN { printf "%.3f", 0.02 + r * T * 0.7 }')
        threads=$((1 + (kill + turn) % 2))
        stop "$how" "$moment" 2>/dev/null
        [ ! -e part/checkpoint ] && [ ! -e part/checkpoint.ahead ] ||
            resume=--resume
    done
    run 600 KILL "$name" part -j 1 $resume
    code=$?
    if [ $code -ne 0 ]; then
        # Why not, in one line, and only after a loss.
        grep -c '^winnow: ' said | grep -qx '[12]' && [ "$how" = folder ] ||
            wrong "exit code $code"
        refused=$((refused + 1))
    elif same full part >differ 2>&1; then
        resumed=$((resumed + 1))
    else
        cat differ >>said
        wrong "the files differ"
    fi
}

# Of a run that has ended, one file after the other is lost, one of each name but
# for its number. The run that is resumed then makes it again, or says in one line
# that it cannot.
lose_each() {
    (cd full && find . -type f | sort) |
        awk '{ alike = $0; gsub(/[0-9]+/, "0", alike) } !seen[alike]++' >files
    while read -r file; do
        rm -rf part
        cp -r full part
        rm "part/$file"
        lost=$((lost + 1))
        run 600 KILL "$name" part -j 1 --resume
        code=$?
        if [ $code -ne 0 ]; then
            [ "$(grep -c '^winnow: ' said)" -eq 1 ] && continue
        elif same full part >differ 2>&1; then
            continue
        fi
        echo "FAILED $name without $file: exit code $code"
        cat said differ
        failed=$((failed + 1))
    done <files
}

kill=0
lost=0
[ $# -lt 4 ] || kill=$((seed - 1)) # other ways to stop, too
names="coupled fed cells linked flow"
[ "$kills" -eq 1 ] || names="$names settling"
for name in ${4:-$names}; do
    rm -rf full
    began=$(date +%s%N)
    run 600 KILL $name full -j 1 || { echo "FAILED $name" && cat said && exit 1; }
    whole=$(awk -v n=$(($(date +%s%N) - began)) 'BEGIN { print n / 1e9 }')
    n=0
    while [ $n -lt "$kills" ]; do
        n=$((n + 1))
        kill=$((kill + 1))
        made=$((made + 1))
        kill_once
    done
    [ "$kills" -eq 1 ] && [ "$name" != fed ] || lose_each
done
facts=$((made + lost - failed))
# Prints the sum and ends.
finish() {
    echo "$made kills: $resumed runs have the same bits, $refused say why not"
    echo "$lost files were lost, one after the other"
    echo "kills: $facts passed, $failed failed"
    [ $failed -eq 0 ]
    exit
}
[ $# -lt 4 ] || finish

# --- what a folder says, and a bed that was settled before ---------------------

# check WHAT COMMAND...: the command succeeds.
check() {
    what=$1
    shift
    "$@" >out 2>said && facts=$((facts + 1)) && return
    echo "FAILED $what:" && cat out said
    failed=$((failed + 1))
}
# says TEXT COMMAND...: whatever its exit code.
says() {
    text=$1
    shift
    "$@" 2>&1 | grep -q -- "$text"
}
short() {
    env PATH=/none "$winnow" run "$@" --quiet
}
# One byte of a file is another one.
damage() {
    printf 'X' | dd of="$1" bs=1 seek=3000 conv=notrunc 2>/dev/null
}

check "a run for a copy" short flow.cfg -o was -s output.end=0.003
check "the folder has the case" short was/case.cfg -o again
check "which gives the same bits" cmp was/history.csv again/history.csv
check "status of what is done" says 'ended *done' "$winnow" status was
mkdir two-lines
cp was/manifest.txt two-lines
sed 's/"done"/"it broke\\u000aTry again"/' was/summary.json >two-lines/summary.json
check "status of a reason of two lines" says 'ended *it broke Try again' "$winnow" status two-lines
check "and what goes further" says 'go further.*--resume' "$winnow" status was
cp -r was foreign
short linked.cfg -o other -s output.end=1e-4 2>said
cp other/checkpoint foreign/checkpoint
check "status of a folder with the checkpoint of another case" \
    says 'not used *checkpoint is of another case' "$winnow" status foreign
rm foreign/manifest.txt
check "a lost list of files is named" says 'foreign/manifest.txt is not there' \
    "$winnow" run flow.cfg -o foreign --resume
check "status of nothing" says 'not the folder of a run' "$winnow" status .
check "a changed key is refused with both values" says \
    'fluid.density is 2.5 in this case, and 1.2 in that of' \
    "$winnow" run flow.cfg -o was --resume -s fluid.density=2.5
check "another case is refused" says 'is .* in this case, and not set in that' \
    "$winnow" run linked.cfg -o was --resume
check "a run on a mesh" short cells.cfg -o mesh -s output.end=0.0025
echo >>dual/points
check "another mesh is refused" says 'mesh.polymesh is crc32' \
    "$winnow" run cells.cfg -o mesh --resume
check "nothing to resume is said" says 'nothing to resume in empty' \
    "$winnow" run flow.cfg -o empty --resume
check "a second state" short flow.cfg -o was --resume -s output.end=0.006
damage was/checkpoint
check "damage is said, and the state before taken" says \
    'was/checkpoint is not used: it is damaged' \
    "$winnow" run flow.cfg -o was --resume -s output.end=0.009
check "the same from there" short flow.cfg -o whole -s output.end=0.009
check "has the same bits" cmp was/history.csv whole/history.csv
check "and the same means of the second half" same whole was
check "an end that is past is refused" says 'only be continued to a later end' \
    "$winnow" run flow.cfg -o was --resume -s output.end=0.003

# Stops a run as soon as it has saved the bed that settles.
stop_settling() { # signal, folder
    "$winnow" run resting.cfg -o "$2" -s output.checkpoint=0.01 >told 2>&1 &
    while [ ! -e "$2/checkpoint.ahead" ] && kill -0 $! 2>/dev/null; do
        sleep 0.01
    done
    kill -s "$1" $! 2>/dev/null
    wait $! 2>/dev/null
}
sed 's/sizes = ( .*//; s/sizes = "s"/diameter = 1.2e-3/; s/settle = 0.1/settle = 0.02/' \
    settling.cfg >resting.cfg
"$winnow" run resting.cfg -o rest --quiet >out 2>&1
rm -rf cache
stop_settling TERM settles
check "a signal while a bed settles is told" grep -q 'while the bed settled' told
check "status of a bed that settles" says 'its bed settles' "$winnow" status settles
check "it settles on" says 'the bed continues to settle from' \
    "$winnow" run resting.cfg -o settles --resume
check "to the same bits" diff -r rest/particles settles/particles
check "and leaves no state of settling" [ ! -e settles/checkpoint.ahead ]
# The files of an earlier run stay until the next has a state.
short flow.cfg -o kept -s output.end=0.003 >out 2>&1
rm -rf cache
stop_settling KILL kept
check "the run before can go on" short flow.cfg -o kept --resume
short flow.cfg -o whole >out 2>&1
check "with the bits of one piece" cmp kept/history.csv whole/history.csv

check "a bed is settled" says 'settled in' "$winnow" run wide.cfg -o bed1
check "and found again" says 'was settled before' "$winnow" run wide.cfg -o bed2
check "with the same bits" diff -r bed1/particles bed2/particles
for bed in cache/winnow/bed-*; do damage "$bed"; done
check "a damaged one is settled anew" says 'the bed is settled anew' \
    "$winnow" run wide.cfg -o bed4
check "with the same bits again" diff -r bed1/particles bed4/particles
check "or settled anew" says 'settled in' "$winnow" run wide.cfg -o bed3 --fresh
check "or with another key" says 'settled in' \
    "$winnow" run wide.cfg -o bed3 -s particles.bed.seed=2
check "but for other output" says 'was settled before' \
    "$winnow" run wide.cfg -o bed3 -s output.end=0.002

finish
