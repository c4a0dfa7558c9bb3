# The gap between two cylinders about the z axis, radii r1 and r2, nr cells
# wide, nt cells round.
#
#   mkdir ring && awk -f cases/meshes/extruded.awk -f cases/meshes/ring.awk \
#       -v out=ring -v r1=1 -v r2=2 -v nr=16 -v nt=64
#
# With -v parts=N the outer cylinder is of N patches, outer0, outer1, ...

function side(x, y,   turn) {
    if (sqrt(x * x + y * y) < 0.5 * (r1 + r2)) return "inner"
    turn = atan2(y, x) / 6.283185307179586 + 0.5
    return "outer" (parts ? int(parts * turn) : "")
}

function at(i, j,   r, a) {
    r = r1 + (r2 - r1) * i / nr
    a = 6.283185307179586 * (j % nt) / nt
    return corner(r * cos(a), r * sin(a))
}

BEGIN {
    for (j = 0; j < nt; j++)
        for (i = 0; i < nr; i++)
            quadrangle(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1))
    write_mesh(r2 - r1)
}
