#!/bin/sh
# What goes wrong around a run: signals, full disks, folders that are not ours,
# closed streams, odd names. Whatever happens, it ends by one clear line and an
# exit code, no half of a file is left, and what is there is from one run.
#
#   sh tests/faults.sh build/winnow [long]
#
# The same seeds each time. "long" tries more moments.
set -u
# A process that was started by nohup never hears of a hangup, nor do its children.
if [ -z "${HEARS:-}" ] && env --default-signal=HUP true 2>/dev/null; then
    HEARS=hangups exec env --default-signal=HUP,INT,TERM sh "$0" "$@"
fi
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

# A stand-in that draws nothing, for the true one takes a second, and wants no
# other names than these.
mkdir bin
cat >bin/gnuplot <<'END_OF_SCRIPT'
#!/bin/sh
[ "$*" = "-c bed.gp .. ../bed.png.partial" ] && [ -e bed.gp ] && : >"$4"
END_OF_SCRIPT
chmod +x bin/gnuplot
true_path=$PATH
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
    insert = ( { count = 36000; diameter = 1e-3; start = 1e-6; from = [0.0, 0.0, 0.0];
                 to = [0.04, 0.04, 0.04]; seed = 1; } ); };
output = { end = 1.0; every = 0.01; };
END_OF_CASE

# One row at the end: the whole run is one step of the loop.
cat >alone.cfg <<'END_OF_CASE'
title = "two grains for long";
mesh = { size = [0.01, 0.01, 0.01]; cells = [1, 1, 1]; };
particles = { contact = "linear"; step = 1e-6; list = "verlet";
    grains = { density = 1000; stiffness = 100; restitution = 0.9; friction = 0.1; };
    place = ( { position = [0.003, 0.002, 0.003]; diameter = 1e-3; },
              { position = [0.0031, 0.004, 0.003]; diameter = 1e-3; } ); };
effects = { gravity = [0.0, -9.81, 0.0]; };
output = { end = 1000.0; every = 1000.0; };
END_OF_CASE

