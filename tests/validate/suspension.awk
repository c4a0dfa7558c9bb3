# Hard spheres of diameter 1 and density 10 in a periodic cube, by random moves from
# a lattice, as the list `spheres` of a case. With H they lie between the heights low
# and low + H, which are no period.
#
#   awk -v n=95 -v L=5 -v seed=1 -f tests/validate/suspension.awk
#   awk -v n=128 -v L=4 -v H=10 -v low=0.6 -v seed=1 -f tests/validate/suspension.awk
function far(i, x, y, z,   j, a, b, c) {
    if (H && (y < low + 0.5 || y > low + H - 0.5)) return 0
    for (j = 1; j <= n; j++) {
        if (j == i) continue
        a = x - X[j]; b = y - Y[j]; c = z - Z[j]
        a -= L * int(a / L + (a < 0 ? -0.5 : 0.5))
        if (!H) b -= L * int(b / L + (b < 0 ? -0.5 : 0.5))
        c -= L * int(c / L + (c < 0 ? -0.5 : 0.5))
        if (a * a + b * b + c * c < least) return 0
    }
    return 1
}
function wrap(x) { return x < 0 ? x + L : x >= L ? x - L : x }
BEGIN {
    srand(seed); least = 1.0002
    m = 1; while (4 * m * m * m < n) m++
    if (H) m = int(L / 1.415)
    h = L / m
    layers = m; tall = h
    if (H) { layers = int((n - 1) / (4 * m * m)) + 1; tall = (H - 1) / layers }
    k = 0 # the corners and face centres of m^3 cubes, every site with a number
    total = 4 * m * m * layers
    for (s = 0; s < total; s++) { order[s] = s }
    for (s = total - 1; s > 0; s--) { r = int(rand() * (s + 1)); t = order[s]; order[s] = order[r]; order[r] = t }
    for (k = 1; k <= n; k++) {
        s = order[k - 1]; q = s % 4; s = int(s / 4)
        X[k] = (s % m + (q == 1 || q == 2) / 2 + 0.1) * h
        Y[k] = (int(s / m) % layers + (q == 1 || q == 3) / 2 + 0.1) * tall
        if (H) Y[k] += low + 0.5
        Z[k] = (int(s / (m * layers)) + (q == 2 || q == 3) / 2 + 0.1) * h
    }
    for (sweep = 0; sweep < 300; sweep++)
        for (i = 1; i <= n; i++) {
            x = wrap(X[i] + 0.3 * (rand() - 0.5)); y = Y[i] + 0.3 * (rand() - 0.5); if (!H) y = wrap(y); z = wrap(Z[i] + 0.3 * (rand() - 0.5))
            if (far(i, x, y, z)) { X[i] = x; Y[i] = y; Z[i] = z }
        }
    for (i = 1; i <= n; i++) if (!far(i, X[i], Y[i], Z[i])) bad++
    if (bad) { print bad " overlap" > "/dev/stderr"; exit 1 }
    for (i = 1; i <= n; i++)
        printf "{ position = [%.5f, %.5f, %.5f]; diameter = 1.0; density = 10.0; }%s\n", X[i], Y[i], Z[i], i < n ? "," : ""
}
