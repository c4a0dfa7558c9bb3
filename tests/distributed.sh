#!/bin/sh
# The program on several ranks: each number is compared with that of one rank or
# of build/winnow. Asserts no times.
#
#   sh tests/distributed.sh build
set -u
build=$(cd "${1:-build}" && pwd)
winnow=$build/winnow
compare=$build/tests/ranks/compare
pieces=$(cd "$(dirname "$0")" && pwd)/ranks/pieces.py
export OMP_NUM_THREADS=1 OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
export OMPI_MCA_mpi_yield_when_idle=1 OMPI_MCA_orte_abort_print_stack=0
if [ ! -x "$build/winnow-mpi" ] || ! command -v mpirun >/dev/null; then
    echo "skipped: build/winnow-mpi, which needs libpetsc-real-dev liblammps-dev mpi-default-dev"
    exit 0
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
export XDG_CACHE_HOME="$work/cache"
failed=0
facts=0

fact() { # name, command...: the command succeeds
    name=$1
    shift
    if "$@" >said 2>&1; then
        facts=$((facts + 1)) && echo "    $name"
    else
        echo "FAILED $name:" && tail -n 12 said | cut -c -160
        failed=$((failed + 1))
    fi
}

on() { # ranks, words of the program
    ranks=$1
    shift
    mpirun -n "$ranks" --oversubscribe --bind-to none "$build/winnow-mpi" "$@" \
        --quiet 2>&1
}

code() { # code, part of what is said, ranks, words
    want=$1 part=$2
    shift 2
    on "$@" >heard
    found=$?
    cat heard
    [ $found -eq "$want" ] && grep -qF -- "$part" heard
}

below() { # limits of x, rms, u, p; cells; two folders
    limits=$1
    numbers=$("$compare" "$2" "$3/checkpoint" "$4/checkpoint") || return 1
    echo "$numbers, expected at most $limits"
    echo "$numbers $limits" | awk '{ for (i = 1; i <= 4; i++) if (!($i <= $(i + 4))) exit 1 }'
}
above() { ! below "$@"; }
alike() { # the same, after a run on so many ranks with more words
    limits=$1 cells=$2 with=$3 folder=$4
    shift 4
    on "$@" -o "$folder" && below "$limits" "$cells" "$with" "$folder"
}

# A value of the last row of history.csv, by the head of its column.
last() {
    awk -F, -v head="$2" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == head) c = i }
        { value = $c } END { print value }' "$1/history.csv"
}

# A bed of 1000 spheres that falls into its fluid from a lattice, so that both
# programs begin without any contact.
cat >bed.cfg <<'END'
title = "a bed on ranks";
mesh = { size = [0.018, 0.036, 0.0072]; cells = [10, 20, 4]; };
fluid = { density = 1.2; viscosity = 1.8e-5; step = 2e-4; tolerance = 1e-12;
    continuity = "void-rate"; bottom = { inlet = 0.6; }; top = { outlet = 0.0; };
    sides = "no-slip"; front_back = "slip"; };
particles = { contact = "hertz"; step = 2e-5;
    grains = { density = 1000; young = 1.2e5; poisson = 0.33; restitution = 0.9; friction = 0.1; };
    bed = { count = 1000; diameter = 1.2e-3; seed = 1; settle = 0.0; }; };
averaging = { method = "diffusion"; bandwidth = 3.6e-3; tolerance = 1e-10; };
exchange = { drag = "syamlal-obrien"; };
effects = { gravity = [0.0, -9.81, 0.0]; pressure_gradient = {}; };
output = { end = 0.004; every = 1.0; picture = false; };
END
# The same, its spheres too heavy to move: the flow alone.
sed 's/density = 1000/density = 1e12/; s/-9.81/0.0/; s/"diffusion"/"pcm"/
     s/end = 0.004/end = 0.002/; s/diameter = 1.2e-3/diameter = 0.9e-3/' bed.cfg >flow.cfg

