#!/bin/sh
# Our fluid beside OpenFOAM's icoFoam, where that is installed (Debian package
# openfoam; nothing is installed here): the lid-driven cavity at Re 1000 on 128 x
# 128 cells and the cubic one on 64^3, the same step, schemes and two pressure
# corrections a step, in turn, and the median of the ratios of each turn; and ours
# on the same mesh read from OpenFOAM's files, as they are and with its cells
# numbered in disorder.
#
#   sh tests/bench/fluid.sh build/tests/bench [ROUNDS]      (make bench)
#
# icoFoam solves with GAMG to its tolerance of 1e-6, the first correction to 5 %.
# What counts is what is left: its "continuity error, sum local" and ours stand
# in the table. Times are processor time of one core.
set -eu
fluid=$1/fluid
rounds=${2:-3}
out=$1/run/fluid
export OMP_NUM_THREADS=1
. "$(dirname "$0")/icofoam.inc"
mkdir -p "$out"

ends() { # what a field says of back and front
    if [ "$dimensions" = 3 ]; then
        echo "ends { type $1; }"
    else
        echo 'ends { type empty; }'
    fi
}

make_case() { # in the present folder
    solver_files "$(awk "BEGIN { print $steps * 0.05 / $cells }")" \
        "$(awk "BEGIN { print 0.05 / $cells }")" 1e-04
    depth=0.01 layers=1 type=empty
    [ "$dimensions" = 2 ] || { depth=0.1 layers=$cells type=wall; }
    dictionary dictionary blockMeshDict system/blockMeshDict <<END
vertices ((0 0 0) (0.1 0 0) (0.1 0.1 0) (0 0.1 0)
    (0 0 $depth) (0.1 0 $depth) (0.1 0.1 $depth) (0 0.1 $depth));
blocks (hex (0 1 2 3 4 5 6 7) ($cells $cells $layers) simpleGrading (1 1 1));
boundary (
    lid { type wall; faces ((3 7 6 2)); }
    sides { type wall; faces ((0 4 7 3) (2 6 5 1) (1 5 4 0)); }
    ends { type $type; faces ((0 3 2 1) (4 5 6 7)); });
END
    fields "lid { type fixedValue; value uniform (1 0 0); } sides { type noSlip; } $(ends noSlip)" \
        "lid { type zeroGradient; } sides { type zeroGradient; } $(ends zeroGradient)"
    blockMesh >log.blockMesh 2>&1
}

# The same mesh with its cells numbered at random: each changes its number with
# one of those before it, which a linear congruence chooses.
shuffle() { # from to
    mkdir -p "$2"
    cp "$1"/* "$2"
    for list in owner neighbour; do
        awk -v n="$count" '
            BEGIN {
                x = 12345
                for (i = 0; i < n; i++) {
                    x = (x * 16807) % 2147483647
                    j = x % (i + 1)
                    new[i] = new[j]
                    new[j] = i
                }
            }
            /^[0-9]+$/ && begun++ { print new[$1]; next }
            { print }' "$1/$list" >"$2/$list"
    done
}

# Cell-steps a second, the median over three parts after the first steps, and
# what is left of continuity.
icofoam() {
    (cd "$out/$scene" && icoFoam >log 2>&1)
    awk -v first="$first" -v steps="$steps" -v n="$count" '
        /^ExecutionTime/ { t[++k] = $3 }
        /sum local/ { left = $9 }
        END {
            part = int((steps - first) / 3)
            least = 1e9
            for (i = 0; i < 3; i++) {
                s = (t[first + (i + 1) * part] - t[first + i * part]) / part
                sum += s
                if (s > most) most = s
                if (s < least) least = s
            }
            sub(",", "", left)
            printf "%.4g %s\n", n / (sum - most - least), left
        }' "$out/$scene/log"
}

ours() {
    "$fluid" "$dimensions" "$cells" "$steps" "$first" "$@" | sed \
        's/.*continuity=\([^ ]*\).*cell_steps_per_second=\(.*\)/\2 \1/'
}

: >"$out/rates.txt"
there=1
command -v icoFoam >/dev/null || { there=0; echo "icoFoam is not installed: left out"; }
for scene in cavity-128 box-64; do
    case $scene in
    cavity-128) dimensions=2 cells=128 steps=500 first=200 count=16384 ;;
    box-64) dimensions=3 cells=64 steps=50 first=20 count=262144 ;;
    esac
    rm -rf "${out:?}/$scene"
    mkdir -p "$out/$scene"
    if [ $there = 1 ]; then
        (cd "$out/$scene" && make_case)
        shuffle "$out/$scene/constant/polyMesh" "$out/$scene/shuffled"
    fi
    round=0
    while [ $round -lt "$rounds" ]; do
        round=$((round + 1))
        echo "$scene winnow $(ours)" >>"$out/rates.txt"
        [ $there = 0 ] && continue
        echo "$scene icoFoam $(icofoam)" >>"$out/rates.txt"
        echo "$scene polyMesh $(ours - "$out/$scene/constant/polyMesh")" \
            >>"$out/rates.txt"
        echo "$scene shuffled $(ours - "$out/$scene/shuffled")" >>"$out/rates.txt"
    done
done
awk "$(cat "$(dirname "$0")/median.awk")"'
    { key = $1 " " $2; n[key]++; rate[key, n[key]] = $3; left[key] = $4; seen[$1] = 1 }
    END {
        printf "%-12s %12s %9s %6s %9s %6s %9s %6s %11s %11s\n", "fluid",
               "winnow [/s]", "icoFoam", "ratio", "polyMesh", "ratio",
               "shuffled", "ratio", "left, ours", "theirs"
        for (s in seen) {
            w = s " winnow"; f = s " icoFoam"; g = s " polyMesh"
            h = s " shuffled"
            for (i = 1; i <= n[w]; i++) {
                a[i] = rate[w, i]; b[i] = rate[f, i]; p[i] = rate[g, i]
                r[i] = b[i] > 0 ? a[i] / b[i] : 0
                q[i] = b[i] > 0 ? p[i] / b[i] : 0
                u[i] = rate[h, i]
                v[i] = b[i] > 0 ? u[i] / b[i] : 0
            }
            printf "%-12s %12.3g %9.3g %6.2f %9.3g %6.2f %9.3g %6.2f %11s %11s\n",
                   s, median(a, n[w]), median(b, n[w]), median(r, n[w]),
                   median(p, n[w]), median(q, n[w]), median(u, n[w]),
                   median(v, n[w]), left[w], left[f]
        }
    }' "$out/rates.txt"
