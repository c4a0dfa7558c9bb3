#!/bin/sh
# Builds a small program with Winnow's library, and runs it.
#
#   sh figures/run.sh figures/06-surface.c [PATCH...] [-- ARGUMENT...]
#
# The library is the one that lies beside `winnow`. Files of src/ that a patch
# changes are built anew, changed; the source itself stays as it is.
set -eu
program=$1
shift
library=$(dirname "$(command -v winnow || echo build/winnow)")/libwinnow.a
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

changed=
while [ $# -gt 0 ] && [ "$1" != -- ]; do
    [ -d "$work/src" ] || cp -R src "$work"
    patch -s -p1 -d "$work" <"$1"
    for file in $(sed -n 's|^+++ b/||p' "$1"); do
        case "$changed " in
        *" $work/$file "*) ;;
        *) changed="$changed $work/$file" ;;
        esac
    done
    shift
done
[ $# = 0 ] || shift
# shellcheck disable=SC2046,SC2086 # one word a file
${CC:-cc} -std=c11 -D_POSIX_C_SOURCE=200809L -ffp-contract=off -O2 -fopenmp \
    -Isrc -Itests -o "$work/program" "$program" $changed "$library" ${LIBS:-} \
    $(grep -q '"facts.h"' "$program" && pkg-config --libs check) -lconfig \
    -lgsl -lgslcblas $(pkg-config --libs hdf5 2>/dev/null || echo -lhdf5) -lz -lm
"$work/program" "$@"
