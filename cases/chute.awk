# A chute of two slopes as an STL file: floor, side walls, an end plate.
#
#   awk -f cases/chute.awk >cases/chute.stl
#   awk -v long=8 -v wide=8 -f cases/chute.awk >cases/fed-chute.stl
#
# Each of its floor's four stretches has `long` parts along it and `wide` across.
function corner(p) { printf "   vertex %s\n", p }
function triangle(a, b, c) {
    print " facet normal 0 0 0\n  outer loop"
    corner(a); corner(b); corner(c)
    print "  endloop\n endfacet"
}
function quad(a, b, c, d) { triangle(a, b, c); triangle(a, c, d) }
function at(x, y, z) { return sprintf("%g %g %g", x, y, z) }
BEGIN { # all in mm; the floor leads from (460, 340) by (200, 160) to (60, 120)
    n = split("460 340 330 250 200 160 130 140 60 120", p, " ")
    if (!long) long = 1
    if (!wide) wide = 2
    print "solid chute"
    for (i = 1; i + 3 <= n; i += 2) {
        dx = (p[i + 2] - p[i]) / long; dy = (p[i + 3] - p[i + 1]) / long
        for (q = 0; q < long; q++) {
            x = p[i] + q * dx; y = p[i + 1] + q * dy
            for (z = 20; z < 100; z += 80 / wide)
                quad(at(x, y, z), at(x + dx, y + dy, z),
                    at(x + dx, y + dy, z + 80 / wide), at(x, y, z + 80 / wide))
        }
        for (z = 20; z <= 100; z += 80)
            quad(at(p[i], p[i + 1], z), at(p[i + 2], p[i + 3], z),
                at(p[i + 2], p[i + 3] + 30, z), at(p[i], p[i + 1] + 30, z))
    }
    quad(at(460, 340, 20), at(460, 340, 100), at(460, 370, 100), at(460, 370, 20))
    print "endsolid chute"
}
