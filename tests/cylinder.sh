#!/bin/sh
# The cylinder of Schaefer and Turek [ST96], flow 2D-1, on a mesh that a script
# makes: drag, lift and pressure drop within the bands that they give.
#
#   sh tests/cylinder.sh build/winnow
set -u
winnow=$(cd "$(dirname "${1:-build/winnow}")" && pwd)/winnow
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0
facts=0

mkdir "$work/mesh"
awk -f cases/meshes/extruded.awk -f cases/meshes/cylinder.awk \
    -v out="$work/mesh" -v n=32 -v nr=32 -v nx=64 || exit 1
"$winnow" run cases/meshes/cylinder.cfg -o "$work/run" --quiet \
    -s "mesh.polymesh=$work/mesh" -s output.every=6.0 >/dev/null || exit 1

# fact NAME VALUE FROM TO
fact() {
    if awk "BEGIN { exit !($2 >= $3 && $2 <= $4) }"; then
        facts=$((facts + 1)) && echo "    $1: $2 in $3 to $4"
    else
        echo "FAILED $1: $2 not in $3 to $4"
        failed=$((failed + 1))
    fi
}

last() { tail -n 1 "$work/run/$1" | cut -d, -f"$2"; }
fact st96_2d1_drag_coefficient "$(last forces.csv 13)" 5.57 5.59
fact st96_2d1_lift_coefficient "$(last forces.csv 14)" 0.0104 0.0110
fact st96_2d1_pressure_drop \
    "$(last probes.csv 2-3 | awk -F, '{ print $1 - $2 }')" 0.1172 0.1176
echo "cylinder, 2D-1: $facts passed, $failed failed"
[ $failed -eq 0 ]
