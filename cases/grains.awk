# Spheres on a lattice, each shifted at random by up to 0.15 of the pitch, or half
# of `shift` if that is given: groups of a list particles.place. The generator is of its own, so that every
# awk makes the same.
#
# How it is called stands in the cases that use it.
function random() { # [0, 1)
    seed = (seed * 16807) % 2147483647
    return seed / 2147483647
}
BEGIN {
    seed = 1
    if (shift == "") shift = 0.3
    for (i = 0; i < n; i++) {
        x = x0 + (i % nx + 0.5 + shift * (random() - 0.5)) * pitch
        y = y0 + (int(i / nx / nz) + 0.5 + shift * (random() - 0.5)) * pitch
        z = z0 + (int(i / nx) % nz + 0.5 + shift * (random() - 0.5)) * (nz > 1 ? pitch : 0)
        d = random() < large ? d_large : d_small
        printf "%s{ position = [%.5f, %.5f, %.5f]; diameter = %s;%s }",
            i ? ",\n" : "", x, y, z, d, more
    }
    print ""
}
