#!/bin/sh
# Lets the real VTK readers read what the program writes: samples of every kind
# of array, and a run of three spheres in a little air.
#
#   sh tests/vtk.sh build        (after the build of program and tests)
set -eu
build=${1:-build}
python=/usr/bin/python3 # Debian's own, which python3-vtk9 belongs to
[ -x $python ] || python=$(command -v python3) || {
    echo "vtk_check: no Python here, left out"
    exit 0
}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cat >"$work/tiny.cfg" <<'END'
title = "three spheres & a little \"air\"";
mesh = { size = [0.006, 0.012, 0.006]; cells = [3, 6, 3]; };
fluid = { density = 1.2; viscosity = 1.8e-5; step = 2e-4;
          bottom = { inlet = 0.2; }; top = { outlet = 0.0; };
          sides = "no-slip"; front_back = "slip"; };
particles = { contact = "linear"; step = 1e-5;
    grains = { density = 1000; stiffness = 100; restitution = 0.9; friction = 0.1; };
    place = ( { position = [0.003, 0.002, 0.003]; diameter = 1e-3; },
              { position = [0.0031, 0.004, 0.003]; diameter = 1e-3; },
              { position = [0.0031, 0.006, 0.003]; diameter = 1e-3; } );
    surfaces = (
        { name = "ramp"; shape = "plane"; point = [0.003, 0.001, 0.003]; normal = [0.1, 1.0, 0.0]; },
        { name = "tube"; shape = "cylinder"; point = [0.003, 0.0, 0.003]; axis = [0.0, 1.0, 0.0];
          radius = 2.5e-3; spin = [0.0, 10.0, 0.0]; },
        { name = "blade"; shape = "stl"; file = "blade.stl"; scale = 1e-3; point = [0.003, 0.008, 0.003];
          spin = [0.0, 50.0, 0.0]; } ); };
averaging = { method = "kernel"; bandwidth = 4e-3; };
exchange = { drag = "syamlal-obrien"; };
effects = { gravity = [0.0, -9.81, 0.0]; pressure_gradient = {}; };
output = { end = 0.02; every = 0.004;
           profiles = ( { field = "eps_f"; height = 0.003; from = 0.01; } ); };
END

cat >"$work/blade.stl" <<'END'
solid blade
facet normal 0 0 1
outer loop
vertex -1 0 0
vertex 1 0 0
vertex 0 1 0
endloop
endfacet
endsolid blade
END

mkdir "$work/samples"
"$build/tests/test_vtk" "$work/samples"
"$build/winnow" run "$work/tiny.cfg" -o "$work/tiny" --quiet >"$work/said" 2>&1 || {
    cat "$work/said"
    exit 1
}

# Flow through cells of every kind: hexahedra pushed out of the square, and
# polyhedra.
for mesh in sheared dual; do
    cat >"$work/$mesh.cfg" <<END
mesh = { polymesh = "$PWD/tests/data/poly/$mesh"; };
fluid = { density = 1.2; viscosity = 0.1; step = 0.01;
          bottom = { inlet = 0.2; }; top = { outlet = 0.0; };
          left = "no-slip"; right = "no-slip"; front = "slip"; back = "slip"; };
output = { end = 0.05; every = 0.05; };
END
    "$build/winnow" run "$work/$mesh.cfg" -o "$work/$mesh" --quiet \
        >"$work/said" 2>&1 || {
        cat "$work/said"
        exit 1
    }
done
# Spheres that touch, one of them across a periodic end, one that falls on the
# floor and one on a shelf. Walls with the stress of the fluid on them. All that
# particles.vtp can hold, in the order of the ids.
cat >"$work/pressed.cfg" <<'END'
mesh = { size = [0.006, 0.006, 0.006]; cells = [3, 3, 3]; periodic = [true, false, false]; };
fluid = { density = 1.2; viscosity = 1.8e-5; step = 2e-4;
          bottom = "no-slip"; top = { wall = [0.1, 0.0, 0.0]; }; front_back = "slip"; };
particles = { contact = "linear"; step = 1e-5; overlaps = "allow";
    grains = { density = 1000; stiffness = 100; restitution = 0.9; friction = 0.1; };
    place = ( { position = [0.0002, 0.002, 0.003]; diameter = 1e-3; },
              { position = [0.0002, 0.00298, 0.003]; diameter = 1e-3; },
              { position = [0.00522, 0.002, 0.003]; diameter = 1e-3; },
              { position = [0.003, 0.0005, 0.003]; diameter = 1e-3; },
              { position = [0.0015, 0.00459, 0.003]; diameter = 1e-3; velocity = [0.0, -0.1, 0.0]; } );
    surfaces = ( { name = "shelf"; shape = "stl"; file = "shelf.stl"; scale = 1e-3;
                   point = [0.0015, 0.004, 0.003]; } ); };
averaging = { method = "pcm"; };
exchange = { drag = "gidaspow"; };
effects = { gravity = [0.0, -9.81, 0.0]; };
output = { end = 1e-3; every = 1e-3; contacts = true; sorted = true;
           particles = "mass material fluid_force contact_force contact_number"; walls = true; forces = ( { name = "all"; } ); };
END
sed 's/-1 0 0/-1 0 -1/; s/ 1 0 0/ 1 0 -1/; s/0 1 0$/0 0 2/' "$work/blade.stl" >"$work/shelf.stl"
"$build/winnow" run "$work/pressed.cfg" -o "$work/pressed" --quiet >"$work/said" 2>&1 || {
    cat "$work/said"
    exit 1
}
# The same eight spheres in the middle of a periodic box and across its corners.
for at in here moved; do
    {
        echo 'mesh = { size = [0.006, 0.006, 0.006]; cells = [1, 1, 1]; periodic = [true, true, true]; };'
        echo 'particles = { contact = "linear"; step = 1e-6; overlaps = "allow";'
        echo '  grains = { density = 1000; stiffness = 100; restitution = 0.9; friction = 0.1; };'
        echo '  place = ('
        for k in 0 1 2 3 4 5 6 7; do
            echo "$k $at" | awk '{
                s = $2 == "here" ? 2.4 : 5.4
                x = s + 0.97 * ($1 % 2); y = s + 0.98 * (int($1 / 2) % 2); z = s + 0.96 * int($1 / 4)
                if (x >= 6) x -= 6
                if (y >= 6) y -= 6
                if (z >= 6) z -= 6
                printf "%s{ position = [%.5fe-3, %.5fe-3, %.5fe-3]; diameter = 1e-3; }",
                    $1 ? "," : "", x, y, z }'
        done
        echo '); }; output = { end = 2e-5; every = 1e-5; contacts = true; particles = "contact_number"; sorted = true; };'
    } >"$work/heap-$at.cfg"
    "$build/winnow" run "$work/heap-$at.cfg" -o "$work/heap-$at" --quiet >"$work/said" 2>&1 || {
        cat "$work/said"
        exit 1
    }
done
# The same as unstructured grids, for readers that know only these: cells of a
# box, particles, surfaces, walls and contacts.
for run in tiny pressed; do
    "$build/winnow" run "$work/$run.cfg" -o "$work/$run-grids" --quiet \
        -s 'output.format="vtu"' >"$work/said" 2>&1 || {
        cat "$work/said"
        exit 1
    }
done
$python tests/vtk_check.py "$work/samples" "$work/tiny" "$work/sheared" \
    "$work/dual" "$work/pressed" "$work/heap-here" "$work/heap-moved" \
    "$work/tiny-grids" "$work/pressed-grids"
