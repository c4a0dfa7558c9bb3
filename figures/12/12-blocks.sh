#!/bin/sh
# How far the mean of a column can be trusted: the second half of a history is
# cut into blocks, and the spread of their means gives the error of the whole.
#
#   sh figures/12/12-blocks.sh out/mueller-bed pressure_drop
set -eu
awk -F, -v wanted="$2 " '
    NR == 1 { for (i = 1; i <= NF; i++) if (index($i, wanted) == 1) c = i; next }
    { t[NR - 1] = $1; x[NR - 1] = $c }
    END {
        rows = NR - 1
        first = int(rows / 2) + 1
        n = rows - first + 1
        for (i = first; i <= rows; i++) sum += x[i]
        mean = sum / n
        for (i = first; i <= rows; i++) square += (x[i] - mean) ^ 2
        spread = sqrt(square / n)
        printf "mean = %.1f\nspread = %.1f\nrows = %d\n", mean, spread, n
        printf "seconds = %.2f\n", t[rows] - t[first]
        printf "# block [s], blocks, error of the mean\n"
        printf "%.3f %5d %6.2f\n", t[first + 1] - t[first], n, spread / sqrt(n)
        naive = spread / sqrt(n)
        for (blocks = 256; blocks >= 8; blocks /= 2) {
            length_ = int(n / blocks)
            if (length_ < 2) continue
            total = 0
            for (b = 0; b < blocks; b++) {
                part = 0
                for (i = 0; i < length_; i++)
                    part += x[first + b * length_ + i]
                total += (part / length_ - mean) ^ 2
            }
            error = sqrt(total / blocks / (blocks - 1))
            if (error > worst) worst = error
            printf "%.3f %5d %6.2f\n", length_ * (t[first + 1] - t[first]), blocks, error
        }
        printf "naive = %.1f\nerror = %.1f\n", naive, worst
    }' "$1/history.csv"
