#!/bin/sh
# The cylinder of Schaefer and Turek [ST96], flow 2D-2: Re = 100, the eddies are
# shed in turn. An hour or less; what it finds goes to figures/19-cylinder.txt.
#
#   sh tests/validate/cylinder.sh build/winnow [32 48 ...]   (cells a side)
#
# The bands of the benchmark: drag 3.22 to 3.24, lift 0.99 to 1.01 at most, and a
# Strouhal number of 0.295 to 0.305.
set -eu
PATH=$(cd "$(dirname "$1")" && pwd):$PATH
shift
[ $# -gt 0 ] || set -- 32 48
out=out/validate-cylinder
export OMP_NUM_THREADS="${OMP_NUM_THREADS:-1}"
mkdir -p $out

# Of the last 1.5 s: the largest coefficients, and the frequency from the times
# at which the lift rises through zero.
found() { # cells
    awk -F, -v n="$1" '
        NR == 1 { next }
        { t[NR] = $1; cd[NR] = $13; cl[NR] = $14; end = $1; last = NR }
        END {
            for (i = 3; i <= last; i++) {
                if (t[i] < end - 1.5) continue
                if (cd[i] > drag) drag = cd[i]
                if (cl[i] > lift) lift = cl[i]
                if (cl[i - 1] >= 0 || cl[i] < 0) continue
                at = t[i] - cl[i] * (t[i] - t[i - 1]) / (cl[i] - cl[i - 1])
                if (!crossed++) first = at
            }
            printf "%d %.4f %.4f %.4f\n", n, drag, lift,
                0.1 * (crossed - 1) / (at - first)
        }' "$out/$1/forces.csv"
}

for n; do
    mkdir -p "$out/mesh-$n"
    awk -f cases/meshes/extruded.awk -f cases/meshes/cylinder.awk \
        -v out="$out/mesh-$n" -v n="$n" -v nr="$n" -v nx=$((2 * n))
    winnow run cases/meshes/cylinder.cfg -o "$out/$n" --quiet \
        -s "mesh.polymesh=$PWD/$out/mesh-$n" -s fluid.inlet.inlet=1.5 \
        -s fluid.step=5e-4 -s output.end=6.5 -s output.every=6.5 \
        -s output.forces.0.velocity=1.0 -s output.history=5e-4 >/dev/null
done
{
    echo "# Made by: sh tests/validate/cylinder.sh build/winnow $*"
    echo "# cells a side; largest drag and lift coefficient; Strouhal number"
    for n; do found "$n"; done
} >figures/19-cylinder.txt
cat figures/19-cylinder.txt
