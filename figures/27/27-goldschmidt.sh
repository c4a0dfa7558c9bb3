#!/bin/sh
# Goldschmidt's bed, by winnow and by OpenFOAM's DPMFoam side by side: the same spheres on
# the lattice of the tutorial DPMFoam/Goldschmidt (Debian packages openfoam and
# openfoam-examples), the same springs of 1e6 Pa, step, cells and sums over cells, for 0.4 s.
#
#   sh figures/27/27-goldschmidt.sh DPMFoam     into out/27-beside/DPMFoam
#   sh figures/27/27-goldschmidt.sh whole       winnow, with DPMFoam's form of the equations
#   sh figures/27/27-goldschmidt.sh gradient    winnow, with that of the case
#   sh figures/27/27-goldschmidt.sh table       all three, for figures/27/27-goldschmidt.txt
#   sh figures/27/27-goldschmidt.sh parcels     as whole, by parcels of eight in cells of 10 mm
#   sh figures/27/27-goldschmidt.sh MPPICFoam   its tutorial, of the same lattice
#   sh figures/27/27-goldschmidt.sh stress      winnow, with a stress in the place of contacts
#   sh figures/27/27-goldschmidt.sh soft        with the P_s of the tutorial
#   sh figures/27/27-goldschmidt.sh fewer       these beside figures/27/27-goldschmidt.txt
#
# On one quiet core DPMFoam takes half an hour, winnow two minutes; the others two or less.
. "$(dirname "$0")/../here.sh"
out=out/27-beside
tutorials=/usr/share/doc/openfoam-examples/examples/lagrangian
end=0.4
step=1e-4
every=0.01
. tests/bench/icofoam.inc

# Theirs has z upwards and its middle at x = y = 0, ours y upwards and its corner at 0.
ours() { awk '{ printf "%.9g %.9g %.9g 2.5e-3\n", $2 + 0.075, $3, $1 + 0.0075 }'; }
points() { sed -n 's/^(\([-0-9.e ]*\)).*/\1/p' "$1"; }

openfoam() { # SOLVER STEP
    rm -rf "$out/$1"
    mkdir -p $out
    cp -r "$tutorials/$1/Goldschmidt" "$out/$1"
    cd "$out/$1"
    find . -name '*.gz' -exec gunzip {} +
    sed -i "s/youngsModulus .*/youngsModulus 1e6;/" constant/kinematicCloudProperties
    sed -i "s/^endTime .*/endTime $end;/; s/^deltaT .*/deltaT $2;/
        s/^writeInterval .*/writeInterval $every;/; s/^writeFormat .*/writeFormat ascii;/" \
        system/controlDict
    blockMesh >log.blockMesh 2>&1
    "$1" >log 2>&1
}

lattice() { # of the tutorials
    { gunzip -c $tutorials/DPMFoam/Goldschmidt/constant/kinematicCloudPositions.gz 2>/dev/null ||
        cat $tutorials/DPMFoam/Goldschmidt/constant/kinematicCloudPositions; } >$out/positions
    points $out/positions | ours
}

# 3100 parcels of all grains in the same box, every second layer between the others.
sparse() {
    awk 'BEGIN { for (j = 0; j < 62; j++) for (i = 0; i < 25; i++) for (k = 0; k < 2; k++)
        printf "%.9g %.9g %.9g 4.99664e-3\n", 2.6e-3 + 5.9e-3 * (i + j % 2 / 2), 2.6e-3 + 0.2918 / 61 * j, 2.6e-3 + 6.4e-3 * (k + j % 2 / 2) }'
}

run() { # LATTICE NAME CASE [-s ...]
    of=$1 name=$2 case=$3
    shift 3
    $of >"$out/$of.txt"
    winnow run "$case" -j 1 --quiet --fresh -o "$out/$name" -s particles.bed.count=0 \
        -s "particles.insert=({file=\"$PWD/$out/$of.txt\";})" \
        -s output.end=$end -s output.every=$every -s output.history=$every "$@" >/dev/null
}