echo "ranks:"
# --- the flow: solvers to 1e-12 leave 1e-12 (u) and 1e-11 (p); a layer less 1e-6
$winnow run flow.cfg -o flow --quiet >said 2>&1
for n in 1 2 3; do
    fact "the_flow_of_${n}_ranks_is_that_of_one_machine" \
        alike '1 1 1e-10 1e-10' 800 flow "flow-$n" "$n" run flow.cfg
done
fact one_layer_fewer_spoils_the_flow sh -c "$(cat <<END
mpirun -n 3 --oversubscribe --bind-to none $build/winnow-mpi run flow.cfg -o thin -s layers=1 --quiet
set -- \$($compare 800 flow/checkpoint thin/checkpoint)
echo \$* && awk -v u=\$3 'BEGIN { exit !(u > 1e-9) }'
END
)"
for scheme in van-leer linear; do
    on 1 run flow.cfg -o "$scheme-1" -s fluid.convection=$scheme >said
    fact "${scheme}_has_the_layers_that_it_needs" alike '1 1 1e-10 1e-10' 800 \
        "$scheme-1" "$scheme-3" 3 run flow.cfg -s fluid.convection=$scheme
done

# --- the bed: 1e-9 d is 1.2e-12 m; 4e-16 m were found
on 1 run bed.cfg -o one >said
for cuts in 2,1,1 3,1,1 2,2,1 1,2,1 1,4,1; do
    n=$(($(echo $cuts | tr , '*')))
    fact "a_bed_cut_$(echo $cuts | tr , x)_is_that_of_one_rank" \
        alike '1.2e-12 1.2e-12 1e-9 1e-9' 800 one "bed-$cuts" "$n" run bed.cfg -s "ranks=[$cuts]"
done
# --- what is written: all columns, the fields and particles that ParaView opens
columns() { # every column of the last row but residuals and counts of iterations
    awk -F, 'NR == FNR { if (FNR == 1) n = NF; for (i = 1; i <= NF; i++) { if (FNR == 1) head[i] = $i; a[i] = $i } next }
        { for (i = 1; i <= NF; i++) b[i] = $i }
        END { for (i = 1; i <= n; i++) { if (head[i] ~ /residual|splitting|relabelled|iterations/) continue
                  d = a[i] - b[i]; if (d < 0) d = -d; s = a[i] < 0 ? -a[i] : a[i]
                  if (d > 1e-8 * s + 1e-18) { print head[i], a[i], b[i]; bad = 1 } }
              exit bad }' "$1/history.csv" "$2/history.csv"
}
fact every_column_of_the_history_is_that_of_one_rank columns one bed-2,2,1
sed 's/every = 1.0/every = 0.002; profiles = ({ field = "eps_f"; height = 0.005; }); probes = ({ field = "p"; position = [0.009, 0.003, 0.003]; })/' \
    bed.cfg >shown.cfg
on 1 run shown.cfg -o shown-1 >said
on 4 run shown.cfg -o shown-4 -s 'ranks=[2,1,2]' >said
pieces() {
    /usr/bin/python3 -c 'import vtkmodules' 2>/dev/null || return 0
    /usr/bin/python3 "$pieces" shown-1 shown-4
}
fact pieces_of_4_ranks_are_read_by_vtk_as_the_whole pieces

lines() {
    paste -d, "shown-1/$1" "shown-4/$1" | awk -F, 'NR > 1 { n++; for (i = 1; i <= NF / 2; i++) {
        d = $i - $(i + NF / 2); if (d * d > 1e-18 * $i * $i) { print; exit 1 } } } END { exit n == 0 }'
}
fact profiles_are_those_of_one_rank lines profiles/eps_f_y5mm.csv
fact probes_of_4_ranks_are_those_of_one lines probes.csv
# --- each rank has its part only
sed 's/count = 1000/count = 60000/; s/size = .*;/size = [0.06, 0.12, 0.03]; cells = [20, 40, 10]; };/
     s/end = 0.004/end = 0.0004/; s/tolerance = 1e-12/tolerance = 1e-6/; s/diameter = 1.2e-3/diameter = 1e-3/' bed.cfg >many.cfg
