#!/bin/sh
# Builds a small program with Winnow's library, and runs it: for results that no case
# gives, a page of C that uses one module alone.
#
#   sh figures/run.sh figures/06/06-surface.c [PATCH...] [-- ARGUMENT...]
#
# The library is the one that lies beside `winnow`. Files of src/ that a patch
# changes are built anew, changed; the source itself stays as it is.
set -eu
program=$1
shift
library=${BUILD:-build}/libwinnow.a
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

changed=
while [ $# -gt 0 ] && [ "$1" != -- ]; do
    for file in $(sed -n 's|^+++ b/||p' "$1"); do
        case "$changed " in
        *" $file "*) continue ;;
        esac
        changed="$changed $file"
        mkdir -p "$work/${file%/*}" && cp "$file" "$work/$file"
    done
    patch -s -p1 -d "$work" <"$1"
    shift
done
[ $# = 0 ] || shift

# Each file by itself and by the same name every time, so that a compiler's cache
# knows it; gold links in a third of the time.
objects=
top=$PWD
compile() { # file
    objects="$objects $work/$(echo "$1" | tr / _).o"
    # shellcheck disable=SC2046 # one word a flag
    ${CC:-cc} -std=c11 -D_POSIX_C_SOURCE=200809L -ffp-contract=off -O2 -fopenmp -Wall -Wextra \
        -I"$top/src" -I"$top/tests" $(pkg-config --cflags hdf5 2>/dev/null) -c -o "${objects##* }" "$1"
}
compile "$program"
for file in $changed; do
    cd "$work" && compile "$file"
    cd "$top"
done
# shellcheck disable=SC2046,SC2086 # one word a file
${CC:-cc} $(! command -v ld.gold >/dev/null || echo -fuse-ld=gold) -fopenmp \
    -o "$work/program" $objects "$library" ${LIBS:-} \
    $(grep -q '"facts.h"' "$program" && pkg-config --libs check) -lconfig \
    -lgsl -lgslcblas $(pkg-config --libs hdf5 2>/dev/null || echo -lhdf5) -lz -lm
"$work/program" "$@"
