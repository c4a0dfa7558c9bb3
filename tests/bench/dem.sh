#!/bin/sh
# Our particles beside LAMMPS and LIGGGHTS, where these are installed (Debian
# packages lammps and liggghts; nothing is installed here). The same bed, walls,
# list, step and law, in turn, and the median of the ratios of each turn.
#
#   sh tests/bench/dem.sh build/tests/bench [ROUNDS]      (make bench)
#
# A run is timed less a short one, so that reading and starting do not count;
# on a machine with other work, BENCH_TIME=cpu counts processor time instead of
# wall time, which is no measure for two threads.
set -eu
dem=$1/dem
rounds=${2:-3}
here=$(dirname "$0")
out=$1/run
rates=$out/dem-rates.txt
export OMP_NUM_THREADS=1
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1

# The scenes: name, law, beds in each direction, speed [m/s], steps to begin
# with, steps that count.
scenes=${BENCH_SCENES:-'settled-9240 hertz 1 0 2000 5000
settled-331776 hertz 6 0 100 200
thrown-9240 hertz 1 0.2 0 5000
thrown-331776 hertz 6 0.2 0 200
linear-settled-9240 linear 1 0 2000 5000
linear-settled-331776 linear 6 0 100 200
linear-thrown-9240 linear 1 0.2 0 5000
linear-thrown-331776 linear 6 0.2 0 200'}

there() {
    case $1 in
    winnow | winnow-2) true ;;
    lammps) command -v lmp >/dev/null ;;
    lammps-2) command -v lmp >/dev/null && command -v mpirun >/dev/null ;;
    liggghts) command -v liggghts >/dev/null ;;
    esac
}

seconds() { # sets now: of the clock, or of the processor in all that ran here
    if [ "${BENCH_TIME:-wall}" = cpu ]; then
        times >"$out/times" # not in a subshell, which would start at 0
        now=$(awk 'NR == 2 { split($1, u, /[ms]/); split($2, s, /[ms]/)
                   print 60 * (u[1] + s[1]) + u[2] + s[2] }' "$out/times")
    else
        now=$(date +%s.%N)
    fi
}

once() { # program law data steps beds
    case $1 in
    winnow) "$dem" run "$2" "$3" "$4" ;;
    winnow-2) OMP_NUM_THREADS=2 OMP_PROC_BIND=true "$dem" run "$2" "$3" "$4" ;;
    lammps)
        lmp -in "$here/lammps.in" -log none -var law "$2" -var data "$3" \
            -var steps "$4"
        ;;
    lammps-2)
        mpirun -np 2 --bind-to core lmp -in "$here/lammps.in" -log none \
            -var law "$2" -var data "$3" -var steps "$4" -var ranks 2
        ;;
    liggghts)
        case $2 in linear) model=hooke/stiffness ;; *) model=$2 ;; esac
        liggghts -in "$here/liggghts.in" -log none -var model "$model" \
            -var data "$3" -var steps "$4" \
            -var X "$(awk "BEGIN { print 0.044 * $5 }")" \
            -var Y 0.12 -var Z "$(awk "BEGIN { print 0.01 * $5 }")"
        ;;
    esac >"$out/$1.log" 2>&1 || {
        echo "$1 failed: $out/$1.log" >&2
        return 1
    }
}

# What each must agree on: contacts a particle, mean height [mm], rms speed.
state() {
    case $1 in
    winnow*) awk '{ print $2, $3, $4 }' "$out/$1.log" ;;
    *) awk '/^Loop time/ { print last } NF == 5 {
        last = sprintf("%.3f %.4f %.3g", $3, $4, $5) }' "$out/$1.log" ;;
    esac
}

measure() { # program scene law data beds before steps
    seconds; start=$now
    once "$1" "$3" "$4" "$6" "$5" || return 0
    seconds; middle=$now
    once "$1" "$3" "$4" $(($6 + $7)) "$5" || return 0
    seconds; end=$now
    n=$(awk 'NR == 3 { print $1; exit }' "$4")
    # shellcheck disable=SC2046 # three words
    echo "$1 $2" $(state "$1") "$start $middle $end $n $7" | awk '{
        printf "%s %s %s %s %s %.4g\n", $2, $1, $3, $4, $5,
               1e-6 * $9 * $10 / (($8 - $7) - ($7 - $6)) }'
}

mkdir -p "$out"
: >"$rates"
for program in lammps liggghts; do
    there $program || echo "$program is not installed: left out"
done
echo "$scenes" | while read -r name law beds throw before steps; do
    data=$out/$name.data
    [ -n "$(find "$data" -newer "$dem" 2>/dev/null)" ] ||
        OMP_NUM_THREADS=$(nproc) "$dem" bed "$law" "$data" "$beds" "$throw"
done
round=0
while [ $round -lt "$rounds" ]; do
    round=$((round + 1))
    echo "$scenes" | while read -r name law beds throw before steps; do
        for program in ${BENCH_PROGRAMS:-winnow lammps liggghts winnow-2 lammps-2}; do
            there "$program" || continue
            measure "$program" "$name" "$law" "$out/$name.data" "$beds" \
                "$before" "$steps" </dev/null | tee -a "$rates" | sed 's/^/  /' >&2
        done
    done
done
awk -f "$here/ratios.awk" "$rates"
