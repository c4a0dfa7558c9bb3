#!/bin/sh
# Goldschmidt's bed, by winnow and by OpenFOAM's DPMFoam side by side: the same spheres on
# the lattice of the tutorial DPMFoam/Goldschmidt (Debian packages openfoam and
# openfoam-examples), the same springs of 1e6 Pa, step, cells and sums over cells, for 0.4 s.
#
#   sh figures/27/27-goldschmidt.sh dpmfoam     into out/27-beside/dpmfoam
#   sh figures/27/27-goldschmidt.sh whole       winnow, with DPMFoam's form of the equations
#   sh figures/27/27-goldschmidt.sh gradient    winnow, with that of the case
#   sh figures/27/27-goldschmidt.sh table       all three, for figures/27/27-goldschmidt.txt
#
# On one quiet core DPMFoam takes half an hour, winnow two minutes.
. "$(dirname "$0")/../here.sh"
out=out/27-beside
tutorial=/usr/share/doc/openfoam-examples/examples/lagrangian/DPMFoam/Goldschmidt
end=0.4
step=1e-4
every=0.01
. tests/bench/icofoam.inc

# Theirs has z upwards and its middle at x = y = 0, ours y upwards and its corner at 0.
ours() { awk '{ printf "%.9g %.9g %.9g 2.5e-3\n", $2 + 0.075, $3, $1 + 0.0075 }'; }
points() { sed -n 's/^(\([-0-9.e ]*\)).*/\1/p' "$1"; }

dpmfoam() {
    rm -rf $out/dpmfoam
    mkdir -p $out
    cp -r $tutorial $out/dpmfoam
    cd $out/dpmfoam
    find . -name '*.gz' -exec gunzip {} +
    sed -i "s/youngsModulus .*/youngsModulus 1e6;/" constant/kinematicCloudProperties
    sed -i "s/^endTime .*/endTime $end;/; s/^deltaT .*/deltaT $step;/
        s/^writeInterval .*/writeInterval $every;/; s/^writeFormat .*/writeFormat ascii;/" \
        system/controlDict
    blockMesh >log.blockMesh 2>&1
    DPMFoam >log 2>&1
}

run() { # NAME, and what stands for the pressure gradient in the case
    mkdir -p $out
    { gunzip -c $tutorial/constant/kinematicCloudPositions.gz 2>/dev/null ||
        cat $tutorial/constant/kinematicCloudPositions; } >$out/positions
    points $out/positions | ours >$out/lattice.txt
    sed "s/pressure_gradient/$2/" cases/goldschmidt-bed.cfg >"$out/$1.cfg"
    winnow run "$out/$1.cfg" -j 1 --quiet --fresh -o "$out/$1" \
        -s fluid.step=$step -s particles.step=1e-5 -s particles.bed.count=0 \
        -s "particles.insert=({file=\"$PWD/$out/lattice.txt\";})" \
        -s averaging.method=pcm -s averaging.interpolation=nearest \
        -s output.end=$end -s output.every=$every -s output.history=$every >/dev/null
}

# Time, mean height of the spheres and pressure of the lowest cells over the outlet's.
theirs() {
    for t in "$out"/dpmfoam/0.*; do
        [ -e "$t/p" ] || continue
        height=$(points "$t/lagrangian/kinematicCloud/positions" |
            awk '{ h += $3 } END { printf "%.5f", h / NR }')
        drop=$(awk '/^\($/ { on = 1; next } on && n < 60 { p += $1; n++ }
            END { printf "%.1f", 1.2 * p / n }' "$t/p")
        printf "%.2f %s %s\n" "$(basename "$t")" "$height" "$drop"
    done
}

of() { columns "$out/$1/history.csv" time "$2" | awk '{ printf "%.2f %.6g\n", $1, $2 }'; } # NAME COLUMN

table() {
    echo "# Made by: sh figures/27/27-goldschmidt.sh dpmfoam, whole, gradient, then table"
    echo "# time [s]; mean height of the spheres [mm] by DPMFoam, by winnow with the whole drag"
    echo "# and with the pressure gradient; pressure drop [Pa] by the same three"
    theirs >$out/theirs
    for name in whole gradient; do
        of $name mean_height >$out/$name.height
        of $name pressure_drop >$out/$name.drop
    done
    join $out/theirs $out/whole.height | join - $out/gradient.height |
        join - $out/whole.drop | join - $out/gradient.drop |
        awk '{ printf "%.2f %6.2f %6.2f %6.2f  %5.0f %5.0f %5.0f\n", $1, 1000 * $2,
            1000 * $4, 1000 * $5, $3, $6, $7 }'
}

case $1 in
dpmfoam) dpmfoam ;;
whole) run whole whole_drag ;;
gradient) run gradient pressure_gradient ;;
table) table ;;
esac
