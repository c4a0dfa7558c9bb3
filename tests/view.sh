#!/bin/sh
# figures/view.py draws a picture of every kind of output folder, and a film:
# something is there, in the colours that the kind must have, and the box stands
# upright where gravity is along z.
#
#   sh tests/view.sh build        (part of check-slow; needs pvpython and xvfb-run)
set -eu
build=${1:-build}
command -v pvpython >/dev/null && command -v xvfb-run >/dev/null || {
    echo "view: no pvpython or no xvfb-run here, left out"
    exit 0
}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
air='fluid = { density = 1.2; viscosity = 1.8e-4; step = 1e-3; bottom = { inlet = 0.2; };
               top = { outlet = 0.0; }; sides = "no-slip"; front_back = "slip"; };'

case_file() { cat >"$work/$1.cfg"; }
case_file grains <<'END'
mesh = { size = [0.02, 0.01, 0.04]; cells = [1, 1, 1]; };
particles = { contact = "linear"; step = 1e-5;
    grains = { density = 1000; stiffness = 100; restitution = 0.9; friction = 0.1; };
    bed = { count = 400; diameter = 1e-3; }; };
effects = { gravity = [0.0, 0.0, -9.81]; };
output = { end = 0.01; every = 0.005; };
END
case_file bodies <<END
mesh = { size = [0.02, 0.04, 0.02]; cells = [8, 16, 8]; };
fluid = { density = 1000; viscosity = 0.1; step = 1e-3; bottom = "no-slip"; top = "no-slip";
          left = "no-slip"; right = "no-slip"; front_back = "no-slip"; };
bodies = { stiffness = 1000; spheres = ( { position = [0.01, 0.03, 0.01]; diameter = 0.008; density = 2000; } );
           boxes = ( { position = [0.01, 0.01, 0.01]; size = [0.008, 0.006, 0.008]; } ); };
effects = { gravity = [0.0, -9.81, 0.0]; };
output = { end = 0.01; every = 0.005; };
END
case_file flow <<END
mesh = { polymesh = "$PWD/tests/data/poly/dual"; };
fluid = { density = 1.2; viscosity = 0.1; step = 0.01; bottom = { inlet = 0.2; };
          top = { outlet = 0.0; }; left = "no-slip"; right = "no-slip"; front = "slip"; back = "slip"; };
output = { end = 0.05; every = 0.05; };
END
case_file one <<END
mesh = { size = [0.006, 0.012, 0.006]; cells = [3, 6, 3]; };
${air}
particles = { contact = "linear"; step = 1e-5;
    grains = { density = 1000; stiffness = 100; restitution = 0.9; friction = 0.1; };
    place = ( { position = [0.003, 0.002, 0.003]; diameter = 1e-3; } );
    surfaces = ( { name = "tube"; shape = "stl"; file = "roof.stl"; scale = 1e-3; point = [0.003, 0.008, 0.003]; } ); };
averaging = { method = "kernel"; bandwidth = 4e-3; };
exchange = { drag = "gidaspow"; };
output = { end = 0.02; every = 0.01; };
END
printf 'solid s\nfacet normal 0 0 1\nouter loop\nvertex -1 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid s\n' >"$work/roof.stl"

cat >"$work/look.py" <<'END'
"""How much of a picture is not white, how much is coloured, and its spread."""
import sys
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader
reader = vtkPNGReader()
reader.SetFileName(sys.argv[1])
reader.Update()
size = reader.GetOutput().GetDimensions()
rgb = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())[:, :3].astype(int)
rgb = rgb.reshape(size[1], size[0], 3)
up = rgb[::-1] # VTK's first row is the lowest
left = up[:int(0.84 * size[1]), :size[0] // (2 if sys.argv[2] == "two" else 1)] # above the bar
ink = left.min(axis=2) < 250
rows, columns = ink.any(axis=1).nonzero()[0], ink.any(axis=0).nonzero()[0]
colour = rgb.max(axis=2) - rgb.min(axis=2) > 40
orange = (rgb[:, :, 0] > rgb[:, :, 2] + 60) & (rgb[:, :, 0] > rgb[:, :, 1] + 40)
print("ink %.4f" % ink.mean(), "colour %.4f" % colour.mean(), "orange %.4f" % orange.mean(),
      "tall %.2f" % (len(rows) / len(columns)), "kinds %d" % len({tuple(c) for c in rgb[::4, ::4].reshape(-1, 3)}))
END

failed=0
look() { # name, how many panels, what must hold
    xvfb-run -a -s -noreset pvpython figures/view.py "$work/$1" "$work/$1.png" >"$work/said" 2>&1 ||
        { cat "$work/said"; failed=1; return; }
    seen=$(xvfb-run -a -s -noreset pvpython "$work/look.py" "$work/$1.png" "$2")
    echo "$seen" | awk "{ ink = \$2; colour = \$4; orange = \$6; tall = \$8; kinds = \$10; exit !($3) }" ||
        { echo "view: $1: $seen, not $3"; failed=1; }
}
for name in grains bodies flow one; do
    "$build/winnow" run "$work/$name.cfg" -o "$work/$name" --quiet >"$work/said" 2>&1 || {
        cat "$work/said"
        exit 1
    }
done
look grains one 'ink > 0.01 && colour > 0.005 && tall > 1.9 && tall < 2.1 && kinds > 50'
look bodies two 'orange > 0.01 && colour > 0.05 && tall > 1.5'
look flow one 'ink > 0.1 && colour > 0.1 && kinds > 10'
look one two 'colour > 0.03 && tall > 1.5'
xvfb-run -a -s -noreset pvpython figures/view.py "$work/bodies" "$work/film.png" film=1 field=pressure >"$work/said" 2>&1
[ "$(find "$work" -name 'film*.png' | wc -l)" = 3 ] || { echo "view: a film of three states"; failed=1; }
! xvfb-run -a -s -noreset pvpython figures/view.py "$work" "$work/none.png" >"$work/said" 2>&1 &&
    grep -q 'name the output folder' "$work/said" || { echo "view: no run, no word"; failed=1; }
! xvfb-run -a -s -noreset pvpython figures/view.py "$work/flow" "$work/none.png" field=colour >"$work/said" 2>&1 &&
    grep -q 'there is no field colour; there are: pressure' "$work/said" || { echo "view: a field"; failed=1; }
[ $failed = 1 ] || echo "view: every kind of output is drawn"
exit $failed
