#!/bin/sh
# The small bed with both forms of continuity and three ways of averaging: how
# far the pressure drop jumps from one step to the next, after the start; how
# much momentum is relabelled; and the worst residual of the momentum balance.
. "$(dirname "$0")/../here.sh"
out=$work

echo 'form      averaging   jump of p [Pa]  relabelled [N s]  residual [-]'
for form in mixture void-rate; do
    for method in pcm kernel diffusion; do
        winnow run cases/small-bed.cfg --quiet -o "$out" \
            -s fluid.continuity=$form -s averaging.method=$method \
            -s output.end=0.1 >/dev/null 2>&1
        columns "$out/history.csv" pressure_drop relabelled_momentum |
            awk -v form=$form -v method=$method -v worst="$(summary "$out" momentum_residual)" '
            NR > 249 { d = $1 - before; sum += d * d * (n++ > 0) }
            { before = $1 }
            END { printf "%-9s %-9s %16.2f %17.1e %13.1e\n", form, method, sqrt(sum / (n - 1)), $2, worst }'
    done
done