for n in 1 4; do on $n run many.cfg -o "many-$n" >said; done
peak() { # the largest of a number of the ranks
    grep -o "\"$2\": [0-9]*" "$1/summary.json" | awk -v what="$2" '{ n++ } n > (what == "particles" || what == "cells" || what == "peak_memory") && $2 > most { most = $2 } END { print most }'
}
parts() { # particles to a fifth of their share; memory, without 65 MB that a process takes, to less than a half
    echo "$(peak many-1 peak_memory) $(peak many-4 peak_memory) $(peak many-4 particles)"
    [ "$(peak many-4 particles)" -lt 18000 ] &&
        [ $((2 * ($(peak many-4 peak_memory) - 65000000))) -lt $(($(peak many-1 peak_memory) - 65000000)) ]
}
fact four_ranks_share_particles_and_memory parts
# --- a bed that all ranks settle
sed 's/settle = 0.0/settle = 1.0/; s/count = 1000/count = 300/' bed.cfg >settled.cfg
for n in 1 2; do on $n run settled.cfg -o "settled-$n" -s output.end=0.0004 >said; done
rests() {
    for n in 1 2; do last "settled-$n" "mean_height [m]"; done | awk '{ h[NR] = $1 }
        END { print h[1], h[2]; d = h[1] / h[2] - 1; exit !(d * d < 1e-4 && h[1] < 0.004) }'
}
fact a_bed_settles_on_2_ranks_as_on_one rests
# --- beside plain Winnow: LAMMPS' contacts differ at the order of delta / R
$winnow run bed.cfg -o plain --quiet >said 2>&1
fact the_engine_follows_one_machine_for_20_steps \
    below '1.2e-7 1.2e-8 1e-4 1e-4' 800 plain one
on 2 run bed.cfg -o far -s output.end=0.02 >said
$winnow run bed.cfg -o farther --quiet -s output.end=0.02 >said 2>&1
fact the_engine_follows_one_machine_for_100_steps \
    below '1.2e-5 3.6e-6 0.2 0.2' 800 farther far
close_columns() { # of the two, within 3 %, for the pressure follows d eps/dt
    for column in "kinetic_energy_particles [J]" "pressure_drop [Pa]" "mean_height [m]"; do
        echo "$(last far "$column") $(last farther "$column")" |
            awk '{ print; d = $1 / $2 - 1; exit d * d > 9e-4 }' || return 1
    done
}
fact energy_pressure_and_height_of_the_two_agree close_columns

# --- the contact law alone: head-on, where both laws are the same
cat >impact.cfg <<'END'
title = "a pair and a wall, head-on, in next to nothing";
mesh = { size = [0.012, 0.006, 0.006]; cells = [4, 2, 2]; };
fluid = { density = 1e-12; viscosity = 1e-15; step = 1e-4;
    sides = "slip"; bottom_top = "slip"; front_back = "slip"; };
particles = { contact = "hertz"; step = 2e-6;
    grains = { density = 1000; young = 1e6; poisson = 0.3; restitution = 0.7; friction = 0.3; };
    place = ( { position = [0.0045, 0.003, 0.003]; velocity = [ 0.1, 0.0, 0.0]; diameter = 1.2e-3; },
              { position = [0.0060, 0.003, 0.003]; velocity = [-0.1, 0.0, 0.0]; diameter = 0.8e-3; },
              { position = [0.0100, 0.0009, 0.003]; velocity = [0.0, -0.2, 0.0]; diameter = 1e-3; } ); };