# signalled SIGNAL SECONDS ARGUMENTS...: sends a run the signal after so long;
# its exit code is in code. One that has not ended after 10 s is killed.
signalled() {
    number=$1 moment=$2
    shift 2
    : >said # a signal may come before the new process opens it
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

ends_at_once() { # SIGNAL CASE: before the run began; a bed on its way to rest is kept
    rm -rf early
    signalled "$1" 0.3 "$2" -o early/out --quiet
    cat said
    echo "exit code $code"
    kept=
    grep -q "while the bed settled" said && kept="checkpoint.ahead manifest.txt"
    left=$(cd early/out 2>/dev/null && echo *)
    [ $code -eq 130 ] && [ "$(wc -l <said)" -eq 1 ] && grep -q interrupted said &&
        [ "$left" = "$kept" ]
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
for list in verlet link-cells all-pairs none; do
    sed "s/verlet/$list/" alone.cfg >alone-$list.cfg
    fact "signal_is_heard_within_a_step_of_an_hour_with_list_$list" \
        ends_as_interrupted TERM alone-$list.cfg
done
sed 's/verlet"/&; integrator = "heun"/' alone.cfg >alone-heun.cfg
fact signal_is_heard_within_a_step_of_an_hour_by_heun ends_as_interrupted TERM alone-heun.cfg
fact signal_is_heard_while_spheres_look_for_room ends_as_interrupted TERM searching.cfg
# A gnuplot that hangs: the second signal ends it.
hangs() {
    mkdir -p hung && printf '#!/bin/sh\nexec sleep 60\n' >hung/gnuplot && chmod +x hung/gnuplot
    PATH=$work/hung:$PATH "$winnow" run tiny.cfg -o hanging --quiet -s output.end=1000 >said 2>&1 &
    run=$!
    sleep 0.3
    for turn in 1 2 3 4 5 6 7 8 9 10; do
        kill $run 2>/dev/null || break
        sleep 0.3
    done
    wait $run
    code=$?
    cat said
    [ $code -eq 130 ] && [ $turn -lt 10 ] && grep -q interrupted hanging/summary.json
}
fact second_signal_ends_a_gnuplot_that_hangs hangs
# A grain that leaves, none, and one again, with every effect there is: what
# looks for pairs has an end where there is nobody (a width grew from 0 for ever).
cat >gone.cfg <<'END_OF_CASE'
title = "one grain that leaves, and one that comes";
mesh = { size = [0.01, 0.02, 0.01]; cells = [2, 4, 2]; };
fluid = { density = 1.2; viscosity = 1.8e-5; step = 2e-4;
    bottom = { inlet = 0.2; }; top = { outlet = 0.0; };
    sides = "no-slip"; front_back = "slip"; };
particles = { contact = "linear"; step = 1e-5;
    grains = { density = 1000; stiffness = 100; restitution = 0.8; friction = 0.3;
        charge = 1e-12; };
    place = ( { position = [0.005, 0.002, 0.005]; diameter = 1e-3; velocity = [0.0, -1.0, 0.0]; } );
    insert = ( { count = 2; diameter = 1e-3; rate = 100.0; velocity = [0.0, -1.0, 0.0];
        from = [0.0, 0.0, 0.0]; to = [0.01, 0.004, 0.01]; } );
    sinks = ( { side = "bottom"; } ); };
averaging = { method = "diffusion"; bandwidth = 4e-3; };
exchange = { drag = "gidaspow"; };
effects = { gravity = [0.0, -9.81, 0.0]; capillary = { tension = 0.07; };
    van_der_waals = { hamaker = 1e-19; range = 1e-5; };
    electrostatic = { range = 1e-3; }; pressure_gradient = {}; viscous_stress = {};
    virtual_mass = {}; basset = {}; saffman = {}; fluid_torque = {}; magnus = {};
    time_average = { time = 0.01; }; energy_budget = {};
    stochastic_drag = { sigma_low = 0.1; sigma_high = 0.1; time = 0.01; };
    lubrication = { roughness = 1e-5; range = 1e-4; }; bubbles = { height = 0.01; };
    mixing = { sample = 2e-3; }; };
output = { end = 0.03; every = 0.01; contacts = true; };
END_OF_CASE
sed '/^fluid/,/front_back/d; /^averag/,/^exch/d; s/pressure_grad.*//; s/virtual_m.*//
    s/time_av.*/energy_budget = {};/; s/stochas.*//; s/lubri.*//' gone.cfg >dry.cfg
sed 's/insert.*rate = 100.0/insert = ( { count = 1; diameter = 1e-3; rate = 10.0/
    s/place.*//' dry.cfg >later.cfg
ends_by_itself() { timeout -k 1 20 "$winnow" run "$1.cfg" -o "$1" --quiet; }
for name in gone dry later; do
    fact "run_without_a_grain_ends_by_itself_$name" ends_by_itself $name
done
survives_a_hangup() {
    (
        trap '' HUP
        signalled HUP 0.1 tiny.cfg -o kept --quiet -s output.end=0.1
        cat said
        [ $code -eq 0 ] && grep -q '"exit_reason": "done"' kept/summary.json
    )
}
fact run_under_nohup_survives_a_hangup survives_a_hangup


# A case that writes less, and nothing of the fluid.
sed '/^fluid/,/^ *sides/d; /^averaging/d; /^exchange/d; /probes/d; /profiles/d
     s/ pressure_gradient = {};//; s/every = 0.01;/& };/' tiny.cfg >other.cfg

# A bed that settles for a moment and is kept in a file, then runs for one.
cat >bed.cfg <<'END_OF_CASE'
title = "a bed in a little air";
mesh = { size = [0.006, 0.012, 0.006]; cells = [3, 6, 3]; };
fluid = { density = 1.2; viscosity = 1.8e-5; step = 2e-4;
          bottom = { inlet = 0.2; }; top = { outlet = 0.0; };
          sides = "no-slip"; front_back = "slip"; };
particles = { contact = "linear"; step = 1e-5;
    grains = { density = 1000; stiffness = 100; restitution = 0.9; friction = 0.1; };
    bed = { count = 150; diameter = 1e-3; seed = 1; settle = 0.2; file = "kept.bed"; }; };
averaging = { method = "kernel"; bandwidth = 4e-3; };
exchange = { drag = "syamlal-obrien"; };
effects = { gravity = [0.0, -9.81, 0.0]; pressure_gradient = {}; };
output = { end = 0.02; every = 0.01; };
END_OF_CASE

# files FOLDER: what is in it.
files() { (cd "$1" && find . ! -type d | sed 's,^\./,,' | LC_ALL=C sort); }

# Of a folder, whatever has happened to it: each file is listed; it is of the
# run that the summary tells of; one that is called done has all its files.
of_one_run() { # FOLDER
    [ -d "$1" ] || return 0
    (files "$1" | sed 's/\.partial$//' | grep -vxF -f "$1/manifest.txt" |
        grep -vx 'manifest.txt\|notes.txt\|checkpoint.ahead') && echo "not listed" && return 1
    [ -e "$1/summary.json" ] || return 0
    if grep -q '"exit_reason": "done"' "$1/summary.json"; then
        for of in tiny other bed; do
            grep -q "$of.cfg" "$1/summary.json" || continue
            files "$1" | grep -vx 'notes.txt\|checkpoint.ahead\(.partial\)*' |
                diff $of.files - || return 1
        done
    elif grep -q other.cfg "$1/summary.json"; then
        ! [ -e "$1/probes.csv" ] && ! [ -e "$1/fluid" ]
    fi
}

echo "folders:"
for kind in tiny other bed; do
    "$winnow" run $kind.cfg -o $kind --quiet >said 2>&1 || cat said
    files $kind >$kind.files
done
fact each_file_of_a_run_is_listed of_one_run tiny
replaced() {
    echo mine >tiny/notes.txt
    "$winnow" run other.cfg -o tiny >said 2>&1 || return 1
    cat said
    grep -q "tiny: the files of an earlier run are replaced" said &&
        files tiny | diff - other.files | grep -q '< notes.txt' && of_one_run tiny
}
fact next_run_replaces_all_of_the_one_before_and_nothing_else replaced
second_run() {
    "$winnow" run tiny.cfg -o both --quiet -s output.end=1000 >first 2>&1 &
    run=$!
    while ! [ -e both/fluid.pvd ]; do sleep 0.02; done
    ln -s both alias
    "$winnow" run other.cfg -o alias --quiet >said 2>&1
    code=$?
    kill $run
    wait $run
    cat said
    [ $code -eq 4 ] && [ "$(wc -l <said)" -eq 1 ] && grep -q "process $run" said &&
        grep -q tiny.cfg both/summary.json && of_one_run both
}
fact second_run_into_a_folder_is_refused_and_touches_nothing second_run
wrong_input() {
    "$winnow" run tiny.cfg -o wrong/folder --quiet \
        -s particles.place.1.position='[0.003, 0.002, 0.003]' >said 2>&1
    code=$?
    cat said
    [ $code -eq 2 ] && ! [ -e wrong ]
}
fact input_found_wrong_while_building_leaves_no_folder wrong_input
settling_first() {
    cp -r other before
    signalled TERM 0.3 settling.cfg -o before --quiet
    [ $code -eq 130 ] && diff -r -x checkpoint.ahead other before
}
fact run_that_ends_before_it_begins_leaves_the_old_one_whole settling_first
in_the_way() {
    mkdir way && echo mine >way/history.csv
    "$winnow" run tiny.cfg -o way --quiet >said 2>&1
    code=$?
    cat said
    [ $code -eq 4 ] && [ "$(wc -l <said)" -eq 1 ] && [ "$(files way)" = history.csv ]
}
fact foreign_file_in_the_way_refuses_the_run in_the_way
links() {
    mkdir links away && echo mine >away/mine
    for link in summary.json history.csv fluid.pvd bed.png; do
        ln -s ../away/mine links/$link.partial
    done
    "$winnow" run tiny.cfg -o links --quiet >said 2>&1
    code=$?
    cat said
    [ $code -eq 0 ] && [ "$(cat away/mine)" = mine ] && files links | diff tiny.files -
}
fact parts_do_not_follow_links links

# unwritable FOLDER: exit code 4, one line, and nothing is there.
unwritable() {
    as_nobody "$winnow" run tiny.cfg -o "$1" --quiet >said 2>&1
    code=$?
    cat said
    [ $code -eq 4 ] && [ "$(wc -l <said)" -eq 1 ]
}
as_nobody() { "$@"; }
fact folder_that_is_a_file_is_refused unwritable tiny.cfg
fact folder_below_a_file_is_refused unwritable tiny.cfg/a/b
fact name_that_is_too_long_is_refused unwritable "$(printf 'long%.0s' $(seq 100))"
mkdir locked && chmod 555 locked
cp -r other written && chmod -R a-w written && chmod 755 .
[ "$(id -u)" -ne 0 ] || as_nobody() { setpriv --reuid=65534 --clear-groups "$@"; }
if as_nobody test -x "$winnow" 2>/dev/null && as_nobody test -r tiny.cfg; then
    fact read_only_folder_is_refused unwritable locked
    fact read_only_run_is_refused_and_stays unwritable written
    fact read_only_run_has_not_changed diff -r other written
fi
as_nobody() { "$@"; }

echo "names:"
fact empty_name_is_refused sh -c '"$1" run none.cfg -o "" >said 2>&1
    [ $? -eq 2 ] && grep "not an empty one" said' - "$winnow"
# odd NAME: a case and a folder of that name run, and nothing is run by it. The
# names would make a file called struck.
odd() {
    cp tiny.cfg "./$1.cfg" && "$winnow" run ./"$1.cfg" -o "$1" --quiet >said 2>&1
    code=$?
    cat said
    rm -f "./$1.cfg"
    [ $code -eq 0 ] && files ./"$1" | diff tiny.files - && ! find . | grep struck$
}
n=0
for odd in '<touch struck;' '|touch struck;' '`touch struck`' '$(touch struck)' \
    "it's a \"bed\"" '-s' '%s%n%d' 'Blåsbälg ☃' ' ' '#' 'back\' '*' \
    "$(printf 'long%.0s' $(seq 60))"; do
    n=$((n + 1))
    fact "odd_name_${n}_is_a_name" odd "$odd"
done
dotted() {
    cp tiny.cfg ...cfg && "$winnow" run ...cfg --quiet >said 2>&1 && [ -d out/...cfg ]
}
fact case_called_dot_dot_does_not_run_into_the_folder_above dotted
# The same with the true gnuplot, and in the title.
titled() { # TITLE NAME
    title=$(printf '%s' "$1" | sed 's/[\\"]/\\&/g; s/[\\&|]/\\&/g')
    sed "s|two spheres in a little air|$title|" tiny.cfg >titled.cfg
    (PATH=$true_path && "$winnow" run titled.cfg -o "$2" --quiet) >said 2>&1
    code=$?
    cat said "$2/picture/gnuplot.log"
    [ $code -eq 0 ] && [ -s "$2/bed.png" ] && ! find . | grep struck$
}
if (PATH=$true_path && command -v gnuplot) >/dev/null; then
    fact gnuplot_runs_no_folder titled 'a "bed", it'\''s' '<touch struck;'
    fact gnuplot_runs_no_title titled \
        "'.system('touch struck').' \`touch struck\` @x \$x %s {/*9 x}_^ \\" '|touch struck;'
fi

# closed STREAMS CODE: a run without them ends so, and is what it is with them.
closed() {
    case $1 in
    0) "$winnow" run tiny.cfg -o closed <&- >said 2>&1 ;;
    1) "$winnow" run tiny.cfg -o closed 2>said >&- ;;
    2) "$winnow" run tiny.cfg -o closed >said 2>&- ;;
    012) "$winnow" run tiny.cfg -o closed <&- >&- 2>&- ;;
    pipe) { "$winnow" run tiny.cfg -o closed 2>&1 && echo done >ended; } | true
        [ -e ended ] ;;
    esac
    code=$?
    echo "exit code $code"
    [ $code -eq "$2" ] && files closed | diff tiny.files - &&
        cmp closed/history.csv whole/history.csv && cmp closed/probes.csv whole/probes.csv &&
        grep -q '"done"' closed/summary.json
}
echo "closed streams:"
"$winnow" run tiny.cfg -o whole >said 2>&1 || cat said
fact run_needs_no_input closed 0 0
fact results_that_nobody_reads_are_code_4 closed 1 4
fact run_needs_nobody_to_listen closed 2 0
fact run_without_any_stream_is_whole closed 012 4

