# The drag on resolved grains as EW18 figs. 6 to 13 show it, and their bed as figs. 15 to 17, from bodies.csv with
# bodies.filter: blocks for gnuplot. Of each time, from `from` on, those grains count that
# are two diameters away from the inlet and from the top of the bed (in a periodic box, with
# box=1, all); `weight` is that of a grain in the fluid.
#
#   awk -F, -v from=8 -v nu=0.125 -v weight=28.5 -f tests/validate/drag-samples.awk bodies.csv

# Its factor of the force of Stokes [EW18 A.6].
function beetstra(e, Re,   s) {
    s = 1 - e
    return 10 * s / e ^ 2 + e ^ 2 * (1 + 1.5 * sqrt(s)) + 0.413 / (24 * e ^ 2) * Re * \
        (1 / e + 3 * e * s + 8.4 * Re ^ -0.343) / (1 + 10 ^ (3 * s) * Re ^ (-0.5 - 2 * s))
}
function law(e, Re) { return 24 * beetstra(e, Re) / (e * Re) } # [EW18 26]
function root(x) { return x > 0 ? sqrt(x) : 0 }
function mean_of(k) { return sum[k] / count[k] }
function deviation(k) { return root(square[k] / count[k] - mean_of(k) ^ 2) }
function add(k, x) { count[k]++; sum[k] += x; square[k] += x * x }
# Of a sphere of diameter 1 what is lower than h above its lowest point.
function below(h) { h = h < 0 ? 0 : h > 1 ? 1 : h; return 3.14159265358979 * h * h * (0.5 - h / 3) }
function take(b, j) { return in_bed[b, j] ? 1 : 0 }
# Heads of the shares of values in bins as wide as `step`.
function histogram(what, list, n, step,   i, j, h, lo, hi) {
    lo = 1e9; hi = -1e9
    for (i = 1; i <= n; i++) {
        j = int(list[i] / step + 1000) - 1000
        h[j]++; if (j < lo) lo = j; if (j > hi) hi = j
    }
    print what
    for (j = lo; j <= hi; j++) printf "%.3f %.4f\n", (j + 0.5) * step, h[j] / (n * step)
    print "\n"
}

