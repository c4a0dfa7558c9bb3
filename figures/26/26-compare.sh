#!/bin/sh
# The whole comparison of the ways of averaging, before any run: tables of one
# layout and of a snapshot of a bed, the turned mesh, and the fields of each method in a picture.
#
#   sh figures/26/26-compare.sh
. "$(dirname "$0")/../here.sh"
export OMP_NUM_THREADS=1
for name in slot table-bed turn; do
    sh chapters/tools/transcript.sh figures/26/26-$name.txt
done
sh figures/run.sh figures/26/26-compare.c -- picture slot >figures/26/26-fields.txt
gnuplot figures/26/26-fields.gp
