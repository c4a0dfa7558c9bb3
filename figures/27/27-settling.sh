#!/bin/sh
# How fast does a suspension settle, by each drag law? 216 spheres of glass in water,
# first one alone and then all of them on a shaken grid, in periodic boxes with void
# fractions from 0.5 to 0.95.
#
#   sh figures/27/27-settling.sh >figures/27/27-settling.txt      (some ten minutes)
#
# law, d [mm], Re_t [-], eps_f [-], u / u_t [-]: with u the velocity at which spheres and
# what they displace settle through the mixture at rest, eps_f times the slip. Below them
# fit, law, d, Re_t, n: the exponent of (27.4) by least squares through u_t.
. "$(dirname "$0")/../here.sh"
out=out/27-settling
mkdir -p $out
laws=${*:-syamlal-obrien gidaspow di-felice beetstra hill-koch-ladd tenneti rong cello}

grid() { # d [m], eps_f
    awk -v d="$1" -v eps="$2" 'BEGIN {
        srand(1)
        a = d * (3.14159265358979 / 6 / (1 - eps)) ^ (1 / 3)
        for (i = 0; i < 6; i++) for (j = 0; j < 6; j++) for (k = 0; k < 6; k++)
            printf "%.9g %.9g %.9g %.9g\n", place(i), place(j), place(k), d
        printf "%.9g\n", a >"/dev/stderr"
    }
    function place(i) { return (i + 0.5) * a + (rand() - 0.5) * 0.98 * (a - d) }' \
        2>$out/spacing >$out/grid
}

falls() { # the mean of the second half, of mean_fall_velocity [m/s]
    winnow run cases/settling-suspension.cfg --quiet -j 1 -o $out/run "$@" >/dev/null 2>&1
    columns $out/run/history.csv time mean_fall_velocity | awk '
        { t[NR] = $1; v[NR] = $2 }
        END { for (i in t) if (t[i] > t[NR] / 2) { sum += v[i]; n++ }; printf "%.6g\n", sum / n }'
}

echo "# law, d [mm], Re_t, eps_f, u / u_t; fit: law, d [mm], Re_t, n"
for law in $laws; do
    for size in 0.1,0.02,0.02,2e-5 0.5,2.0,0.2,2e-4 2.0,100.0,1.0,1e-3; do
        IFS=, read -r d stiffness end step <<ROW
$size
ROW
        set -- -s exchange.drag="$law" -s particles.grains.stiffness="$stiffness" \
            -s output.end="$end" -s output.every="$end" -s fluid.step="$step" \
            -s output.history="$step"
        L=$(awk "BEGIN { print 8.26e-3 * $d }")
        alone=$(falls "$@" -s mesh.size="[$L,$L,$L]" -s averaging.bandwidth="${d}e-2" \
            -s "particles.insert=({count=1;diameter=${d}e-3;})")
        for eps in 0.5 0.6 0.7 0.8 0.9 0.95; do
            grid "${d}e-3" $eps
            a=$(cat $out/spacing)
            L=$(awk "BEGIN { print 6 * $a }")
            b=$(awk "BEGIN { print 4 * $a }")
            slip=$(falls "$@" -s mesh.size="[$L,$L,$L]" -s averaging.bandwidth="$b" \
                -s "particles.insert=({file=\"$PWD/$out/grid\";})")
            echo "$law $d $alone $eps $slip"
        done
    done
done | awk '
    { Re = $3 * $2 * 1e3; u = $4 * $5 / $3 } # water: nu = 1e-6 m2/s
    $1 " " $2 != last { print_fit(); last = $1 " " $2; xy = xx = 0; about = sprintf("%.3g", Re) }
    { printf "%s %s %.3g %s %.4f\n", $1, $2, Re, $4, u
      xy += log($4) * log(u); xx += log($4) ^ 2 }
    END { print_fit() }
    function print_fit() { if (xx > 0) printf "fit %s %s %.2f\n", last, about, xy / xx }'
