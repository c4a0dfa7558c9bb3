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

# What each of them keeps from step to step stands in its first line.
cp "$top"/tests/data/kills/* .
. "$top/tests/alike.inc"
scaled dual dual

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
echo "$made kills: $resumed runs have the same bits, $refused say why not"
echo "$lost files were lost, one after the other"
echo "kills: $((made + lost - failed)) passed, $failed failed"
[ $failed -eq 0 ]
