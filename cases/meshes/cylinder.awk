# The channel of Schaefer and Turek, 2.2 m x 0.41 m, with a cylinder of 0.1 m
# about (0.2, 0.2): n cells along each side of the square around the cylinder,
# nr from the cylinder to it, nx in the rest of the channel.
#
#   mkdir cylinder && awk -f cases/meshes/extruded.awk -f cases/meshes/cylinder.awk \
#       -v out=cylinder -v n=32 -v nr=32 -v nx=64

function side(x, y) {
    if ((x - 0.2) ^ 2 + (y - 0.2) ^ 2 < 0.0026) return "cylinder"
    if (x < 1e-9) return "inlet"
    if (x > 2.2 - 1e-9) return "outlet"
    return "walls"
}

# From 0 to 1, the last of n steps exp(b) times as wide as the first.
function graded(i, n, b) { return (exp(b * i / n) - 1) / (exp(b) - 1) }

# Corner k of the square, against the clock from the lower right one.
function square_x(k) { return k % 4 == 0 || k % 4 == 1 ? 0.4 : 0 }
function square_y(k) { return k % 4 == 1 || k % 4 == 2 ? 0.41 : 0 }

# Around, i of 4 n; outward, j of nr. The angle on the cylinder follows the place
# on the square half and half, so that the links are nearly normal to the faces.
function around(i, j,   k, s, x, y, a, t) {
    i = i % (4 * n)
    k = int(i / n)
    s = i / n - k
    x = square_x(k) + s * (square_x(k + 1) - square_x(k))
    y = square_y(k) + s * (square_y(k + 1) - square_y(k))
    a = pi * (k - 0.5 + s) / 2
    t = graded(j, nr, 2.2)
    return corner((1 - t) * (0.2 + 0.05 * cos(a)) + t * x,
                  (1 - t) * (0.2 + 0.05 * sin(a)) + t * y)
}

function behind(i, j) {
    return corner(0.4 + 1.8 * graded(i, nx, 1.2), 0.41 * j / n)
}

BEGIN {
    pi = atan2(0, -1)
    for (j = 0; j < nr; j++)
        for (i = 0; i < 4 * n; i++)
            quadrangle(around(i, j), around(i, j + 1), around(i + 1, j + 1), around(i + 1, j))
    for (j = 0; j < n; j++)
        for (i = 0; i < nx; i++)
            quadrangle(behind(i, j), behind(i + 1, j), behind(i + 1, j + 1), behind(i, j + 1))
    write_mesh(0.1)
}
