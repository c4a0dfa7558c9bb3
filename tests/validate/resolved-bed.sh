#!/bin/sh
# EW18's bed in a liquid with the flow around each grain resolved, between an inlet and
# an outlet, and what EW18 figs. 6 to 13 show of the drag in it. A run that is done is
# not made again, and one that was interrupted goes on.
#
#   sh tests/validate/resolved-bed.sh build/winnow [RE...]
#
# Re_in is 4, 6, 8 or 11 (8). By default the small bed: 4 x 4 x 15 d, 128 grains, 8 cells
# in a diameter, up to 10 d/u_in: some minutes for each. In the environment WIDTH=8 CELLS=12
# END=100 make it that of EW18, 512 grains and 1.7 million cells: 8 hours of a processor
# for each, and 3.1 GB (make validate-bed). Writes figures/24/24-liquid-RE.txt, or
# 24-liquid-RE-WIDTH-CELLS.txt of another bed than the small one, and the integral times
# of all velocities that there are, for fig. 13; figures/24/24-liquid.gp draws them.
. "$(dirname "$0")/runs.inc"
[ $# -gt 0 ] || set -- 8
W=${WIDTH:-4} cells=${CELLS:-8} end=${END:-10}
bed=
[ "$W-$cells" = 4-8 ] || bed=-$W-$cells

# RE: the case. d, u_in and the density of the fluid are 1; g d^3 / nu^2 = 387. The
# grains begin where they were thrown, between 0.6 and HEIGHT, with the velocity 0.
bed_case() {
    name=$out/re$1-$W-$cells
    n=$(awk "BEGIN { print 8 * $W * $W }")
    height=$(awk "BEGIN { print ($1 < 7 ? 9.1 : $1 < 10 ? 10 : 11.6) }")
    [ -s "$name.spheres" ] || {
        awk -v n="$n" -v L="$W" -v H="$height" -v low=0.6 -v seed=1 \
            -f tests/validate/suspension.awk >"$name.spheres.part"
        mv "$name.spheres.part" "$name.spheres"
    }
    awk -v re="$1" -v W="$W" -v c="$cells" -v end="$end" -v spheres="re$1-$W-$cells.spheres" 'BEGIN {
        nu = 1 / re; g = 387 * nu * nu
        printf "title = \"EW18, the bed in a liquid, resolved: Re_in = %s\"; cites = \"EW18 Table 1, 2\";\n", re
        printf "mesh = { size = [%.1f, 15.0, %.1f]; cells = [%d, %d, %d]; periodic = [true, false, true]; };\n", W, W, W * c, 15 * c, W * c
        printf "fluid = { density = 1.0; viscosity = %.9g; step = %.9g; time = \"bdf2\"; convection = \"linear\"; tolerance = 1e-6;\n", nu, 0.08 / c
        print "  bottom = { inlet = 1.0; }; top = { outlet = 0.0; }; };"
        printf "bodies = { filter = 2.0; stiffness = 30000.0; restitution = 0.9; friction = 0.3; virtual_mass = 0.5;\n  spheres = (\n@include \"%s\"\n  ); };\n", spheres
        printf "effects = { gravity = [0.0, -%.9g, 0.0]; };\n", g
        printf "output = { end = %g; every = 10.0; history = 0.05; checkpoint = 120.0; };\n", end
    }' >"$name.cfg"
}

# RE
run() {
    bed_case "$1"
    [ "$(cat "$name.done" 2>/dev/null)" != "$end" ] || return 0
    again=
    [ ! -e "$name/checkpoint" ] || again=--resume
    winnow run "$name.cfg" -o "$name" --quiet $again >"$name.log" 2>&1 || {
        tail -n 3 "$name.log" >&2
        exit 1
    }
    echo "$end" >"$name.done"
}

# The blocks for gnuplot, from 5 d/u_in on and of the grains that are between two
# diameters above the inlet and two below the top of the bed.
for re; do
    run "$re"
    {
        echo "# Made by:${WIDTH:+ WIDTH=$W}${CELLS:+ CELLS=$cells}${END:+ END=$end} sh tests/validate/resolved-bed.sh build/winnow $re"
        awk -F, -v from="$(awk "BEGIN { print ($end > 12 ? 8 : $end / 2) }")" -v nu="$(awk "BEGIN { print 1 / $re }")" -v weight="$(awk "BEGIN { print 9 * 387 / $re / $re * 3.14159265358979 / 6 }")" \
            -f tests/validate/drag-samples.awk "$name/bodies.csv"
    } >"$out/24-liquid-$re$bed.txt"
    laws "$out/24-liquid-$re$bed.txt" >>"$out/24-liquid-$re$bed.txt"
    cp "$out/24-liquid-$re$bed.txt" figures/24/
done

# [EW18 fig. 13] T over Re_in, and the line through them.
{
    echo "# [EW18 fig. 13] Re_in, integral time to the first zero and from 4 on [d/u_in]; from figures/24/24-liquid-*.txt"
    for re in 4 6 8 11; do
        [ ! -e "figures/24/24-liquid-$re$bed.txt" ] ||
            sed -n "s/^# integral time to the first zero \\([0-9.]*\\), mean from 4 on \\([0-9.-]*\\) .*/$re \\1 \\2/p" \
                "figures/24/24-liquid-$re$bed.txt"
    done | awk '
        { print; n++; x += $1; y += $2; xx += $1 * $1; xy += $1 * $2 }
        END { d = n * xx - x * x
              if (n > 1) printf "# T = %.4f %+.4f Re_in\n", (y * xx - x * xy) / d, (n * xy - x * y) / d }'
} >"figures/24/24-liquid-times$bed.txt"
