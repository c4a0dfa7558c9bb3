#!/bin/sh
# What accuracy costs: error beside seconds and beside instructions.
#
#   sh figures/19-cost.sh
#
# The instructions of the steps are counted by valgrind, once a setting, with a
# library compiled for any x86-64 of 2013 or later (AVX2), which is what valgrind
# knows. They are the same on every machine with the same compiler.
set -eu
command -v valgrind >/dev/null || { echo "needs valgrind" >&2; exit 1; }
export OMP_NUM_THREADS=1
library=build/count/libwinnow.a
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

make -s "$library" B=build/count TUNE=-march=x86-64-v3 WIDE= >/dev/null
sh figures/run.sh figures/19-cost.c -- times >"$work/times"
${CC:-cc} -std=c11 -D_POSIX_C_SOURCE=200809L -ffp-contract=off -O2 -fopenmp \
    -Isrc -o "$work/cost" figures/19-cost.c "$library" -lconfig -lgsl -lgslcblas -lz -lm
# One count a fluid_free: of the steps of this fluid.
valgrind -q --tool=callgrind --toggle-collect=fluid_step \
    --dump-after=fluid_free --callgrind-out-file="$work/out" \
    "$work/cost" once >"$work/once"
for i in $(seq "$(wc -l <"$work/once")"); do
    awk '/^(totals|summary):/ { n = $2 } END { print n }' "$work/out.$i"
done >"$work/counts"

echo "# question setting cells_a_side courant error seconds instructions"
paste -d ' ' "$work/times" "$work/counts"
