#!/bin/sh
# What a checkpoint costs: its size, and the processor time that one takes, from
# runs that write one after each step and runs that write one at each end.
. "$(dirname "$0")/../here.sh"
mkdir -p out
export XDG_CACHE_HOME="$PWD/out/cache"
seconds() { # CASE EVERY OPTIONS...: user and system, of the process
    case=$1 every=$2
    shift 2
    OMP_NUM_THREADS=1 bash -c 'TIMEFORMAT="%U %S"; time "$@" >out/said 2>&1' - \
        winnow run "cases/$case.cfg" -o out/cost --quiet \
        -s "output.checkpoint=$every" "$@" 2>&1 | awk '{ print $1 + $2 }'
}
echo "# particles, cells, steps, size [MB], a checkpoint [ms], a step [ms]"
one() { # CASE STEPS END OPTIONS...
    case=$1 steps=$2
    shift 2
    seconds "$case" 1e9 "$@" >out/warm # settles the bed, once
    few=$(seconds "$case" 1e9 "$@" -s output.every=1)
    many=$(seconds "$case" 1e-9 "$@" -s output.every=1)
    awk -v few="$few" -v many="$many" -v steps="$steps" \
        -v bytes="$(wc -c <out/cost/checkpoint)" '
        /"particles":/ { n = $2 + 0 } /"cells":/ { c = $2 + 0 }
        /"dem":|"cfd":|"averaging":|"exchange":/ && $2 + 0 > 0 { s += $2 }
        END { printf "%d %d %d %.2f %.1f %.1f\n", n, c, steps, bytes / 1e6,
              1e3 * (many - few) / steps, 1e3 * s / steps }' out/cost/summary.json
}
one small-bed 250 -s output.end=0.05
one mueller-bed 50 -s output.end=0.01
