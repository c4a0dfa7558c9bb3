#!/bin/sh
# figures/view.py draws a picture of every kind of output folder, and a film:
# something is there, in the colours that the kind must have, and the box stands
# upright where gravity is along z.
#
#   sh tests/view.sh build        (part of check-slow; needs pvpython and xvfb-run)
set -eu
build=${1:-build}
command -v pvpython >/dev/null && command -v xvfb-run >/dev/null || {
    echo "view: no pvpython or no xvfb-run here, left out"
    exit 0
}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0
look() { # name, how many panels, what must hold
    xvfb-run -a -s -noreset pvpython figures/view.py "$work/$1" "$work/$1.png" >"$work/said" 2>&1 ||
        { cat "$work/said"; failed=1; return; }
    seen=$(xvfb-run -a -s -noreset pvpython tests/view_look.py "$work/$1.png" "$2")
    echo "$seen" | awk "{ ink = \$2; colour = \$4; orange = \$6; tall = \$8; kinds = \$10; exit !($3) }" ||
        { echo "view: $1: $seen, not $3"; failed=1; }
}
for name in grains bodies dual tiny; do
    "$build/winnow" run "tests/data/vtk/$name.cfg" -o "$work/$name" --quiet >"$work/said" 2>&1 || {
        cat "$work/said"
        exit 1
    }
done
look grains one 'ink > 0.01 && colour > 0.005 && tall > 1.9 && tall < 2.1 && kinds > 50'
look bodies two 'orange > 0.01 && colour > 0.05 && tall > 1.5'
look dual one 'ink > 0.1 && colour > 0.1 && kinds > 10'
look tiny two 'colour > 0.03 && tall > 1.5'
xvfb-run -a -s -noreset pvpython figures/view.py "$work/bodies" "$work/film.png" film=1 field=pressure >"$work/said" 2>&1
[ "$(find "$work" -name 'film*.png' | wc -l)" = 3 ] || { echo "view: a film of three states"; failed=1; }
! xvfb-run -a -s -noreset pvpython figures/view.py "$work" "$work/none.png" >"$work/said" 2>&1 &&
    grep -q 'name the output folder' "$work/said" || { echo "view: no run, no word"; failed=1; }
! xvfb-run -a -s -noreset pvpython figures/view.py "$work/dual" "$work/none.png" field=colour >"$work/said" 2>&1 &&
    grep -q 'there is no field colour; there are: pressure' "$work/said" || { echo "view: a field"; failed=1; }
[ $failed = 1 ] || echo "view: every kind of output is drawn"
exit $failed