averaging = { method = "pcm"; };
exchange = { drag = "schiller-naumann"; };
output = { end = 0.01; every = 1.0; picture = false; };
END
for law in hertz linear; do
    sed "s/\"hertz\"/\"$law\"/" impact.cfg >"$law.cfg"
    [ $law = hertz ] || sed -i 's/young = 1e6; poisson = 0.3/stiffness = 200/' $law.cfg
    $winnow run $law.cfg -o "$law-plain" --quiet >said 2>&1
    fact "${law}_pair_and_wall_rebound_as_on_one_machine_over_many_runs" \
        alike '1e-13 1e-13 1 1' 16 "$law-plain" "$law-2" 2 run $law.cfg
done
cat >dry.cfg <<'END'
@include "hertz.cfg"
END
awk '/^fluid/ { skip = 1 } !skip { print } /;};$|; };$/ { if (skip && /front_back/) skip = 0 }' hertz.cfg |
    grep -v '^averaging\|^exchange' >dry.cfg
$winnow run dry.cfg -o dry --quiet >said 2>&1
exported() {
    "$winnow" export dry.cfg --to lammps -o deck || return 1
    command -v lmp >/dev/null || return 0
    (cd deck && lmp -in in.lammps -log none >lmp.out 2>&1) || { cat deck/lmp.out; return 1; }
    tail -3 deck/dump.lammps >deck/end
    cat deck/end
    # the velocities after both impacts: those of the engine, to 1e-12
    awk 'NR == FNR { v[$1 - 1, 1] = $7; v[$1 - 1, 2] = $8; next }
         { for (k = 1; k <= 2; k++) { d = v[$1, k] - $(k + 1); if (d * d > 1e-24) exit 1 } }' \
        deck/end velocities
}
"$compare" velocities hertz-2/checkpoint >velocities 2>said
fact exported_particles_move_in_lammps_as_on_the_engine exported

# --- a closed periodic box: what is kept
awk 'BEGIN { srand(3)
    print "title = \"closed periodic box\";"
    print "mesh = { size = [0.012, 0.012, 0.006]; cells = [8, 8, 4]; periodic = [true, true, true]; };"
    print "fluid = { density = 1.2; viscosity = 1.8e-5; step = 2e-4; tolerance = 1e-12; continuity = \"void-rate\"; };"
    print "particles = { contact = \"hertz\"; step = 2e-5;"
    print "  grains = { density = 1000; young = 1.2e5; poisson = 0.33; restitution = 0.9; friction = 0.1; };"
    printf "  place = ("
    for (i = 0; i < 6; i++) for (j = 0; j < 6; j++) for (k = 0; k < 3; k++)
        printf "%s{ position = [%.6f, %.6f, %.6f]; velocity = [%.4f, %.4f, %.4f]; diameter = 1.2e-3; }",
            n++ ? ",\n" : "", 0.001 + 0.002 * i + 0.0006 * (rand() - 0.5), 0.001 + 0.002 * j + 0.0006 * (rand() - 0.5),
            0.001 + 0.002 * k + 0.0006 * (rand() - 0.5), 0.6 * rand() - 0.3, 0.6 * rand() - 0.3, 0.6 * rand() - 0.3
    print "); };"
    print "averaging = { method = \"diffusion\"; bandwidth = 3.0e-3; tolerance = 1e-12; };"
    print "exchange = { drag = \"syamlal-obrien\"; };"
    print "effects = { pressure_gradient = {}; };"
    print "output = { end = 0.01; every = 1.0; picture = false; };" }' >closed.cfg
