#!/bin/sh
# XS11 Case 1: drop between the sensors over the velocity of the inlet.
#
#   30-ramp.sh series DIR RUN [START]   means over 0.1 s of a run that
#                                tests/validate/coupling.sh left in DIR, of the
#                                ramp from START [s] on
#   30-ramp.sh numbers FILE...   of such series: the plateau, the mean drop from
#                                1.0 m/s up to 1.5 m/s (or of the last second
#                                of a run that ends before), and U_mf, where
#                                the rising drop first meets it
. "$(dirname "$0")/../here.sh"
series() {
    printf '# Made by: sh tests/validate/coupling.sh build/winnow ramp; %s\n' "$2"
    echo "# t [s], U [m/s], drop [Pa]"
    awk -F, -v start="${3:-0}" 'NR > 2 { k = int($1 / 0.1 + 1e-6); d[k] += $2 - $3; n[k]++; last = k }
        END { for (k = 0; k <= last; k++) if (n[k] > 4) {
            t = start + 0.1 * k + 0.055
            printf "%.3f %.4f %.2f\n", t, t < 15 ? t / 10 : (30 - t) / 10, d[k] / n[k] } }' \
        "$1/$2/probes.csv"
}
numbers() {
    for file in "$@"; do
        echo "## $(basename "$file" .txt)"
        awk '$1 + 0 > 0 && $1 < 15 { n++; U[n] = $2; d[n] = $3 }
            END {
                printf "highest_U = %.2f [m/s]\n", U[n]
                low = U[n] < 1.1 ? U[n] - 0.1 : 1
                for (i = 1; i <= n; i++) if (U[i] > low) { m += d[i]; k++ }
                for (i = 1; i <= n; i++) if (U[i] > low) {
                    j = int(10 * (i - n + k - 1) / k); b[j] += d[i]; c[j]++ }
                for (j in b) e += (b[j] / c[j] - m / k) ^ 2 / 90
                for (i = 2; i <= n && d[i] < m / k; i++);
                printf "plateau = %.1f [Pa]\n", m / k
                printf "plateau_error = %.1f [Pa]\nU_mf = %.3f [m/s]\n", sqrt(e),
                    U[i - 1] + (U[i] - U[i - 1]) * (m / k - d[i - 1]) / (d[i] - d[i - 1])
            }' "$file"
    done
}
command=$1
shift
$command "$@"
