#!/bin/sh
# The small bed on two meshes, averaged in three ways: the fullest cell and the
# pressure drop after 0.01 s, when no particle has moved by a tenth of itself.
# The bed settles once, for the first run; the others read it.
. "$(dirname "$0")/../here.sh"
mkdir -p out
rm -f out/08-run.bed
cp cases/small-bed.cfg out/08-run.cfg # a bed is written beside its case
row() { # cells, method, name for the table, further options
    cells=$1 method=$2 name=$3
    shift 3
    winnow run out/08-run.cfg -o out/small -s output.end=0.01 --quiet -j 1 \
        -s "mesh.cells=[$cells]" -s particles.bed.file=./08-run.bed \
        -s averaging.method="$method" "$@" \
        >/dev/null 2>&1 || { printf "%-9s  %-10s  stops\n" "$cells" "$name"; return; }
    sh chapters/tools/last.sh out/small eps_f_lowest pressure_drop |
        awk -v cells="$cells" -v name="$name" '
            { value[NR] = $3 }
            END { printf "%-9s  %-10s  %.3f  %.1f\n", cells, name, 1 - value[1],
                         value[2] }'
}
echo "# cells, method, highest eps_s [-], pressure drop [Pa]"
for cells in "8, 32, 1" "24, 96, 1"; do
    row "$cells" pcm "pcm"
    row "$cells" pcm "pcm capped" -s averaging.cap=0.7
    row "$cells" kernel kernel
    row "$cells" diffusion diffusion
done
