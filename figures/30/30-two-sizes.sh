#!/bin/sh
# XS11 Case 2: what four runs of cases/fluidization-two-sizes.cfg say about the mesh.
#
#   30-two-sizes.sh series|numbers|steps DIR
#
# DIR holds kernel-12x60, kernel-8x40, pcm-12x60, pcm-8x40, made by
# tests/validate/coupling.sh; what ends early has no numbers. series: drop between the sensors [Pa] and us_y [m/s]
# at the lower one, means over 0.05 s. numbers: means and standard deviations from
# 1 s on, with the statistical error of ten blocks; and the differences of the meshes.
# steps: the first seconds with a particle step half as long (short-step).
set -eu
runs="kernel-12x60 kernel-8x40 pcm-12x60 pcm-8x40"
series() {
    echo "# t [s], then drop [Pa] and us_y [mm/s] of each of: $runs"
    for run in $runs; do
        awk -F, 'NR > 2 { k = int($1 / 0.05 + 1e-6); d[k] += $2 - $3; u[k] += $4; n[k]++ }
            END { for (k = 0; k < 120; k++) if (n[k] > 4)
                printf "%s %.1f %.3f\n", k, d[k] / n[k], 1e3 * u[k] / n[k]
                else print k, "nan nan" }' "$1/$run/probes.csv" >"$1/$run.series"
    done
    paste -d' ' $(for run in $runs; do echo "$1/$run.series"; done) |
        awk '{ printf "%.3f %s %s %s %s %s %s %s %s\n", 0.05 * $1 + 0.025,
               $2, $3, $5, $6, $8, $9, $11, $12 }'
}
# The drops d and velocities u between two times; mean, its error by blocks, and deviation.
means='
    NR > 1 { t = $1 }
    NR > 1 && $1 > from && $1 <= to { d[++n] = $2 - $3; u[n] = 1e3 * $4 }
    function report(name, unit, a, form, short,   i, k, b, m, s, e, part) {
        part = int(n / blocks)
        for (i = 1; i <= n; i++) m += a[i] / n
        for (i = 1; i <= n; i++) s += (a[i] - m) ^ 2 / n
        for (i = 0; i < blocks; i++) {
            b = 0
            for (k = 1; k <= part; k++) b += a[i * part + k] / part
            e += (b - m) ^ 2 / (blocks * (blocks - 1))
        }
        printf "%s = " form " [%s]\n%s_error = " short "\n%s_deviation = " form "\n",
            name, m, unit, name, sqrt(e), name, sqrt(s)
    }'
numbers() {
    for run in $runs; do
        echo "## $run"
        awk -F, -v from=1 -v to=1e9 -v blocks=10 "$means"'
            END { printf "end = %.2f [s]\n", t
                  if (n < 10) exit
                  report("drop", "Pa", d, "%.4g", "%.2g"); report("us", "mm/s", u, "%.4g", "%.2g") }' "$1/$run/probes.csv"
    done
}
differences() { # of the coarse mesh from the fine one, from the numbers
    awk '/^## / { run = $2 }
        { v[run, $1] = $3 }
        function change(a, b) { return 100 * (b / a - 1) }
        function compare(m,   f, c, e) {
            f = m "-12x60"
            c = m "-8x40"
            if (!((f, "drop") in v && (c, "drop") in v)) return
            e = sqrt(v[c, "drop_error"] ^ 2 + v[f, "drop_error"] ^ 2)
            printf "## %s-meshes\n", m
            printf "drop_change = %.1f [%%]\n", change(v[f, "drop"], v[c, "drop"])
            printf "drop_change_error = %.1f\n", 100 * e / v[f, "drop"]
            printf "drop_deviation_change = %.0f [%%]\n",
                change(v[f, "drop_deviation"], v[c, "drop_deviation"])
            printf "us_deviation_change = %.0f [%%]\n",
                change(v[f, "us_deviation"], v[c, "us_deviation"])
        }
        END { compare("kernel"); compare("pcm") }'
}
# Mean drop of a run within a span of time, its error by six blocks, its deviation.
span() { # FILE FROM TO
    awk -F, -v from="$2" -v to="$3" -v blocks=6 "$means"'
        END { if (n >= blocks) report("drop", "Pa", d, "%.1f", "%.1f") }' "$1"
}
steps() { # of the particles: 4e-6 and 2e-6 s, from 0.4 s to the end of the shorter run
    end=$(tail -n 1 "$1/short-step/probes.csv" | cut -d, -f1)
    printf '## 4e-6\n'
    span "$1/kernel-12x60/probes.csv" 0.4 "$end"
    printf '## 2e-6\nend = %.2f [s]\n' "$end"
    span "$1/short-step/probes.csv" 0.4 "$end"
}
case $1 in
steps) steps "$2" ;;
series) series "$2" ;;
numbers) numbers "$2" | tee "$2/numbers"; differences <"$2/numbers" ;;
esac
