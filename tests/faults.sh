#!/bin/sh
# What goes wrong around a run: signals, full disks, folders that are not ours,
# closed streams, odd names. Whatever happens, it ends by one clear line and an
# exit code, no half of a file is left, and what is there is from one run.
#
#   sh tests/faults.sh build/winnow [long]
#
# The same seeds each time. "long" tries more moments.
set -u
winnow=$(cd "$(dirname "${1:-build/winnow}")" && pwd)/winnow
extent=${2:-quick}
work=$(mktemp -d)
trap 'chmod -R u+w "$work"; rm -rf "$work"' EXIT
cd "$work" || exit 1
failed=0
facts=0
# Threads that wait should not keep others from working on a busy machine.
export OMP_WAIT_POLICY=passive

# fact NAME COMMAND...: the command succeeds; it says why if not.
fact() {
    name=$1
    shift
    if "$@" >why 2>&1; then
        facts=$((facts + 1)) && echo "    $name"
    else
        echo "FAILED $name:" && cat why
        failed=$((failed + 1))
    fi
}

# A stand-in that draws nothing: the true one takes a second.
mkdir bin
printf '#!/bin/sh\n: >"$4"\n' >bin/gnuplot
chmod +x bin/gnuplot
PATH=$work/bin:$PATH

cat >tiny.cfg <<'END_OF_CASE'
title = "two spheres in a little air";
mesh = { size = [0.006, 0.012, 0.006]; cells = [3, 6, 3]; };
fluid = { density = 1.2; viscosity = 1.8e-5; step = 2e-4;
          bottom = { inlet = 0.2; }; top = { outlet = 0.0; };
          sides = "no-slip"; front_back = "slip"; };
particles = { contact = "linear"; step = 1e-5;
    grains = { density = 1000; stiffness = 100; restitution = 0.9; friction = 0.1; };
    surfaces = ( { name = "floor"; shape = "plane"; point = [0.0, 0.0001, 0.0]; } );
    place = ( { position = [0.003, 0.002, 0.003]; diameter = 1e-3; },
              { position = [0.0031, 0.004, 0.003]; diameter = 1e-3; } ); };
averaging = { method = "kernel"; bandwidth = 4e-3; };
exchange = { drag = "syamlal-obrien"; };
effects = { gravity = [0.0, -9.81, 0.0]; pressure_gradient = {}; };
output = { end = 0.02; every = 0.01;
           probes = ( { field = "p"; position = [0.003, 0.006, 0.003]; } );
           profiles = ( { field = "eps_f"; height = 0.003; from = 0.01; } ); };
END_OF_CASE

# It would settle for a quarter of an hour.
cat >settling.cfg <<'END_OF_CASE'
title = "a bed that settles for long";
mesh = { size = [0.06, 1.2, 0.06]; cells = [6, 120, 6]; };
particles = { contact = "linear"; step = 1e-6;
    grains = { density = 1000; stiffness = 1000; restitution = 0.9; friction = 0.1; };
    bed = { count = 40000; diameter = 1e-3; seed = 1; settle = 100.0; }; };
effects = { gravity = [0.0, -9.81, 0.0]; };
output = { end = 0.02; every = 0.01; };
END_OF_CASE

# It would look for places for as long: there is hardly any room.
cat >searching.cfg <<'END_OF_CASE'
title = "spheres that look for room";
mesh = { size = [0.04, 0.04, 0.04]; cells = [2, 2, 2]; };
particles = { contact = "linear"; step = 1e-6;
    grains = { density = 1000; stiffness = 1000; restitution = 0.9; friction = 0.1; };
    insert = ( { count = 36000; diameter = 1e-3; from = [0.0, 0.0, 0.0];
                 to = [0.04, 0.04, 0.04]; seed = 1; } ); };
output = { end = 1.0; every = 0.01; };
END_OF_CASE

# signalled SIGNAL SECONDS ARGUMENTS...: sends a run the signal after so long;
# its exit code is in code. One that has not ended after 10 s is killed.
signalled() {
    number=$1 moment=$2
    shift 2
    "$winnow" run "$@" >said 2>&1 &
    run=$!
    sleep "$moment"
    kill -"$number" $run 2>/dev/null
    waited=0
    while kill -0 $run 2>/dev/null && [ $waited -lt 200 ]; do
        sleep 0.05
        waited=$((waited + 1))
    done
    kill -9 $run 2>/dev/null
    wait $run 2>/dev/null
    code=$?
}

no_part() { # FOLDER
    parts=$(find "$1" -name '*.partial' 2>/dev/null)
    [ -z "$parts" ] || { echo "left: $parts" && return 1; }
}

ends_at_once() { # SIGNAL CASE: before the run began, and leaves nothing
    signalled "$1" 0.3 "$2" -o early/out --quiet
    cat said
    echo "exit code $code"
    [ $code -eq 130 ] && [ "$(wc -l <said)" -eq 1 ] && grep -q interrupted said &&
        ! [ -e early/out ]
}
echo "signals:"
for number in INT TERM HUP; do
    fact "${number}_is_heard_while_a_bed_settles" ends_at_once $number settling.cfg
done
sed 's/cells = \[.*\]/cells = [100, 200, 100]/; s/40000/1/' settling.cfg >building.cfg
fact signal_is_heard_while_a_case_is_built ends_at_once TERM building.cfg

ends_as_interrupted() { # SIGNAL CASE
    signalled "$1" 0.4 "$2" -o late --quiet -s output.end=1000
    cat said
    echo "exit code $code"
    [ $code -eq 130 ] && grep -q '"exit_reason": "interrupted"' late/summary.json &&
        no_part late
}
for number in INT TERM HUP; do
    fact "${number}_ends_a_run_with_its_state" ends_as_interrupted $number tiny.cfg
done
fact signal_is_heard_while_spheres_look_for_room ends_as_interrupted TERM searching.cfg
survives_a_hangup() {
    (
        trap '' HUP
        signalled HUP 0.2 tiny.cfg -o kept --quiet -s output.end=0.3
        cat said
        [ $code -eq 0 ] && grep -q '"exit_reason": "done"' kept/summary.json
    )
}
fact run_under_nohup_survives_a_hangup survives_a_hangup

if [ $failed -gt 0 ]; then
    echo "$failed faults do not end as they should"
    exit 1
fi
echo "$facts facts hold (faults, $extent)"