on 4 run closed.cfg -o closed -s 'ranks=[2,2,1]' >said
kept() { # drift of the momentum over the gross, 2.5e-5 N s: 108 m |v|
    awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) { if ($i ~ /^momentum_[xyz] /) c[++n] = i
                           if ($i ~ /^exchange_residual/) e = i } next }
        { for (k = 1; k <= n; k++) { if (NR == 2) f[k] = $c[k]; d = $c[k] - f[k]; if (d < 0) d = -d
              if (d > most) most = d }
          if ($e > worst) worst = $e }
        END { print most, worst; exit !(NR > 40 && most < 1e-12 * 2.5e-5 && worst < 1e-12) }' closed/history.csv
}
fact momentum_of_a_closed_box_is_kept_to_1e_12 kept
moved() { grep -q '"particles_on_another_rank": [1-9]' closed/summary.json; }
fact while_spheres_change_ranks moved
on 1 run closed.cfg -o closed-1 >said
fact a_periodic_box_cut_in_two_directions_is_that_of_one_rank \
    below '1.2e-12 1.2e-12 1e-9 1e-8' 256 closed-1 closed
shares() { # of one rank alone they would be those of a quarter of the box
    for dir in closed-1 closed; do
        grep -o '"mean_share": [0-9.e-]*' "$dir/summary.json" | head -n 1
    done | awk '{ s[NR] = $2 } END { print s[1], s[2]; d = s[1] - s[2]
        exit !(NR == 2 && s[1] > 0 && d * d < 1e-16 * s[1] * s[1]) }'
}
fact the_share_of_an_effect_is_that_of_all_ranks shares

# --- checkpoint, resume, ends
on 2 run bed.cfg -o half -s output.end=0.01 >said
on 3 run bed.cfg -o half -s output.end=0.02 --resume >said
on 2 run bed.cfg -o hurt -s output.end=0.001 >said
damaged() {
    printf x | dd of="$(ls hurt/checkpoint."$1".[012] | head -n 1)" bs=1 seek=20000 conv=notrunc 2>/dev/null
    printf x | dd of="$(ls hurt/checkpoint."$1".[012] | tail -n 1)" bs=1 seek=20000 conv=notrunc 2>/dev/null
    "$build/winnow-mpi" run bed.cfg -o hurt --resume --quiet >heard 2>&1
    found=$?
    cat heard
    [ $found -ne 0 ] && grep -q damaged heard
}
fact a_damaged_file_of_cells_is_noticed damaged cells
fact a_damaged_file_of_grains_is_noticed damaged grains
fact a_run_on_2_ranks_goes_on_with_3_to_1e_6_d below '1.2e-9 1.2e-9 1e-7 1e-7' 800 far half
pids_of() { # the ranks of the run in this folder, the first one first
    pgrep -f "winnow-mpi run bed.cfg -o $1" | while read -r pid; do
        [ "$(basename "$(readlink "/proc/$pid/exe")")" = winnow-mpi ] && echo "$pid"
    done
}
begun() { # waits until the run in the folder has a row
    for _ in $(seq 100); do
        [ "$(wc -l <"$1/history.csv" 2>/dev/null || echo 0)" -gt 3 ] && return 0
        sleep 0.2
    done
    return 1
}
signalled() { # folder, signal, rank, code
    on 2 run bed.cfg -o "$1" -s output.end=9 >ended &
    mpirun=$!
    begun "$1"
    kill "-$2" $(pids_of "$1" | sed -n "$3")
    wait $mpirun
    found=$?
    cat ended
    [ "$4" = any ] || [ "$found" -eq "$4" ] || return 1
    steps=$(last "$1" "time [s]")
    on 2 run bed.cfg -o "$1" -s "output.end=0.004" --resume >ended && return 0
    # it was farther already: then the end of the case must be later
    cat ended && on 2 run bed.cfg -o "$1" -s "output.end=$(echo "$steps" | awk '{ print $1 + 0.002 }')" --resume
}
fact sigterm_saves_ends_with_130_and_is_resumed signalled stopped TERM '1,2p' 130
fact a_rank_that_is_killed_ends_all_and_is_resumed signalled killed KILL '2p' any
sed 's/bed = .*; }; };/place = ( { position = [0.009, 0.02, 0.0036]; velocity = [0.0, 3.0, 0.0]; diameter = 1.2e-3; } ); };/
     s/young = 1.2e5/young = 10.0/; s/step = 2e-5/step = 2e-5; unsafe_step = true; max_overlap = 2.0/' bed.cfg >shot.cfg
