#!/bin/sh
# What a particle costs in a step, against how many there are: settled beds of
# 9240 to 921 600 spheres, one thread, nanoseconds of processor time; of long
# runs less short ones, the least of several rounds.
#
#   sh tests/bench/cost.sh build/tests/bench [ROUNDS]      (part of make bench)
set -eu
dem=$1/dem
rounds=${2:-3}
out=$1/run
export OMP_NUM_THREADS=1
mkdir -p "$out"

spent() { # command...: seconds of the processor
    times >"$out/before"
    "$@" >/dev/null
    times >"$out/after"
    cat "$out/before" "$out/after" | awk '
        NR == 2 || NR == 4 { split($1, u, /[ms]/); split($2, s, /[ms]/)
            t = 60 * (u[1] + s[1]) + u[2] + s[2]
            if (NR == 2) begun = t; else print t - begun }'
}

round=0
while [ $round -lt "$rounds" ]; do
    round=$((round + 1))
    for beds in 1 2 3 4 6 8 10; do
        data=$out/cost-$beds.data
        [ -s "$data" ] || "$dem" bed hertz "$data" $beds 0 >&2
        n=$(awk 'NR == 3 { print $1; exit }' "$data")
        steps=$((50 + 10000000 / n))
        spent "$dem" run hertz "$data" 100 >"$out/short"
        spent "$dem" run hertz "$data" $((100 + 100 * (steps / 100 + 1))) >"$out/long"
        echo "$n $((100 * (steps / 100 + 1))) $(cat "$out/short" "$out/long" | tr '\n' ' ')"
    done
done | awk '
{ if (!($1 in steps)) order[++k] = $1
  steps[$1] = $2
  if (!($1 in short) || $3 < short[$1]) short[$1] = $3
  if (!($1 in long) || $4 < long[$1]) long[$1] = $4 }
END {
    print "# spheres, ns a particle and step"
    for (i = 1; i <= k; i++) {
        n = order[i]
        ns[i] = 1e9 * (long[n] - short[n]) / n / steps[n]
        printf "%7d %.1f\n", n, ns[i]
    }
    printf "# growth = %.2f\n", ns[k] / ns[1]
}'
