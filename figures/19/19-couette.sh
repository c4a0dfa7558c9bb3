#!/bin/sh
# The torque between two cylinders of the radii 1 and 2, of which the inner one
# rotates, on hexahedra or LAYERS of tetrahedra: how far it is from the exact
# one on either, in percent.
#
#   sh figures/19/19-couette.sh ACROSS AROUND [LAYERS]
. "$(dirname "$0")/../here.sh"
top=$PWD

mkdir "$work/ring"
awk -f "$top/cases/meshes/extruded.awk" -f "$top/cases/meshes/ring.awk" \
    -v out="$work/ring" -v r1=1 -v r2=2 -v nr="$1" -v nt="$2" \
    -v tetrahedra="${3:-0}"
cat >"$work/ring.cfg" <<'END'
mesh   = { polymesh = "ring"; };
fluid  = { density = 1.0; viscosity = 1.0; step = 0.05; convection = "linear";
           piso_tolerance = 1e-4;
           inner = { rotation = [0.0, 0.0, 1.0]; }; outer = "no-slip"; };
output = { end = 1.0; every = 1.0;
           forces = ( { patches = "inner"; }, { patches = "outer"; } ); };
END
winnow run "$work/ring.cfg" -o "$work/out" --quiet >/dev/null
awk -F, -v across="$1" -v around="$2" -v layers="${3:-0}" '
    NR == 1 { for (i = 1; i <= NF; i++) column[substr($i, 1, 14)] = i }
    END {
        exact = 16 * atan2(0, -1) / 3
        cells = across * around * (layers > 0 ? 6 * layers : 1)
        printf "%-10s %5d cells, %d across: inner %.2f %%, outer %.2f %%\n",
            (layers > 0 ? "tetrahedra" : "hexahedra"), cells, across,
            100 * (-$column["inner_torque_z"] / exact - 1),
            100 * ($column["outer_torque_z"] / exact - 1)
    }' "$work/out/forces.csv"