# A limit on the size of files stands for a full disk, that of history.csv too.
full_disk() { # KILOBYTES
    (
        trap '' XFSZ
        ulimit -f "$1"
        "$winnow" run tiny.cfg -o full --quiet -s "mesh.cells=[$2]" -s output.end=0.2
    ) >said 2>&1
    code=$?
    cat said
    echo "exit code $code"
    [ $code -eq 4 ] && no_part full && of_one_run full && grep -q full/ said &&
        ! grep -q '"done"' full/summary.json
}
echo "full disks:"
for blocks in 2 8 64; do
    fact full_disk_at_${blocks}_blocks_ends_with_what_is_whole full_disk $blocks 3,6,3
done

# moments COUNT SEED LONGEST: so many, the same each time [s].
moments() {
    awk -v n="$1" -v seed="$2" -v longest="$3" 'BEGIN {
        srand(seed); for (i = 0; i < n; i++) printf "%.3f\n", longest * rand() }'
}

# tries QUICK LONG: how many there are.
tries() { [ "$extent" = long ] && echo "$2" || echo "$1"; }

unkept() {
    "$winnow" run bed.cfg -o unkept --quiet -s particles.bed.file=none/kept.bed >said 2>&1
    code=$?
    cat said
    [ $code -eq 4 ] && [ "$(wc -l <said)" -eq 1 ] && ! [ -e unkept ]
}
fact bed_that_cannot_be_kept_is_code_4_and_leaves_no_folder unkept

