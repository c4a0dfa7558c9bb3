#!/bin/sh
# Lets the real VTK readers read what the program writes: samples of every kind of array,
# and the runs of tests/data/vtk: three spheres in a little air among surfaces; cells of
# every kind; spheres that touch, one across a periodic end, one that falls on the floor
# and one on a shelf, with all that particles.vtp can hold; the same eight spheres in the
# middle of a periodic box and across its corners. Two of them as unstructured grids, too,
# for readers that know only these.
#
#   sh tests/vtk.sh build        (after the build of program and tests)
set -eu
build=${1:-build}
python=/usr/bin/python3 # Debian's own, which python3-vtk9 belongs to
[ -x $python ] || python=$(command -v python3) || {
    echo "vtk_check: no Python here, left out"
    exit 0
}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
run() { # CASE FOLDER OVERRIDES...
    case=tests/data/vtk/$1.cfg folder=$work/$2
    shift 2
    "$build/winnow" run "$case" -o "$folder" --quiet "$@" >"$work/said" 2>&1 || { cat "$work/said"; exit 1; }
}

mkdir "$work/samples"
"$build/tests/test_vtk" "$work/samples"
for name in tiny sheared dual pressed heap-here heap-moved; do run $name $name; done
for name in tiny pressed; do run $name $name-grids -s 'output.format="vtu"'; done
cd "$work"
$python "$OLDPWD/tests/vtk_check.py" samples tiny sheared dual pressed heap-here heap-moved tiny-grids pressed-grids
