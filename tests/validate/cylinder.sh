#!/bin/sh
# The cylinder of Schaefer and Turek [ST96], flow 2D-2: Re = 100, the eddies are
# shed in turn. An hour or less; what it finds goes to figures/19/19-cylinder.txt.
#
#   sh tests/validate/cylinder.sh build/winnow [32 48 ...]   (cells a side)
#
# A run that was stopped goes on where it was saved when the script is called
# again; seconds_each=900 ends it after so many seconds of wall clock, with code
# 75 if something is left to do. Meshes whose runs have ended are only read. Of
# three meshes the order is found too, and the value that it leads to.
#
# The values of the benchmark's authors stand beside (figures/data/).
. "$(dirname "$0")/runs.inc"
[ $# -gt 0 ] || set -- 32 48

# Of the last 1.5 s: the largest coefficients, the frequency from the times at
# which the lift rises through zero, the smallest coefficients, and the lift from
# peak to peak.
found() { # cells
    awk -F, -v n="$1" '
        NR == 1 { least = 1e9; next }
        { t[NR] = $1; cd[NR] = $13; cl[NR] = $14; end = $1; last = NR }
        END {
            for (i = 3; i <= last; i++) {
                if (t[i] < end - 1.5) continue
                if (cd[i] > drag) drag = cd[i]
                if (cl[i] > lift) lift = cl[i]
                if (cd[i] < least) least = cd[i]
                if (cl[i] < low) low = cl[i]
                if (cl[i - 1] >= 0 || cl[i] < 0) continue
                at = t[i] - cl[i] * (t[i] - t[i - 1]) / (cl[i] - cl[i - 1])
                if (!crossed++) first = at
            }
            printf "%d %.4f %.4f %.4f %.4f %.4f %.4f\n", n, drag, lift,
                0.1 * (crossed - 1) / (at - first), least, low, lift - low
        }' "$out/$1/forces.csv"
}

# Of each three meshes in turn the order q, for which the two differences of a
# value are as those of (1 / cells)^q, and the value without cells; "-" where the
# differences have two signs or do not shrink, or the last one is rounding.
order() {
    awk '
        # (n1^-q - n2^-q) / (n2^-q - n3^-q), which grows with q
        function ratio(q) {
            return (n[1]^-q - n[2]^-q) / (n[2]^-q - n[3]^-q)
        }
        function extrapolate(k,   R, low, high, q, i, rest) {
            R = (v[2, k] - v[1, k]) / (v[3, k] - v[2, k] + 1e-99)
            if (R <= ratio(0.01) || R >= ratio(20)) return " - -"
            low = 0.01; high = 20
            for (i = 0; i < 60; i++) {
                q = 0.5 * (low + high)
                if (ratio(q) < R) low = q; else high = q
            }
            rest = n[3]^-q / (n[2]^-q - n[3]^-q)
            return sprintf(" %.1f %.4f", q, v[3, k] + (v[3, k] - v[2, k]) * rest)
        }
        /^#/ { next }
        {
            for (i = 1; i < 3; i++) {
                n[i] = n[i + 1]
                for (k = 2; k <= 7; k++) v[i, k] = v[i + 1, k]
            }
            n[3] = $1
            for (k = 2; k <= 7; k++) v[3, k] = $k
            if (++rows < 3) next
            printf "# to %d: order, value:", n[3]
            for (k = 2; k <= 7; k++) printf "%s", extrapolate(k)
            print ""
        }' "$1"
}

# The row of the authors' values, in the order of the columns.
reference() {
    awk '!/^#/ { row = row " " sprintf("%.4f", $2) }
         END { print "# FeatFlow" row }' \
        figures/data/featflow-cylinder-2d2.txt
}

# The run of one mesh up to its end; what it returns is that of the program.
whole() { # cells
    resume=
    [ ! -e "$out/$1/checkpoint" ] || resume=--resume
    # shellcheck disable=SC2086 # no word if there is nothing to resume
    timeout --signal=INT "${seconds_each:-0}" \
        winnow run cases/meshes/cylinder.cfg -o "$out/$1" --quiet $resume \
        -s "mesh.polymesh=$PWD/$out/mesh-$1" -s fluid.inlet.inlet=1.5 \
        -s fluid.step=5e-4 -s output.end=6.5 -s output.every=6.5 \
        -s output.forces.0.velocity=1.0 -s output.history=5e-4 >/dev/null
}

for n; do
    mkdir -p "$out/mesh-$n"
    awk -f cases/meshes/extruded.awk -f cases/meshes/cylinder.awk \
        -v out="$out/mesh-$n" -v n="$n" -v nr="$n" -v nx=$((2 * n))
    ended=$(awk -F, 'END { print ($1 > 6.499) }' "$out/$n/forces.csv" 2>/dev/null || echo 0)
    [ "$ended" = 1 ] || whole "$n" || exit 75
done
{
    echo "# Made by: sh tests/validate/cylinder.sh build/winnow $*"
    echo "# cells a side; largest drag and lift coefficient; Strouhal number;"
    echo "# smallest drag and lift coefficient; lift from peak to peak"
    for n; do found "$n"; done
    reference
} >figures/19/19-cylinder.txt
order figures/19/19-cylinder.txt >"$out/orders"
cat "$out/orders" >>figures/19/19-cylinder.txt
cat figures/19/19-cylinder.txt
