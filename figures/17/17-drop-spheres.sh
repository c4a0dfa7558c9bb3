#!/bin/sh
# The grains of cases/drop-cohesion.cfg: a ball on a hexagonal lattice, each a
# little off its place, as the list that the case includes.
#
#   sh figures/17/17-drop-spheres.sh >cases/drop-cohesion.spheres
set -eu
awk 'BEGIN {
    d = 1e-3; a = 1.22 * d; R = 6e-3; cx = 20e-3; cy = 20e-3; cz = 20e-3
    print "# x, y, z [m] of each grain; made by figures/17/17-drop-spheres.sh"
    print "place = ("
    for (k = -6; k <= 6; k++)
        for (j = -7; j <= 7; j++)
            for (i = -7; i <= 7; i++) {
                x = a * (i + 0.5 * (j + k % 2)); z = a * sqrt(3) / 2 * (j + (k % 2) / 3)
                y = a * sqrt(2 / 3) * k
                if (x * x + y * y + z * z > R * R) continue
                at = sprintf("%.6f, %.6f, %.6f", cx + x + jitter(), cy + y + jitter(), cz + z + jitter())
                line = "    { position = [" at "]; diameter = 1e-3; }"
                if (n++) print last ","
                last = line
            }
    print last
    print ");"
}
# Up to 10 % of the diameter, from a linear congruential generator.
function jitter() { seed = (seed * 16807 + 12345) % 2147483647; return 1e-4 * (2 * seed / 2147483647 - 1) }' </dev/null