# killed COUNT: kills that nothing can hear, at moments up to the length of a
# run, whose folder the next one takes.
killed() {
    kind=other
    for moment in $(moments "$1" 20 0.12); do
        kind=$([ "$kind" = tiny ] && echo other || echo tiny)
        "$winnow" run $kind.cfg -o killed --quiet >said 2>&1 &
        run=$!
        sleep "$moment"
        kill -9 $run 2>/dev/null
        wait $run 2>/dev/null
        of_one_run killed || { echo "at $moment s, $kind" && return 1; }
    done
    "$winnow" run other.cfg -o killed --quiet && files killed | diff other.files -
}

# interrupted COUNT: signals that are heard, at such moments. A run that ends
# before it begins leaves no folder, or the one that was there.
interrupted() {
    for moment in $(moments "$1" 21 0.3); do
        number=$([ "${number:-}" = TERM ] && echo HUP || echo TERM)
        rm -f kept.bed
        signalled $number "$moment" bed.cfg -o heard --quiet
        # While the picture is drawn it ends gnuplot, which is said.
        ! grep -qs 'no picture: gnuplot' said || : >heard/bed.png
        of_one_run heard && no_part . &&
            case $code in
            0) grep -q '"done"' heard/summary.json ;;
            130) grep -q interrupted said && ! grep -qs '"running"' heard/summary.json ;;
            129 | 143) ! [ -s said ] ;; # before it had begun to hear
            *) false ;;
            esac || { cat said && echo "$number at $moment s: exit code $code" && return 1; }
    done
}

