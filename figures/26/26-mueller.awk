# How far the profiles of figures/26/26-mueller.txt are from what was measured, from
# those of the finest mesh, and from their own mirror image.
#
#   awk -f figures/26/26-mueller.awk figures/data/mueller-2009.txt figures/26/26-mueller.txt
#
# measured: root mean square at the places of the measurement, ours linear
# between the middles of cells and constant beyond the last.
# mirror: the bed is the same seen in a mirror, and so is its mean over endless
# time. Half the difference of left and right is the statistical error.
# finest: from the finest mesh of those that ran longest by diffusion, averaged
# over the wider cells of the two.

function value(key, x,  i, n, part) { # linear between the points of a line
    n = count[key]
    if (x <= X[key, 1]) return Y[key, 1]
    for (i = 2; i <= n; i++) {
        if (x > X[key, i]) continue
        part = (x - X[key, i - 1]) / (X[key, i] - X[key, i - 1])
        return Y[key, i - 1] + part * (Y[key, i] - Y[key, i - 1])
    }
    return Y[key, n]
}

function from_measured(key, field,  i, sum, d) {
    for (i = 1; i <= count["measured " field]; i++) {
        d = value(key, X["measured " field, i]) - Y["measured " field, i]
        sum += d * d
    }
    return sqrt(sum / count["measured " field])
}

function from_mirror(key,  i, n, sum) {
    n = count[key]
    for (i = 1; i <= n; i++)
        sum += (Y[key, i] - value(key, 0.044 - X[key, i])) ^ 2 / 4
    return sqrt(sum / n)
}

# Of a profile that is constant in each of its cells, the mean from x1 to x2.
function mean_between(key, x1, x2,  i, n, w, low, high, sum) {
    n = count[key]
    w = 0.044 / n
    for (i = 1; i <= n; i++) {
        low = (i - 1) * w > x1 ? (i - 1) * w : x1
        high = i * w < x2 ? i * w : x2
        if (high > low) sum += (high - low) * Y[key, i]
    }
    return sum / (x2 - x1)
}

function from_finest(key, fine,  i, n, sum) {
    if (count[key] > count[fine]) return from_finest(fine, key)
    n = count[key]
    for (i = 1; i <= n; i++)
        sum += (Y[key, i] - mean_between(fine, (i - 1) * 0.044 / n, i * 0.044 / n)) ^ 2
    return sqrt(sum / n)
}

function add(key, x, y) {
    X[key, ++count[key]] = x
    Y[key, count[key]] = y
}

FNR == NR && !/^#/ { add($1 " " $2 " " $3, $4, $5) }
FNR < NR && $1 == "at" { add($2 " " $3 " " $4 " " $5, $6, $7) }
FNR < NR && $1 == "run" {
    name[++runs] = $2 " " $3
    about[runs] = sprintf("%4.1f s %5.1f %% %6.2f", $5, 100 * $7 / $6, $8)
    if ($3 == "diffusion" && $5 >= longest) { finest = $2 " " $3; longest = $5 }
}

END {
    split("eps_f 16.4,eps_f 31.2,us_y 15,us_y 25", line, ",")
    print "# rms from the measured, +- mirror, from " finest " [-] [m/s], at"
    printf "# %-14s", ""
    for (k = 1; k <= 4; k++) printf "  %-18s", line[k]
    print "  until, capped steps, lowest eps_f"
    for (r = 1; r <= runs; r++) {
        printf "%-16s", name[r]
        for (k = 1; k <= 4; k++) {
            key = name[r] " " line[k]
            printf "  %.3f +-%.3f ", from_measured(key, line[k]), from_mirror(key)
            if (name[r] == finest) printf "    -"
            else printf "%.3f", from_finest(key, finest " " line[k])
        }
        print " " about[r]
    }
    printf "%-16s", "sediFoam"
    for (k = 1; k <= 4; k++)
        printf "  %.3f             ", from_measured("sediFoam " line[k], line[k])
    printf "\n%-16s", "measured"
    for (k = 1; k <= 4; k++)
        printf "        +-%.3f      ", from_mirror("measured " line[k])
    print ""
}