bed() { # LATTICE NAME, what stands for the pressure gradient in the case, particle step [-s ...]
    mkdir -p $out
    sed "s/pressure_gradient/$3/" cases/goldschmidt-bed.cfg >"$out/$2.cfg"
    of=$1 name=$2 dt=$4
    shift 4
    run "$of" "$name" "$out/$name.cfg" -s fluid.step=$step -s particles.step="$dt" \
        -s averaging.method=pcm -s averaging.interpolation=nearest "$@"
}

stress() { # NAME [-s ...]
    mkdir -p $out
    name=$1
    shift
    run lattice "$name" cases/goldschmidt-stress.cfg "$@"
}

# Time, mean height of the spheres and pressure of the lowest cells over the outlet's.
theirs() { # SOLVER, cells of a layer
    for t in "$out/$1"/0.*; do
        [ -e "$t/p" ] || continue
        height=$(points "$t/lagrangian/kinematicCloud/positions" |
            awk '{ h += $3 } END { printf "%.5f", h / NR }')
        drop=$(awk -v layer="$2" '/^\($/ { on = 1; next } on && n < layer { p += $1; n++ }
            END { printf "%.1f", 1.2 * p / n }' "$t/p")
        printf "%.2f %s %s\n" "$(basename "$t")" "$height" "$drop"
    done
}

of() { columns "$out/$1/history.csv" time "$2" | awk '{ printf "%.2f %.6g\n", $1, $2 }'; } # NAME COLUMN

table() {
    echo "# Made by: sh figures/27/27-goldschmidt.sh DPMFoam, whole, gradient, then table"
    echo "# time [s]; mean height of the spheres [mm] by DPMFoam, by winnow with the whole drag"
    echo "# and with the pressure gradient; pressure drop [Pa] by the same three"
    theirs DPMFoam 60 >$out/theirs
    for name in whole gradient; do
        of $name mean_height >$out/$name.height
        of $name pressure_drop >$out/$name.drop
    done
    join $out/theirs $out/whole.height | join - $out/gradient.height |
        join - $out/whole.drop | join - $out/gradient.drop |
        awk '{ printf "%.2f %6.2f %6.2f %6.2f  %5.0f %5.0f %5.0f\n", $1, 1000 * $2,
            1000 * $4, 1000 * $5, $3, $6, $7 }'
}

fewer() {
    echo "# time [s]; mean height of the spheres [mm]: DPMFoam, winnow with all spheres, with parcels;"
    echo "# MPPICFoam, winnow with a stress, with a softer one; pressure drop [Pa]: the same six"
    theirs MPPICFoam 15 >$out/theirs
    grep -v '^#' figures/27/27-goldschmidt.txt >$out/before
    for name in parcels stress soft; do
        of $name mean_height >$out/$name.height
        of $name pressure_drop >$out/$name.drop
        join $out/$name.height $out/$name.drop >$out/$name.both
    done
    join $out/before $out/parcels.both | join - $out/theirs | join - $out/stress.both | join - $out/soft.both |
        awk 'NR % 4 == 0 { printf "%.2f %6.1f %6.1f %6.1f  %6.1f %6.1f %6.1f  %5.0f %5.0f %5.0f  %5.0f %5.0f %5.0f\n", $1,
            $2, $3, 1000 * $8, 1000 * $10, 1000 * $12, 1000 * $14, $5, $6, $9, $11, $13, $15 }'
}

case $1 in
DPMFoam) openfoam DPMFoam $step ;;
MPPICFoam) openfoam MPPICFoam 2e-4 ;;
whole) bed lattice whole whole_drag 1e-5 ;;
gradient) bed lattice gradient pressure_gradient 1e-5 ;;
parcels) bed sparse parcels whole_drag 2e-5 -s particles.parcel.grains=7.98387 -s 'mesh.cells=[15,45,1]' ;;
stress) stress stress ;;
soft) stress soft -s effects.particle_stress.pressure=10.0 ;;
table) table ;;
fewer) fewer ;;
esac
