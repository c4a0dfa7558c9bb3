# Six hundred grains of 1 mm in a box of 48 x 8 x 8 mm whose number along x is a
# wave, 1 + cos(2 pi x / 48 mm) / 2: groups of a list particles.place. Across, they
# lie evenly, by multiples of two irrational numbers.
#
#   awk -f wave.awk >wave.grains
function share(x) { return x + 0.5 * sin(6.283185307179586 * x) / 6.283185307179586 }
BEGIN {
    for (i = 0; i < 600; i++) {
        low = 0; high = 1
        for (k = 0; k < 40; k++) {
            x = (low + high) / 2
            if (share(x) < (i + 0.5) / 600) low = x; else high = x
        }
        y = i * 0.7548776662466927; z = i * 0.5698402909980532
        printf "%s{ position = [%.7f, %.7f, %.7f]; diameter = 1e-3; }", i ? ",\n" : "",
            0.048 * x, 0.008 * (y - int(y)), 0.008 * (z - int(z))
    }
    print ""
}