# at_once COUNT: four runs begin in one new folder at the same time.
at_once() {
    for turn in $(seq "$1"); do
        rm -rf race
        for run in 1 2 3 4; do
            { "$winnow" run tiny.cfg -o race/here --quiet >said.$run 2>&1
              echo $? >code.$run; } &
        done
        wait
        cat code.* | sort | uniq -c
        cat said.*
        grep -qx 0 code.? && ! grep -qvx '[04]' code.? && of_one_run race/here &&
            grep -q '"done"' race/here/summary.json || return 1
    done
}

# A disk of our own that is full, where we may have one.
true_disk() { # KILOBYTES
    mkdir -p disk && mount -t tmpfs -o size="$1k" none disk || return 1
    "$winnow" run tiny.cfg -o disk/full --quiet -s output.end=1 -s output.every=2e-4 >said 2>&1
    code=$?
    cat said
    [ $code -eq 4 ] && no_part disk && of_one_run disk/full &&
        ! grep -q '"done"' disk/full/summary.json
    held=$?
    umount disk
    return $held
}

echo "moments:"
fact whenever_a_run_is_killed_its_folder_is_of_one_run killed "$(tries 8 300)"
fact whenever_a_run_is_interrupted_its_folder_is_whole interrupted "$(tries 6 200)"
fact of_runs_that_begin_at_once_one_has_the_folder at_once "$(tries 2 30)"
if [ "$extent" = long ] && mkdir -p disk && mount -t tmpfs -o size=64k none disk 2>/dev/null; then
    umount disk
    for size in 16 32 100 400 1000; do
        fact full_disk_of_${size}_kB_ends_with_what_is_whole true_disk $size
    done
fi

echo "faults, $extent: $facts passed, $failed failed"
[ $failed -eq 0 ]
