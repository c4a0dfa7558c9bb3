#!/bin/sh
# 19-long-cells.sh -- a ring of NR cells across and 446 round, with inlets,
# outlets and slip walls in turn about it: the pressure of the cells along a
# radius, from within, by which factor its difference from cell to cell changes
# on the way in, and that factor by (19.8), or 0.
#
#   sh figures/19/19-long-cells.sh NR
. "$(dirname "$0")/../here.sh"
nr=$1
dir=$work
mkdir "$dir/ring"
awk -f cases/meshes/extruded.awk -f cases/meshes/ring.awk -v out="$dir/ring" \
    -v r1=1 -v r2=4 -v nr="$nr" -v nt=446 -v parts=223
awk -v nr="$nr" 'BEGIN {
    print "title = \"ring\"; mesh = { polymesh = \"ring\"; };"
    print "fluid = { density = 1.0; viscosity = 0.1; step = 0.5;"
    print "tolerance = 1e-10; piso_tolerance = 1e-7; inner = \"no-slip\";"
    for (i = 0; i < 223; i++) {
        k = i % 3
        print "outer" i " = " (k == 0 ? "{ inlet = 0.1; }" : \
                               k == 1 ? "{ outlet = 0.0; }" : "\"slip\"") ";"
    }
    print "}; output = { end = 5.0; every = 5.0; picture = false; probes = ("
    turn = 6.283185307179586 * (111.25 / 223 - 0.5)
    for (i = 0; i < nr; i++) {
        r = 1 + 3 * (i + 0.5) / nr
        printf "%s{ field = \"p\"; position = [%.9f, %.9f, 1.5]; }", \
               i ? "," : "", r * cos(turn), r * sin(turn)
    }
    print "); };"
}' >"$dir/ring.cfg"
winnow run "$dir/ring.cfg" -o "$dir/out" --quiet
tail -1 "$dir/out/probes.csv" | awk -F, -v nr="$nr" '
function excess(x, ratio) { # of the right side of (19.8)
    return -2 * x * (1 + x) ^ 2 * (1 + ratio ^ 2) - (1 - x) ^ 4
}
function expected(ratio,   x) {
    for (x = -1; x < 0; x += 0.001) if (excess(x, ratio) > 0) return x
    return 0
}
{
    print "# r, length over width of the cell; p [Pa]; factor; (19.8)"
    for (i = nr - 10; i <= nr; i++) {
        r = 1 + 3 * (i - 0.5) / nr
        ratio = 3 / nr / (6.283185307 * r / 446)
        printf "%.3f %5.1f %8.4f", r, ratio, $(i + 1)
        if (i < nr && i > 1)
            printf " %6.2f %6.2f", ($(i + 1) - $i) / ($(i + 2) - $(i + 1)),
                   expected(ratio)
        print ""
    }
}'
