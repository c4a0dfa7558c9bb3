#!/bin/sh
# Every two values of every two choices of a case meet in one run at least: the
# program refuses it for a reason that is known, or runs it and the sums hold.
#
#   sh tests/pairs.sh build/winnow          (one case of twelve)
#   sh tests/pairs.sh build/winnow all      (all of them, some hundreds)
#   sh tests/pairs.sh build/winnow all 7    (others, from another seed)
#
# What fails is kept, with the line that repeats it.
set -u
winnow=$(cd "$(dirname "${1:-build/winnow}")" && pwd)/winnow
part=${2:-slice}
seed=${3:-1}
top=$PWD
parts=$top/tests/pairs
# Threads that wait should not keep others from working on a busy machine.
export OMP_WAIT_POLICY=passive
# Each case is run with one thread and with two: no more than two at a time.
jobs=2

# What a case may be refused for that no two of its choices decide. (A sheared box
# has an oblique period in y, which no flow along y can be driven round; an oblique
# cylinder fills a thin mesh.)
known='y is not periodic, so (nothing|no mean flow) can be driven|begins .* (from|deep in) the surface|the bed does not fit|they cut an inlet off'

. tests/alike.inc

# The meshes and surfaces that cases name.
meshes() {
    scaled dual "$work/dual"
    scaled cyclic "$work/cyclic"
    scaled sheared "$work/slanted"
    printf '%s\n' "solid a" "facet normal 0 1 0" "outer loop" \
        "vertex -0.8 0 -0.8" "vertex 0.8 0 -0.8" "vertex 0 0 0.8" "endloop" \
        "endfacet" "endsolid a" >"$work/sheet.stl"
    printf '%s\n' "-0.0005 0 0 0.0047" "0.0005 0 0 0.0047" >"$work/pair.spheres"
    awk 'function corner(k, s) { # on axis k, 2.6 mm from the middle
             print "vertex", k == 0 ? s : 0, k == 1 ? s : 0, k == 2 ? s : 0
         }
         BEGIN {
             print "solid a"
             for (o = 0; o < 8; o++) {
                 x = o % 2 ? 2.6 : -2.6; y = int(o / 2) % 2 ? 2.6 : -2.6
                 z = o > 3 ? 2.6 : -2.6
                 print "facet normal 0 0 0\nouter loop"
                 corner(0, x)
                 if (x * y * z > 0) { corner(1, y); corner(2, z) } else { corner(2, z); corner(1, y) }
                 print "endloop\nendfacet"
             }
             print "endsolid a"
         }' >"$work/eight.stl"
}

# One array after the other, two at a time.
generate() {
    for array in c p f m; do
        echo $array
    done | xargs -P $jobs -I{} sh -c "mkdir $work/{} &&
        awk -v letter={} -v seed=$seed -v folder=$work/{} -v winnow=$winnow -v parts=$parts \
        -f $parts/array.awk -f $parts/keys.awk -f $parts/choices.awk -f $parts/case.awk" || return
    for array in c p f m; do
        cat "$work/$array/list" && mv "$work/$array"/*-* "$work"
    done >"$work/list"
    awk -v "winnow=$winnow" -f "$parts/tried.awk" "$parts/untried.txt" "$work"/*.cfg "$work"/*.set
}

# With two threads, stopped on the way and resumed with a later end; in one piece
# where the step of the loop follows from the end. Prints why it was not resumed.
second_run() { # name
    name=$1
    # shellcheck disable=SC2046 # words
    set -- "$winnow" run "$1.cfg" $(cat "$1.set") -o "$1.2" -j 2 --quiet
    PATH=/none "$@" -s output.end=8e-4 >"$name.second" 2>&1 &&
        PATH=/none "$@" --resume >"$name.second" 2>&1 && return
    grep -q 'step_of_the_loop\|before its first step' "$name.second" || cat "$name.second"
    PATH=/none "$@" >/dev/null 2>&1
}

# What is wrong with a run of the case, if anything.
verdict() { # name, code, why
    if [ -n "$3" ]; then
        [ "$2" -eq 2 ] || echo "exit code $2, should be refused: $3"
        grep -qE "$3|$known" "$1.said" || echo "not refused for: $3"
        [ ! -e "$1.1" ] || echo "refused, and $1.1 is there"
    elif [ "$2" -eq 2 ]; then
        grep -qE "$known" "$1.said" || echo "refused for no known reason"
    elif [ "$2" -ne 0 ]; then
        echo "exit code $2"
    else
        line=$(grep "^$1 " list)
        awk -F, -v line="$line" -f "$parts/verdict.awk" "$1.1/history.csv"
        second_run "$1"
        same "$1.1" "$1.2" || echo "one thread, and two that were interrupted, differ"
    fi
}

# Without gnuplot: pictures are drawn elsewhere.
one() { # name
    cd "$work" || exit
    why=$(sed -n "s/^$1 .* # //p" list)
    overrides=$(cat "$1.set")
    # shellcheck disable=SC2086 # words
    PATH=/none "$winnow" run "$1.cfg" $overrides -o "$1.1" -j 1 --quiet >"$1.said" 2>&1
    verdict "$1" $? "$why" >"$1.wrong" 2>&1
    if [ -s "$1.wrong" ]; then
        echo "FAILED $(grep "^$1 " list)"
        sed 's/^/    /' "$1.wrong" "$1.said" | head -20
        echo "    cd $work && $winnow run $1.cfg$overrides -o $1.1 -j 1"
        echo "$1" >>failed
    else
        rm -rf "$1.1" "$1.2" "$1".1.told "$1".2.told "$1.second"
    fi
}

# The script calls itself for each case.
if [ "$part" = one ]; then
    work=$4
    one "$3"
    exit
fi

work=$(mktemp -d)
meshes
generate || exit
every=1
[ "$part" = all ] || every=12
awk -v every=$every 'NR % every == 1 % every { print $1 }' "$work/list" \
    >"$work/chosen"
xargs -P $jobs -I{} sh "$0" "$1" one {} "$work" <"$work/chosen"
ran=$(wc -l <"$work/chosen")
failed=0
if [ -e "$work/failed" ]; then
    failed=$(wc -l <"$work/failed")
    echo "the cases that failed are in $work"
else
    rm -rf "$work"
fi
echo "pairs of choices, seed $seed: $((ran - failed)) passed, $failed failed"
[ "$failed" -eq 0 ]
