#!/bin/sh
# The figures of SX15 and XS11 that are studies (cases/studies): hours. What has ended
# is not done again, so that a run that was stopped goes on. The tables go to
# out/study-NAME/study.md.
#
#   sh tests/validate/studies.sh build/winnow [NAME ...]
set -eu
PATH=$(cd "$(dirname "$1")" && pwd):$PATH
shift
[ $# -gt 0 ] || set -- sx15-bandwidth sx15-vertical xs11-seepage
for name; do
    if [ "$name" = sx15-vertical ]; then # it looks at the runs of sx15-mesh
        winnow study "cases/studies/$name.cfg" -o out/study-sx15-mesh
        mkdir -p "out/study-$name"
        cp out/study-sx15-mesh/study.* "out/study-$name"
        name=sx15-mesh
    fi
    winnow study "cases/studies/$name.cfg" -o "out/study-$name"
done
