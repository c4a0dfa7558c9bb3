#!/bin/sh
# Air through the surface of a bed, with Winnow's faces and with plain linear
# interpolation (the patches of chapters/solutions), together and alone.
. "$(dirname "$0")/../here.sh"
patches=chapters/solutions/06-

surface() { sh figures/run.sh figures/06/06-surface.c "$@"; }

numbers() { # file, name: what is wrong, under names of its own
    sed -n "s/^\\(most\\|least\\|rise\\)\\( = .*\\)/$2_\\1\\2/p" "$1"
}

surface >"$work/ours"
surface "$patches"[a-z]*.patch >"$work/plain"
echo "# height, u over U / eps with our faces and with plain ones, p with both"
paste -d ' ' "$work/ours" "$work/plain" |
    awk '$1 ~ /^[0-9]/ { print $1, $2, $5, $3, $6 }'
grep -v '^[0-9]' "$work/ours"
numbers "$work/plain" plain
for one in linear-flux linear-pressure no-step; do
    surface "$patches$one.patch" >"$work/$one"
    numbers "$work/$one" "$(echo "$one" | tr - _)"
done
surface -- upwind 1.8e-5 >"$work/air"
numbers "$work/air" viscous
surface -- linear >"$work/central"
numbers "$work/central" linear
surface "$patches"one-slope.patch -- linear |
    awk '$1 == "most" { printf "one_slope_most = %.0e\n", $3 }'
