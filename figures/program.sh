#!/bin/sh
# Compiles figures/NAME.c against the library beside winnow, and runs it.
#
#   sh figures/program.sh 08-averaging table
#
# For results that no case gives: a page of C that uses one room alone.
set -eu
build=${BUILD:-build}
name=$1
shift
mkdir -p "$build/figures"
# shellcheck disable=SC2046 # one word a library
${CC:-gcc} -std=c11 -D_POSIX_C_SOURCE=200809L -O2 -ffp-contract=off -fopenmp \
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Isrc -Itests $(pkg-config --cflags hdf5 2>/dev/null) \
    -o "$build/figures/$name" "figures/${name%%-*}/$name.c" \
    "$build/libwinnow.a" -lconfig -lgsl -lgslcblas \
    $(pkg-config --libs hdf5 2>/dev/null || echo -lhdf5) -lz -lm
"$build/figures/$name" "$@"