FNR == 1 { for (i = 1; i <= NF; i++) { split($i, w, " "); at[w[1]] = i } next }
{
    if ($2 == 0) time[++times] = $1
    grains[times]++
    for (a = 0; a < 3; a++) { x = $at["v" substr("xyz", a + 1, 1)]; v1[times, a] += x; v2[times, a] += x * x }
}
$1 + 0 < from { next }
{
    b = $2 + 0
    if (b == 0) T[++k] = $1
    if (b + 1 > n) n = b + 1
    C[b, k] = $at["C_d"]; R[b, k] = $at["Re_p"]; E[b, k] = $at["eps_f"]
    F[b, k] = $at["force_y"] / weight; Y[b, k] = $at["y"]; v[b, k] = $at["vy"]
    height[k] += 2 * $at["y"]
}
END {
    if (n * k == 0) exit 1
    while (!((n - 1, k) in C)) k-- # the last row may not be whole
    for (j = 1; j <= k; j++) {
        height[j] /= n; H += height[j] / k
        for (b = 0; b < n; b++)
            if (box || (Y[b, j] > 2.5 && Y[b, j] < height[j] - 2)) {
                in_bed[b, j] = 1
                add("all", C[b, j]); add("Re", R[b, j]); add("eps", E[b, j]); add("F", F[b, j])
            }
    }
    mR = mean_of("Re"); mE = mean_of("eps")
    printf "# grains %d, times %d, height %.2f; means and deviations: Re_p %.2f %.2f, eps %.4f %.4f, C_d %.2f %.2f, force over weight %.3f %.3f\n", \
        n, k, H, mR, deviation("Re"), mE, deviation("eps"), mean_of("all"), deviation("all"), mean_of("F"), deviation("F")

    # fig. 6: near one Re_p and eps
    for (j = 1; j <= k; j++)
        for (b = 0; b < n; b++)
            if (take(b, j) && R[b, j] > 0.95 * mR && R[b, j] < 1.05 * mR && E[b, j] > mE - 0.01 && E[b, j] < mE + 0.01) {
                near[++m] = C[b, j]; add("near", C[b, j])
            }
    printf "# near Re_p %.2f (5 %%) and eps %.3f (0.01): %d samples, C_d %.2f, its deviation %.2f; Beetstra %.2f\n\n\n", \
        mR, mE, m, mean_of("near"), deviation("near"), law(mE, mR)
    histogram("# [EW18 fig. 6] C_d, share", near, m, mean_of("near") / 10)

    # fig. 7: samples far apart in time come in turn
    print "# [EW18 fig. 7] samples, mean of C_d, its deviation"
    for (i = 1; i <= m; i++) {
        add("so far", near[(i * 7919) % m + 1])
        if (i >= next_one) { printf "%d %.3f %.3f\n", i, mean_of("so far"), deviation("so far"); next_one = i < 10 ? 10 : int(1.2 * i) + 1 }
    }
    print "\n"

    # figs. 8 to 10
    print "# [EW18 figs. 8-10] Re_p, eps, samples, mean of C_d, its deviation, that over the mean, C_d of Beetstra"
    for (j = 1; j <= k; j++)
        for (b = 0; b < n; b++)
            if (take(b, j)) add("bin " int(R[b, j] / 2) " " int(E[b, j] / 0.04), C[b, j])
    for (q = 0; q < 25; q++) {
        some = 0
        for (i = 0; i < 30; i++)
            if (count["bin " i " " q] >= 200) {
                key = "bin " i " " q; e = 0.04 * (q + 0.5); Re = 2 * i + 1; some = 1
                printf "%.1f %.2f %d %.3f %.3f %.3f %.3f\n", Re, e, count[key], mean_of(key), deviation(key), deviation(key) / mean_of(key), law(e, Re)
            }
        if (some) print ""
    }
    print ""

    # fig. 11
    m = 0
    for (b = 0; b < n; b++) if (take(b, k)) list[++m] = F[b, k]
    histogram("# [EW18 fig. 11] force over weight of the grains at one time, share", list, m, 0.2)
    best = 0
    for (b = 0; b < n; b++) {
        m = 0
        for (j = 1; j <= k; j++) m += take(b, j)
        if (m > longest) { longest = m; best = b }
    }
    m = 0
    for (j = 1; j <= k; j++) if (take(best, j)) path[++m] = F[best, j]
    histogram("# [EW18 fig. 11] the same of one grain over its path, share", path, m, 0.2)

    print "# [EW18 fig. 15] height, fluid fraction"
    for (i = 0; !box && i < 15; i++) {
        solids = 0
        for (j = 1; j <= k; j++)
            for (b = 0; b < n; b++) solids += below(i + 1.5 - Y[b, j]) - below(i + 0.5 - Y[b, j])
        printf "%.1f %.4f\n", i + 0.5, 1 - solids / k / (n / 8)
    }
    print "\n\n# [EW18 figs. 16, 17] time, granular temperature along the flow, across it"
    for (j = 1; j <= times; j += 5) {
        for (a = 0; a < 3; a++) temperature[a] = v2[j, a] / grains[j] - (v1[j, a] / grains[j]) ^ 2
        printf "%.2f %.5f %.5f\n", time[j], temperature[1], (temperature[0] + temperature[2]) / 2
    }
    print "\n"

    # figs. 12 and 13: grains that are in the bed all the time
    dt = (T[k] - T[1]) / (k - 1); lags = int(6 / dt); if (lags > k / 2) lags = int(k / 2)
    for (b = 0; b < n; b++) {
        m = 0; whole = 1
        for (j = 1; j <= k; j++) { m += F[b, j] / k; if (!box && Y[b, j] < 1) whole = 0 }
        if (!whole) continue
        followed++
        for (l = 0; l <= lags; l++) {
            s = 0
            for (j = 1; j + l <= k; j++) s += (F[b, j] - m) * (F[b, j + l] - m)
            c[l] += s / (k - l)
        }
    }
    printf "# grains that are followed: %d\n\n\n# [EW18 figs. 12, 13] tau, autocorrelation of the force along the flow, its integral\n", followed
    for (l = 0; l <= lags; l++) {
        if (l > 0) I += 0.5 * dt * (c[l] + c[l - 1]) / c[0]
        if (l * dt >= 4) { plateau += I; ends++ }
        if (l > 0 && !zero && c[l] <= 0) zero = I
        if (l % 2 == 0) printf "%.2f %.4f %.4f\n", l * dt, c[l] / c[0], I
    }
    printf "# integral time to the first zero %.3f, mean from 4 on %.3f d/u_in\n", zero, ends ? plateau / ends : 0
}
