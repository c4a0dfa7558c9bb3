# Samples of the drag on resolved grains [EW18 23-31], from bodies.csv with
# bodies.filter: one line of numbers. nu and the time of the first sample are given.
#
#   awk -F, -v nu=0.125 -v from=8 -f tests/validate/samples.awk history.csv bodies.csv
#
# superficial Re of the mean slip; of the grains' own surroundings the mean of
# Re_p, eps, C_d, sigma(C_d); then near these means (Re within 10 %, eps within
# 0.02) the number of samples, the mean of C_d and sigma over it; the integral of R to
# its first zero, and its mean over 4 <= tau <= 5; root of the granular temperature
# along y, and across; the number of grains and of times.

FNR == 1 { file++; delete at; for (i = 1; i <= NF; i++) { split($i, w, " "); at[w[1]] = i } next }
$1 + 0 < from { next }
file == 1 { flow += $at["mean_flow_y"]; rows++; next }
{
    b = $2 + 0
    if (b == 0) { k++; T[k] = $1 }
    C[b, k] = $at["C_d"]; R[b, k] = $at["Re_p"]; E[b, k] = $at["eps_f"]
    u = $at["vx"]; v = $at["vy"]; w3 = $at["vz"]
    su[k] += u; sv[k] += v; sw[k] += w3
    qu[k] += u * u; qv[k] += v * v; qw[k] += w3 * w3
    sC += C[b, k]; qC += C[b, k] ^ 2; sR += R[b, k]; sE += E[b, k]; V += v
    if (b + 1 > n) n = b + 1
}
END {
    if (n * k == 0) exit 1
    while (!((n - 1, k) in C)) k-- # the last row may not be whole
    N = n * k; mC = sC / N; mR = sR / N; mE = sE / N
    for (b = 0; b < n; b++) {
        m = 0
        for (j = 1; j <= k; j++) {
            if (R[b, j] > 0.9 * mR && R[b, j] < 1.1 * mR && E[b, j] > mE - 0.02 && E[b, j] < mE + 0.02) {
                near++; nC += C[b, j]; nq += C[b, j] ^ 2
            }
            m += C[b, j] / k
        }
        for (j = 1; j <= k; j++) x[j] = C[b, j] - m
        dt = (T[k] - T[1]) / (k - 1)
        lags = int(5 / dt)
        if (lags > k / 2) lags = int(k / 2)
        for (l = 0; l <= lags; l++) {
            s = 0
            for (j = 1; j + l <= k; j++) s += x[j] * x[j + l]
            c[l] += s / (k - l)
        }
    }
    for (l = 1; l <= lags; l++) {
        I += 0.5 * dt * (c[l] + c[l - 1]) / c[0]
        if (!zero && c[l] <= 0) zero = I
        if (l * dt >= 4) { plateau += I; ends++ }
    }
    for (j = 1; j <= k; j++) {
        a += (qv[j] / n - (sv[j] / n) ^ 2) / k
        t += 0.5 * (qu[j] / n - (su[j] / n) ^ 2 + qw[j] / n - (sw[j] / n) ^ 2) / k
    }
    printf "%.3f  %.3f %.4f %.2f %.2f  %d %.2f %.3f  %.3f %.3f  %.3f %.3f  %d %d\n", \
        (flow / rows - V / N) / nu, mR, mE, mC, sqrt(qC / N - mC ^ 2), \
        near, nC / near, sqrt(nq / near - (nC / near) ^ 2) / (nC / near), \
        zero, ends ? plateau / ends : 0, sqrt(a), sqrt(t), n, k
}