lost() {
    code 3 "left the box" 2 run shot.cfg -o shot -s output.end=0.05 &&
        [ -s shot/checkpoint ] && grep -q '"exit_code": 3' shot/summary.json &&
        "$compare" 800 shot/checkpoint shot/checkpoint
}
fact a_lost_sphere_ends_all_ranks_with_3_and_leaves_the_last_state lost

# --- refusals, all on the first rank, in one line
refused() { # part, words of the case; one rank says it, and needs no mpirun
    part=$1
    shift
    "$build/winnow-mpi" run "$@" -o refused --quiet >heard 2>&1
    found=$?
    cat heard
    [ $found -eq 2 ] && grep -qF -- "$part" heard && [ ! -e refused ] &&
        [ "$(grep -c '^winnow:' heard)" -eq 1 ]
}
fact fewer_columns_than_ranks_are_refused_by_number \
    code 2 "next smaller number that fits is" 17 run bed.cfg -o refused -s 'mesh.cells=[18,2,2]'
fact ranks_that_do_not_fit_are_refused code 2 "mpirun has started 2" 2 run bed.cfg -o refused -s 'ranks=[3,1,1]'
with() { # case that has another line
    sed "$1" bed.cfg >other.cfg
}
with 's/bed = {/surfaces = ( { name = "w"; shape = "plane"; point = [0.0, 0.001, 0.0]; normal = [0.0, 1.0, 0.0]; } ); bed = {/'
fact surfaces_are_refused_on_2_ranks code 2 "particles.surfaces" 2 run other.cfg -o refused
with 's/effects = {/effects = { virtual_mass = {};/'
fact virtual_mass_is_refused refused "effects.virtual_mass" other.cfg
with 's/effects = {/effects = { saffman = {};/'
fact an_effect_that_is_not_divided_is_refused refused "effects.saffman" other.cfg
with 's/friction = 0.1/friction = 0.1; rolling_friction = 0.1/'
fact rolling_friction_is_refused refused "particles.grains.rolling_friction" other.cfg
with 's/bed = {/list = "none"; bed = {/'
fact contacts_off_are_refused refused "particles.list" other.cfg
with 's/settle = 0.0;/settle = 0.0; file = "bed.txt";/'
fact a_bed_of_a_file_is_refused refused "particles.bed.file" other.cfg
with 's/every = 1.0/every = 1.0; sorted = true/'
fact sorted_output_is_refused refused "output.sorted" other.cfg
with 's/cells = .10, 20, 4.;/cells = [10, 20, 4]; shear = [0.001, 0.0, 0.0];/'
fact a_sheared_mesh_is_refused refused "mesh.shear" other.cfg
for choice in averaging.method=kernel fluid.time=bdf2 fluid.outer_correctors=1 \
    exchange.slip_integration=exponential particles.integrator=symplectic-euler \
    'mesh.grading=[1.0,2.0,1.0]' particles.grains.restitution=0.05 averaging.scheme=crank-nicolson; do
    fact "$(echo "${choice%%=*}" | tr . _)_is_refused" refused "${choice%%=*}" bed.cfg -s "$choice"
done
one_machine() {
    "$winnow" run bed.cfg -o refused -s engine=distributed >heard 2>&1
    [ $? -eq 2 ] && grep -q winnow-mpi heard && [ ! -e refused ]
}
fact winnow_itself_names_the_other_program one_machine
estimated() {
    "$winnow" check bed.cfg -s engine=distributed >heard && grep -q 'time of one rank' heard &&
        grep -q 'memory of all ranks' heard
}
fact check_estimates_both_times_and_the_memory estimated
echo "ranks: $facts passed, $failed failed"
[ $failed -eq 0 ]
