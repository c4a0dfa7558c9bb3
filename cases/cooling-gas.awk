# A gas of grains that cools: 27000 of 1 mm, at 1 m/s, fill a tenth of a periodic box,
# in parcels of `grains` (1, 8, 27 or 216), which keep their `restitution` or their
# "dissipation". They begin on a lattice, with normal velocities.
#
#   awk -v grains=8 -v restitution=kept -f cases/cooling-gas.awk >out/gas.cfg
function uniform() { # (0, 1)
    seed = (seed * 16807) % 2147483647
    return seed / 2147483647
}
function normal() { return sqrt(-2 * log(uniform())) * cos(6.283185307 * uniform()) }
function at(i) { return sprintf("%.8g", (i % n + 0.5) * L / n) }
BEGIN {
    seed = 1
    l = int(grains ^ (1 / 3) + 0.5)
    n = 30 / l
    L = 0.03 * (3.14159265359 / 0.6) ^ (1 / 3)
    size = sprintf("%.8g", L)
    print "title = \"A gas of grains that cools by its collisions\";"
    print "cites = \"Haff83\";"
    print "mesh = { size = [" size ", " size ", " size "]; cells = [1, 1, 1]; periodic = [true, true, true]; };"
    print "particles = { contact = \"linear\"; step = " 1e-6 * l ";"
    if (grains > 1)
        print "    parcel = { grains = " grains "; restitution = \"" restitution "\"; };"
    print "    grains = { density = 1000; stiffness = 6459.0; restitution = 0.9; friction = 0.0; };"
    print "    place = ("
    for (i = 0; i < n ^ 3; i++)
        for (a = 0; a < 3; a++) mean[a] += (v[i, a] = normal()) / n ^ 3
    for (i = 0; i < n ^ 3; i++)
        printf "%s{ position = [%s, %s, %s]; velocity = [%.17g, %.17g, %.17g]; diameter = 1e-3; }", i ? ",\n" : "",
            at(i), at(int(i / n)), at(int(i / n / n)), v[i, 0] - mean[0], v[i, 1] - mean[1], v[i, 2] - mean[2]
    print ");\n};"
    print "effects = { energy_budget = {}; };"
    print "output = { end = 0.036; every = 0.036; history = 1e-3; };"
}
