#!/bin/sh
# A study as a person meets it: its processes, its tables, its advice.
#
#   sh tests/study.sh build/winnow
set -u
winnow=$(cd "$(dirname "${1:-build/winnow}")" && pwd)/winnow
top=$PWD
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
export OMP_WAIT_POLICY=passive
failed=0
facts=0

# fact NAME COMMAND...: the command succeeds.
fact() {
    name=$1
    shift
    if "$@" >said 2>&1; then
        facts=$((facts + 1)) && echo "    $name"
    else
        echo "FAILED $name:" && cat said
        failed=$((failed + 1))
    fi
}

# The field of a row of study.csv, by the head of its column, in all runs. No
# value of these studies has a comma.
column() { # file head
    awk -F, -v head="$2" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == head) c = i; next }
                          { print $c }' "$1"
}

# A channel between two walls starts to flow: sixteen cells.
cat >channel.cfg <<'END'
title = "a channel starts to flow";
mesh = { size = [0.01, 0.01, 0.01]; cells = [1, 16, 1];
         periodic = [true, false, true]; };
fluid = { density = 1000; viscosity = 0.1; step = 0.01; bottom_top = "no-slip";
          mean_gradient = [-10.0, 0.0, 0.0]; convection = "linear"; tolerance = 1e-13; };
output = { end = 0.32; every = 0.32;
    probes = ( { field = "u_x"; position = [0.005, 0.005, 0.005]; } );
    profiles = ( { field = "u_x"; height = 0.005; },
                 { field = "u_x"; along = "y"; x = 0.005; from = 7.9; } ); };
END
# A few grains in a little air that do not lie still.
cat >grains.cfg <<'END'
title = "a few grains";
mesh = { size = [0.006, 0.012, 0.006]; cells = [3, 6, 3]; };
fluid = { density = 1.2; viscosity = 1.8e-5; step = 2e-4;
          bottom = { inlet = 0.9; }; top = { outlet = 0.0; };
          sides = "no-slip"; front_back = "slip"; };
particles = { contact = "linear"; step = 2e-5;
    grains = { density = 1000; stiffness = 20; restitution = 0.9; friction = 0.1; };
    bed = { count = 20; diameter = 1.2e-3; settle = 0.02; }; };
averaging = { method = "kernel"; bandwidth = 4e-3; };
exchange = { drag = "syamlal-obrien"; };
effects = { gravity = [0.0, -9.81, 0.0]; pressure_gradient = {}; };
output = { end = 0.02; every = 0.01; };
END

echo "orders that are known:"
# Implicit Euler is of order 1, BDF2 of order 2; the next term of the error is
# still a twentieth of it at these steps.
"$winnow" study channel.cfg -s fluid.time=euler,bdf2 -s fluid.step=0.02,0.01,0.005 --times 3 \
    --measure u_x --truth extrapolated -o time --quiet
order() { # of the line in the study, from, to
    sed -n "s/^- .*$2: extrapolated with the order //p" "$1/study.md" |
        awk -v low="$3" -v high="$4" '{ n++; if ($1 < low || $1 > high) wrong = 1 }
                                      END { exit n != 1 || wrong }'
}
fact euler_is_reported_with_order_1 order time euler 0.95 1.05
fact bdf2_is_reported_with_order_2 order time bdf2 1.9 2.15
# A parabola between walls, u = G y (h - y) / (2 mu), has the kinetic energy
# (rho/2) (G / 2 mu)^2 h^5/30 for each area of a wall, here of 1e-4 m^2. The cells
# meet it to second order.
"$winnow" study channel.cfg -s output.end=8 \
    -s mesh.cells:fluid.step='[1,8,1]:2.0,[1,16,1]:1.0,[1,32,1]:0.5' --times 3 --measure kinetic_energy_fluid --truth '0.5*1000*50^2*0.01^5/30*1e-4' \
    --measure profile.1@0.001..0.009 --truth '50*x*(0.01 - x)' -o cells --quiet
cells_are_second_order() { # column of study.md
    awk -F' [|] ' -v c="$1" '/^\| cells/ { n++; if (n > 1 && ($c + 0 < 1.9 || $c + 0 > 2.15)) wrong = 1 }
                   END { exit n != 3 || wrong }' cells/study.md
}
fact cells_are_reported_with_order_2_against_a_formula cells_are_second_order 5
fact a_profile_along_y_is_the_parabola_of_the_channel_to_order_2 cells_are_second_order 8
# A flow through both walls of a channel blows the profile along it to one side, V u' =
# nu u'' + g with u = 0 below and u' = 0 above: a layer of nu/V, eight cells of the
# finest mesh at the top. Upwind convection is of order 1, from below, since the layer
# is thin; linear convection of order 2.
cat >blown.cfg <<'END'
title = "a channel with a flow through its walls";
mesh = { size = [0.01, 0.02, 0.01]; cells = [1, 16, 1]; periodic = [true, false, true]; };
fluid = { density = 1000; viscosity = 0.1; step = 0.02; bottom = { inlet = 0.05; };
          top = { outlet = 0.0; }; mean_gradient = [-100.0, 0.0, 0.0]; tolerance = 1e-12; };
output = { end = 2; every = 2;
    probes = ( { field = "u_x"; position = [0.005, 0.0175, 0.005]; } );
    profiles = ( { field = "u_x"; along = "y"; x = 0.005; from = 1.99; } ); };
END
"$winnow" study blown.cfg -s fluid.convection=upwind,linear \
    -s mesh.cells='[1,16,1],[1,32,1],[1,64,1]' --measure u_x -o blown --quiet \
    --truth '0.1/0.05*(0.0175 - 1e-4/0.05*exp(-10)*(exp(0.0175*500) - 1))'
blown_has_order() { # scheme, from, to
    awk -F' [|] ' -v scheme="=$1," -v low="$2" -v high="$3" '
        /^[|]/ && index($1, scheme) { n++; if (n == 3 && ($5 + 0 < low || $5 + 0 > high)) wrong = 1 }
        END { exit n != 3 || wrong }' blown/study.md
}
fact upwind_convection_is_reported_with_order_1_against_a_formula blown_has_order upwind 0.8 1.05
fact linear_convection_is_reported_with_order_2_against_a_formula blown_has_order linear 1.9 2.1
# A sphere that rests on a spring falls into it, v = g/w sin(wt), w^2 = k/m, and never
# leaves it: the force has no jump, and velocity-Verlet is of second order.
cat >spring.cfg <<'END'
title = "a sphere on its spring";
mesh = { size = [0.01, 0.01, 0.01]; cells = [1, 1, 1]; };
particles = { contact = "linear"; step = 1e-4; unsafe_step = true; expected_overlap = 0.5;
    grains = { density = 1000; stiffness = 0.5; restitution = 1.0; friction = 0.0; };
    place = ( { position = [0.005, 0.0005, 0.005]; diameter = 1e-3; } ); };
effects = { gravity = [0.0, -9.81, 0.0]; };
output = { end = 2.4e-3; every = 2.4e-3; };
END
m='(1000*pi/6*1e-9)'
"$winnow" study spring.cfg -s particles.step=2e-4,1e-4,5e-5 --measure kinetic_energy_particles \
    --truth "0.5*$m*(9.81/sqrt(0.5/$m)*sin(sqrt(0.5/$m)*t))^2" -o spring --quiet
verlet_is_second_order() {
    awk -F' [|] ' '/^\| step/ { n++; if (n > 1 && ($5 + 0 < 1.95 || $5 + 0 > 2.05)) wrong = 1 }
                   END { exit n != 3 || wrong }' spring/study.md
}
fact velocity_verlet_is_reported_with_order_2_against_a_formula verlet_is_second_order
# Frozen drag is explicit Euler, of order 1 in the sub-steps [XS11 4.1].
"$winnow" study "$top/cases/one-grain.cfg" -s exchange.substeps=4,8,16 \
    --measure us_y@0.0011 -o grain --quiet --truth "XS11:4.1 rho_s=2000 eps_s=3.74e-5 \
rho_f=1000 mu=1e-3 d=8.3e-5 u_f=0.05"
substeps_are_first_order() {
    awk -F' [|] ' '/^\| substeps/ { n++; if (n > 1 && ($5 + 0 < 0.95 || $5 + 0 > 1.2)) wrong = 1 }
                   END { exit n != 3 || wrong }' grain/study.md
}
fact xs11_4_1_sub_steps_are_reported_with_order_1 substeps_are_first_order

echo "tables and advice:"
# Each number of study.csv is the one of the summary, to the last digit.
sums_agree() {
    n=0
    for folder in time/runs/*; do
        for key in processor cfd dem output total; do
            value=$(sed -n "s/^ *\"$key\": \([^,]*\),*$/\1/p" "$folder/summary.json")
                column time/study.csv "$key [s]" | grep -qxF -- "$value" || return 1
            n=$((n + 1))
        done
    done
    [ $n -eq 90 ]
}
fact seconds_in_study_csv_are_those_of_the_summaries sums_agree
# A line across a bed is the same in a mirror, one along gravity is not.
"$winnow" run grains.cfg -o lines --quiet >said 2>&1 -s output.end=1e-3 \
    -s 'output.profiles=({field="eps_f";height=0.003;},{field="eps_f";along="y";x=0.003;})'
mirror_of() { sed -n "/\"$1\"/,/}/p" lines/summary.json | grep -c mirror_error; }
mirrors_agree() { [ "$(mirror_of eps_f_y3mm)" = 1 ] && [ "$(mirror_of eps_f_along_y_x3mm)" = 0 ]; }
fact a_profile_along_gravity_has_no_mirror_error mirrors_agree
# The cheapest row within the limit, found again from study.csv; of those that cost the
# same to a tenth the case as it stands, or else the one with the least error.
advice_agrees() {
    best=$(awk -F, '
        NR == 1 { for (i = 1; i <= NF; i++) { if ($i == "processor [s]") s = i
                  if ($i ~ /^error of/) e = i }; next }
        $e <= 0.01 { cost[++n] = $s; error[n] = $e; name[n] = "time=" $2 ", step=" $3
                     if (n == 1 || $s < first) first = $s }
        END { for (i = 1; i <= n; i++) {
                  if (cost[i] - first > 0.1 * sqrt((cost[i] ^ 2 + first ^ 2) / 2)) continue
                  if (name[i] == "time=euler, step=0.01") error[i] = -1
                  if (best == "" || error[i] < error[best]) best = i }
              print name[best] }' time/study.csv)
    grep '^- for 1 %' time/study.md | grep -qF -- ": $best"
}
fact advice_is_the_cheapest_row_within_the_limit advice_agrees
# Three steps with errors of 3, 1.5 and 0.8 %, the last one the case as it stands, and
# processor times that are written into their summaries.
"$winnow" study channel.cfg -s fluid.step=0.04,0.02,0.01 --measure u_x -o ties --quiet
exact='0.00125 - 0.04/pi^3*exp(-pi^2*0.32) + 0.04/(3*pi)^3*exp(-9*pi^2*0.32)'
advised() { # limit, seconds of the three steps; the step that is named
    limit=$1
    shift
    for step in 0.04 0.02 0.01; do
        sed -i "s/\"processor\": [^,]*/\"processor\": $1/" ties/runs/step=$step/summary.json
        shift
    done
    "$winnow" study channel.cfg -s fluid.step=0.04,0.02,0.01 --measure u_x -o ties --quiet \
        --truth "$exact" >said 2>&1
    sed -n "s/^- $limit.*step=//p" ties/study.md
}
times_within_a_tenth_are_the_same() {
    [ "$(advised 'for 5 %' 1.0 2.0 3.0)" = 0.04 ] && # as a time
        [ "$(advised 'for 5 %' 1.0 1.09 3.0)" = 0.02 ] && # the smaller error
        [ "$(advised 'for 5 %' 1.0 1.2 3.0)" = 0.04 ] &&
        [ "$(advised 'for 5 %' 1.0 0.95 1.05)" = 0.01 ] && # the case as it stands
        [ -z "$(advised 'as much' 1.0 0.95 1.05)" ] &&
        [ "$(advised 'half of' 1.0 1.04 3.0)" = 0.02 ]
}
reference_is_as_cheap() {
    exact=finest
    [ "$(advised 'for 5 %' 1.0 2.0 3.0)" = 0.04 ] &&
        [ "$(advised 'for 5 %' 1.0 2.0 1.05)" = 0.01 ] && # which they are compared with
        [ "$(advised 'for 5 %' 2.0 2.0 1.0)" = 0.01 ]
}
fact times_that_differ_by_less_than_a_tenth_are_the_same times_within_a_tenth_are_the_same
fact nothing_as_dear_as_the_case_is_advised_in_its_place reference_is_as_cheap
# Two drags in three beds, 3 and 2.1 s in the mean, and those of the second scattered so
# that chance explains it, or not.
"$winnow" study grains.cfg -s exchange.drag=syamlal-obrien,gidaspow -s output.end=0.002 --seeds 3 \
    --measure steps --truth 10 -o drags --quiet
named_of_beds() { # seconds of the second drag
    for seed in 0 1 2; do
        sed -i "s/\"processor\": [^,]*/\"processor\": 3/" \
            drags/runs/drag=syamlal-obrien+seed-$seed/summary.json
        sed -i "s/\"processor\": [^,]*/\"processor\": $1/" \
            drags/runs/drag=gidaspow+seed-$seed/summary.json
        shift
    done
    "$winnow" study grains.cfg -s exchange.drag=syamlal-obrien,gidaspow -s output.end=0.002 --seeds 3 \
        --measure steps --truth 10 -o drags --quiet
    sed -n 's/^- for 5 %.*drag=//p' drags/study.md
}
scatter_of_beds_counts() {
    [ "$(named_of_beds 2.0 2.1 2.2)" = gidaspow ] && # 2.1 +- 0.06
        [ "$(named_of_beds 1.0 3.0 2.3)" = syamlal-obrien ] # 2.1 +- 0.59
}
fact costs_that_chance_explains_over_the_seeds_are_the_same scatter_of_beds_counts
# 0.32 s are eight steps of 0.04 s, and eleven of 0.03 s are 0.33 s.
times_that_differ_are_told() {
    "$winnow" study channel.cfg -s fluid.step=0.04,0.02 --measure u_x -o even >even.said 2>&1 &&
        "$winnow" study channel.cfg -s fluid.step=0.03,0.02 --measure u_x -o odd >heard 2>&1
    cat even.said heard
    ! grep -q 'last values' even.said && grep -q 'last values are those of 0.32 to 0.33 s' heard
}
fact last_values_of_different_times_are_told times_that_differ_are_told
order_that_is_reversed_is_told() {
    "$winnow" study channel.cfg -s fluid.step=0.02,0.04 -s 'mesh.cells=[1,16,1],[1,8,1]' \
        --measure u_x -o odd --dry-run >heard 2>&1 &&
        "$winnow" study channel.cfg -s fluid.step=0.04,0.02 -s 'mesh.cells=[1,8,1],[1,16,1]' \
            --measure u_x -o odd --dry-run >even.said 2>&1
    cat even.said heard
    ! grep -q 'fine to coarse' even.said &&
        grep -q 'fluid.step goes from fine to coarse; its last value, 0.04, counts' heard &&
        grep -q 'mesh.cells goes from fine to coarse' heard
}
fact values_from_fine_to_coarse_are_told order_that_is_reversed_is_told
picture_is_there() {
    grep -q '</svg>' time/study.svg && [ -s time/study.png ]
}
fact the_picture_is_drawn picture_is_there

echo "what winnow check says beforehand:"
# estimate CASE CHOICE: "time-ratio error-ratio", of the line of that choice.
estimate() {
    "$winnow" check "$1" | awk -v choice="  $2 " '
        index($0, choice) == 1 {
            time = substr($0, length(choice) + 1) + 0
            error = $(NF - 1) == "over" ? 1 / $NF : $NF
            print time, error
        }'
}
# within ESTIMATED FOUND: by a factor of two.
within() { awk "BEGIN { exit !($1 > 0 && $2 / $1 < 2 && $2 / $1 > 0.5) }"; }
# rows FOLDER COLUMN PATTERN: the numbers of that column of study.md, in turn.
rows() {
    awk -F ' *[|] *' -v c="$2" -v p="$3" '/^[|]/ && $2 ~ p { print $c + 0 }' "$1/study.md" |
        tr '\n' ' '
}
# The errors and the times of a row over those of the one before it; if that is
# several times as coarse, of each of them in the mean.
holds() { # case choice folder pattern error-column [times]
    # shellcheck disable=SC2046 # two numbers
    set -- "$1" "$2" "$3" "$4" "$5" "${6:-1}" $(estimate "$1" "$2")
    time=$(rows "$3" 3 "$4" | awk "{ print (\$NF / \$(NF - 1)) ^ (1 / $6) }")
    error=$(rows "$3" "$5" "$4" | awk "{ print (\$NF / \$(NF - 1)) ^ (1 / $6) }")
    echo "time $7 found $time, error $8 found $error"
    within "$7" "$time" && within "$8" "$error"
}
fact the_step_of_a_flow_costs_and_gains_what_check_says \
    holds channel.cfg 'fluid.step halved' time 'time=euler' 5
fact its_cells_cost_and_gain_what_check_says \
    holds channel.cfg 'mesh.cells doubled, fluid.step halved' cells 'cells=' 5
# Without a dashpot; its microseconds tell nothing.
spring_gains() {
    said=$(estimate spring.cfg 'particles.step halved' | cut -d ' ' -f 2)
    found=$(rows spring 5 step= | awk '{ print $NF / $(NF - 1) }')
    echo "error $said found $found"
    within "$said" "$found"
}
fact the_step_of_grains_that_lose_nothing_gains_what_check_says spring_gains
sphere=$top/cases/settling-sphere.cfg
nothing_of_impacts() {
    "$winnow" check "$sphere" -s particles.list=none >heard || return 1
    grep -q 'fluid.step halved' heard && ! grep -q 'particles.step halved' heard
}
fact of_grains_that_never_meet_check_says_nothing_of_impacts nothing_of_impacts
"$winnow" study "$sphere" -s fluid.step=4e-3,2e-3,1e-3 -s output.end=0.032 \
    --measure mean_fall_velocity --truth extrapolated -o sphere --times 2 --quiet
fact the_step_of_a_sphere_costs_and_gains_what_check_says \
    holds "$sphere" 'fluid.step halved' sphere 'step=' 5

# The drag of a grain, 4 and 8 sub-steps: the study above.
sed 's/substeps = 1;/substeps = 4;/' "$top/cases/one-grain.cfg" >four.cfg
fact sub_steps_cost_and_gain_what_check_says \
    holds four.cfg 'exchange.substeps doubled' grain 'substeps=[48]' 5
# A wave of grains fades with the square of the bandwidth.
wave=$top/cases/studies/wave.cfg
"$winnow" study "$wave" -s averaging.bandwidth=8e-3,4e-3 --measure profile.0 --times 2 \
    --truth '600*pi/6/(48*64)*(1 + 0.5*cos(2*pi*x/0.048))' -o wave --quiet
# A cavity at Re = 100 with 24 cells a side; the truth is that of 12, 24 and 48 cells by
# second-upwind, extrapolated with their order of 2.3. Before a cavity is steady, what a
# tolerance and a corrector leave.
sed 's/"linear"/"upwind"/; s/32, 32, 1/24, 24, 1/; s/= 2.5e-3/= 1e-2/; s/step = 0.02/step = 0.03/
     s/30.0/12.0/' "$top/cases/cavity.cfg" >cavity.cfg
"$winnow" study cavity.cfg -s fluid.convection=upwind,second-upwind --measure probe.0 \
    --times 2 --truth -0.2326 -o convection --quiet
# Near the fastest upward flow [Ghia82] linear convection has no error that happens to
# be none, as it has near the other.
sed 's/"upwind"/"linear"/' cavity.cfg >linear.cfg
"$winnow" study linear.cfg -s fluid.convection=linear,upwind --measure probe.1 \
    --times 2 --truth 0.17527 -o linear --quiet
"$winnow" study linear.cfg -s fluid.convection=linear,second-upwind --measure probe.1 \
    --times 2 --truth 0.17527 -o second --quiet
fact second_order_convection_costs_and_gains_what_check_says \
    holds cavity.cfg 'fluid.convection = second-upwind' convection 'convection=' 5
fact linear_convection_costs_and_gains_what_check_says_over_upwind \
    holds linear.cfg 'fluid.convection = upwind' linear 'convection=' 5
fact and_second_order_upwind_over_linear \
    holds linear.cfg 'fluid.convection = second-upwind' second 'convection=' 5
# The whole profile of the flow through walls, with a layer of 0.3 of the width; and a flow
# that enters on the left, turns between two walls and leaves at the top.
sed 's/viscosity = 0.1/viscosity = 0.3/' blown.cfg >layer.cfg
"$winnow" study layer.cfg -s fluid.convection=upwind,second-upwind -o layer --times 3 --quiet \
    --measure profile.0 --truth '2*(x - 6e-3*exp(-10/3)*(exp(x*500/3) - 1))'
fact in_a_layer_convection_costs_and_gains_what_check_says \
    holds layer.cfg 'fluid.convection = second-upwind' layer 'convection=' 5
cat >bend.cfg <<'END'
mesh = { size = [0.1, 0.1, 0.01]; cells = [16, 16, 1]; periodic = [false, false, true]; };
fluid = { density = 1000; viscosity = 0.1; step = 0.04;
          left = { inlet = 0.05; profile = "parabola"; }; top = { outlet = 0.0; };
          bottom = "no-slip"; right = "no-slip"; };
output = { end = 8; every = 8; history = 8;
    profiles = ( { field = "u_y"; height = 0.05; from = 7.9; } ); };
END
"$winnow" study bend.cfg --measure profile.0 -o bend --times 3 --quiet \
    -s fluid.convection:mesh.cells:fluid.step='upwind:[16,16,1]:0.04,second-upwind:[16,16,1]:0.04,second-upwind:[48,48,1]:0.02'
fact in_a_bend_convection_costs_and_gains_what_check_says \
    holds bend.cfg 'fluid.convection = second-upwind' bend '16,16' 5
# Between two walls nothing is carried from cell to cell, and no scheme differs.
nothing_is_said() { ! "$winnow" check channel.cfg | grep -q 'fluid.convection = '; }
fact along_a_channel_check_says_nothing_of_convection nothing_is_said
"$winnow" study "$top/cases/cavity.cfg" -s fluid.tolerance=1e-4,1e-8,1e-13 --times 3 \
    -s output.end=0.4 -s output.history=0.4 --measure probe.0 -o tolerance --quiet
sed 's/step = 0.02;/&tolerance = 1e-6;/' "$top/cases/cavity.cfg" >sixth.cfg
fact four_digits_of_tolerance_cost_and_gain_what_check_says \
    holds sixth.cfg 'fluid.tolerance over 10' tolerance 'tolerance=1e-[48]' 5 4
"$winnow" study "$top/cases/cavity.cfg" -s fluid.correctors=2,3,6 --times 3 -s output.end=0.4 \
    -s output.history=0.4 -s fluid.piso_tolerance=0 --measure probe.0 -o correctors --quiet
fact a_corrector_costs_and_gains_what_check_says \
    holds "$top/cases/cavity.cfg" 'fluid.correctors one more' correctors 'correctors=[23]' 5
fact a_bandwidth_costs_and_gains_what_check_says \
    holds "$wave" 'averaging.bandwidth halved' wave 'bandwidth=' 5

echo "processes:"
# Killed in the middle without a word, the study goes on: what has ended is not
# done again, and what a killed study has left behind is waited for.
study="-s particles.step=2e-5,1e-5,5e-6,2.5e-6 --measure mean_height -o killed -j 1 --quiet"
killed_goes_on() {
    # shellcheck disable=SC2086 # words
    "$winnow" study grains.cfg $study >/dev/null &
    pid=$!
    until [ "$(ls killed/runs 2>/dev/null | wc -l)" -ge 3 ]; do sleep 0.02; done
    kill -9 $pid
    wait $pid 2>/dev/null
    before=$(cat killed/runs/step=2e-5/summary.json)
    # shellcheck disable=SC2086
    "$winnow" study grains.cfg $study >/dev/null || return 1
    [ "$before" = "$(cat killed/runs/step=2e-5/summary.json)" ] &&
        [ "$(column killed/study.csv exit_code | sort | uniq -c | tr -d ' ')" = 40 ]
}
fact a_killed_study_goes_on_and_does_no_run_twice killed_goes_on
# Told to stop, its runs leave their state, and go on from it to the same end.
stopped_goes_on() {
    long="-s particles.step=1e-5,5e-6 -s output.end=0.2 --measure mean_height -j 2 --quiet"
    # shellcheck disable=SC2086 # words
    "$winnow" study grains.cfg $long -o whole >/dev/null
    # shellcheck disable=SC2086
    "$winnow" study grains.cfg $long -o stopped >/dev/null 2>&1 &
    pid=$!
    until [ -s stopped/runs/step=5e-6/history.csv ]; do sleep 0.02; done
    kill $pid
    wait $pid
    [ $? -eq 130 ] && [ -e stopped/runs/step=5e-6/checkpoint ] || return 1
    # shellcheck disable=SC2086
    "$winnow" study grains.cfg $long -o stopped >/dev/null || return 1
    [ "$(column whole/study.csv mean_height)" = "$(column stopped/study.csv mean_height)" ]
}
fact a_study_that_is_stopped_goes_on_in_the_middle_of_its_runs stopped_goes_on
# Thousands of cases take a while to read; a signal does not wait for the last one.
# (On a busy machine it may not yet hear the signal: then once more, later.)
stops_while_it_reads() {
    for seconds in 0.3 1 3; do
        "$winnow" study grains.cfg -s particles.step=2e-5,1e-5 --seeds 1000 --times 4 \
            --measure mean_height -o read >/dev/null 2>heard &
        pid=$!
        sleep $seconds
        kill $pid
        wait $pid
        code=$?
        [ $code -eq 143 ] || break
    done
    [ $code -eq 130 ] && grep -q 'before the first run' heard && [ ! -e read ]
}
fact a_study_is_stopped_while_it_reads_its_cases stops_while_it_reads
# The same folder with another case: nothing of the old one is taken for it.
changed_case_is_done_again() {
    before=$(cat killed/runs/step=2e-5/summary.json)
    # shellcheck disable=SC2086
    "$winnow" study grains.cfg $study -s fluid.viscosity=3e-5 >/dev/null || return 1
    [ "$before" != "$(cat killed/runs/step=2e-5/summary.json)" ]
}
fact another_case_is_done_again changed_case_is_done_again
# The same names, but a file that the case names has other bytes: grains that stand
# in another place.
sed 's/bed = .*/place = ( { position = [0.003, 0.009, 0.003]; diameter = 1e-3; } );\n    surfaces = ( { name = "plate"; shape = "stl"; file = "plate.stl"; } ); };/' \
    grains.cfg >plate.cfg
plate() { # height of a plate of one triangle
    printf 'solid p\nfacet normal 0 1 0\nouter loop\nvertex 0 %s 0\nvertex 0 %s 0.02\n' "$1" "$1"
    printf 'vertex 0.02 %s 0\nendloop\nendfacet\nendsolid p\n' "$1"
}
changed_file_is_done_again() {
    plate 0.002 >plate.stl
    file="-s particles.step=2e-5,1e-5 -s output.end=0.002 --measure mean_height -o plate --quiet"
    # shellcheck disable=SC2086 # words
    "$winnow" study plate.cfg $file >/dev/null || return 1
    # shellcheck disable=SC2086
    "$winnow" study plate.cfg $file --dry-run | grep -q '2 of them done' || return 1
    plate 0.003 >plate.stl
    # shellcheck disable=SC2086
    "$winnow" study plate.cfg $file --dry-run | grep -q ' 0 of them done'
}
fact a_changed_file_that_the_case_names_is_done_again changed_file_is_done_again
threads_change_no_bit() {
    "$winnow" study grains.cfg -s threads=1,2 -s particles.bed.count=20 --measure mean_height \
        --cost seconds.total -o threads --quiet >/dev/null || return 1
    [ "$(column threads/study.csv mean_height | sort -u | wc -l)" -eq 1 ] &&
        grep -q '"threads": 2' threads/runs/threads=2/summary.json
}
fact threads_are_varied_and_change_no_bit threads_change_no_bit
# Then the finest is no judge of the others: both are within any limit, the cheaper is
# advised, or the case as it stands if that cannot be told, and there is no error to be
# drawn.
same_bits_are_compared_by_cost() {
    "$winnow" study grains.cfg -s threads=1,2 -s particles.bed.count=20 --measure mean_height \
        --cost seconds.total -o threads >heard 2>&1 || return 1
    cat heard
    cheaper=$(awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "total [s]") t = i; next }
        { took[NR] = $t }
        END { less = took[2] - took[3] > 0.1 * sqrt((took[2] ^ 2 + took[3] ^ 2) / 2)
              print "threads=" (less ? 2 : 1) }' threads/study.csv)
    [ "$(grep -c '| 0 % |' threads/study.md)" -eq 2 ] &&
        [ "$(grep -c "^- for .* %: .* error 0 %: $cheaper\$" heard)" -eq 3 ] &&
        grep -q 'no picture: all variants agree to the last bit' heard && [ ! -e threads/study.gp ]
}
fact the_same_bits_as_the_finest_are_compared_by_cost same_bits_are_compared_by_cost
killed_run_is_a_result() {
    "$winnow" study grains.cfg -s particles.step=2e-5,1e-5 -s output.end=9 --measure mean_height \
        -o shot -j 2 --quiet >/dev/null 2>&1 &
    pid=$!
    until [ -s shot/runs/step=1e-5/history.csv ]; do sleep 0.02; done
    # shellcheck disable=SC2046 # two processes, of that study alone
    kill -9 $(cat /proc/[0-9]*/stat 2>/dev/null | awk -v of=$pid '$4 == of { print $1 }')
    wait $pid && [ "$(grep -c "exit code 137: ended by a signal" shot/study.md)" -eq 2 ]
}
fact a_run_that_a_signal_ends_is_a_result killed_run_is_a_result
finest_may_break_down() {
    "$winnow" study grains.cfg -s particles.step=2e-5,2e-4 -s particles.unsafe_step=false \
        --measure mean_height -o no-finest >heard 2>&1 || return 1
    cat heard
    grep -q 'no error is known: the finest has not come to its end' heard &&
        [ -e no-finest/runs/step=2e-5 ] # one key ends with .step, another with _step
}
fact if_the_finest_breaks_down_that_is_told finest_may_break_down
broken_run_is_a_result() {
    # A step of the springs that does not resolve them, and one refused for it.
    "$winnow" study grains.cfg -s particles.step=2e-5,2e-4 -s particles.unsafe_step=false \
        --measure mean_height -o broken --quiet >said || return 1
    column broken/study.csv exit_code | tr '\n' ' ' | grep -qx '0 2 ' &&
        grep -q 'exit code 2: winnow: ' broken/study.md
}
fact a_run_that_breaks_down_is_a_result broken_run_is_a_result
seeds_have_errors() {
    "$winnow" study grains.cfg -s exchange.drag=syamlal-obrien,gidaspow --seeds 3 --times 2 \
        --measure mean_height -o seeds --quiet >/dev/null || return 1
    [ "$(ls seeds/runs | wc -l)" -eq 12 ] || return 1
    # The standard error of three heights, from study.csv and in study.md [%].
    sed -n 's/.*gidaspow.* +- \([0-9.e-]*\) %.*/\1/p' seeds/study.md >found
    awk -F, 'NR > 1 && $2 == "gidaspow" && $4 == 0 { h[n++] = $(NF - 3) }
        END { m = (h[0] + h[1] + h[2]) / 3
              for (i = 0; i < 3; i++) s += (h[i] - m) ^ 2
              print 100 * sqrt(s / 6) / m }' seeds/study.csv >expected
    paste expected found | awk '{ exit !($2 > 0 && $1 / $2 > 0.99 && $1 / $2 < 1.01) }'
}
fact seeds_give_a_standard_error seeds_have_errors
# A group that is set as a whole has no seed of its own, and an effect may have one.
seeds_go_last() {
    "$winnow" study grains.cfg -s 'particles.bed={count=20;diameter=1.2e-3;settle=0.02;}' \
        -s 'effects.stochastic_drag=as-is,{sigma_low=0.3;sigma_high=0.2;time=0.01;}' \
        -s exchange.treatment=explicit -s output.end=0.002 --seeds 2 --measure mean_height \
        -o group --quiet >/dev/null || return 1
    [ "$(column group/study.csv mean_height | sort -u | wc -l)" -eq 4 ]
}
fact seeds_reach_into_groups_that_are_set_and_into_effects seeds_go_last
dry_run_writes_nothing() {
    "$winnow" study grains.cfg -s particles.step=2e-5,1e-5 --measure mean_height \
        -o dry --dry-run >said || return 1
    grep -q '^2 runs, 0 of them done' said && [ ! -e dry ]
}
fact a_dry_run_writes_nothing dry_run_writes_nothing

echo "study files:"
mkdir -p there
cat >there/study.cfg <<'END'
title = "steps";
case = "../channel.cfg";
vary = ( { keys = "fluid.step"; values = "0.04, 0.02"; },
         { keys = "fluid.time"; values = "euler, bdf2"; } );
measures = ( { of = "u_x"; truth = "truth.csv"; } );
END
printf 'time [s],u [m/s]\n0,0.0012\n1,0.0012\n' >there/truth.csv
file_is_read() {
    "$winnow" study there/study.cfg -s fluid.time=bdf2 -o file --quiet >heard 2>&1 || return 1
    [ "$(ls file/runs | wc -l)" -eq 2 ] && grep -q '^# steps' file/study.md &&
        [ "$(column file/study.csv 'truth of u_x' | head -1)" = 0.0012 ]
}
fact a_study_file_is_read_and_the_command_line_goes_before file_is_read
quiet_prints_nothing() { # the study above; not so one without the word, which has its runs
    cat heard
    [ ! -s heard ] && "$winnow" study there/study.cfg -s fluid.time=bdf2 -o file |
        grep -qx 'see file/study.md, study.csv and study.svg'
}
fact quiet_prints_nothing quiet_prints_nothing

echo "wrong input:"
# refused NAME PART WORDS...: exit code 2, one message, nothing written.
refused() {
    part=$1
    shift
    "$winnow" study "$@" -o refused >said 2>&1
    [ $? -eq 2 ] && [ ! -e refused ] && grep -qF -- "$part" said &&
        [ "$(grep -c '^winnow:' said)" -eq 1 ]
}
fact a_value_that_no_case_may_have refused 'option -s fluid.step=-1' \
    channel.cfg -s fluid.step=0.1,-1 --measure u_x
fact a_key_that_is_none refused 'did you mean fluid.step' \
    channel.cfg -s fluid.stp=0.1,0.2 --measure u_x
fact a_value_twice refused 'a value is there twice' \
    channel.cfg -s fluid.step=0.1,0.1 --measure u_x
fact a_measure_that_is_none refused 'did you mean mean_height' \
    channel.cfg -s fluid.step=0.1,0.2 --measure mean_hight
fact nothing_to_look_at refused 'what is to be looked at' channel.cfg -s fluid.step=0.1,0.2
fact nothing_to_compare refused 'nothing to compare' channel.cfg --measure u_x
fact a_truth_that_is_none refused 'expected a formula' \
    channel.cfg -s fluid.step=0.1,0.2 --measure u_x --truth finset
fact a_word_is_no_third_number refused 'three numbers or more' \
    "$sphere" -s particles.skin=2e-4,auto,1e-4 --measure mean_fall_velocity --truth extrapolated
fact seeds_where_nothing_is_random refused 'no group with a seed' \
    channel.cfg -s fluid.step=0.1,0.2 --measure u_x --seeds 3
fact a_key_twice_in_one_choice refused 'a key is there twice' \
    channel.cfg -s fluid.step:fluid.step=0.1:0.1,0.2:0.2 --measure u_x
fact a_bracket_that_is_not_closed refused 'a bracket or a quote without' \
    channel.cfg -s 'mesh.cells=[1,8,1,[1,16,1]' --measure u_x
fact a_value_too_few refused 'not as many values' \
    channel.cfg -s fluid.step:fluid.density=0.1:9,0.2 --measure u_x
fact a_time_before_the_start refused 'before 0 s' \
    channel.cfg -s fluid.step=0.1,0.2 --measure mean:u_x@-0.1
fact a_time_that_is_no_number refused 'expected @FROM' \
    channel.cfg -s fluid.step=0.1,0.2 --measure mean:u_x@nan
fact a_number_twice refused 'a value is there twice' channel.cfg -s fluid.step=0.1,1e-1 --measure u_x
fact a_time_after_the_end refused 'after output.end' \
    channel.cfg -s fluid.step=0.1,0.2 --measure u_x@0.5
fact a_column_that_the_case_has_not refused 'for want of' \
    channel.cfg -s fluid.step=0.1,0.2 --measure mean_height
fact a_truth_of_nothing refused 'no error is relative to that' \
    channel.cfg -s fluid.step=0.1,0.2 --measure u_x --truth 1-1
fact seeds_that_are_varied_as_well refused 'is varied, so that --seeds' \
    grains.cfg -s particles.bed.seed=1,2 --measure mean_height --seeds 2
printf 'time [s],u [m/s]\n0.1,1\n0,1\n' >falling.csv
fact a_table_that_falls refused 'does not rise' \
    channel.cfg -s fluid.step=0.1,0.2 --measure u_x --truth falling.csv
fact more_runs_than_anybody_waits_for refused 'more than 10000 runs' \
    grains.cfg -s particles.step=2e-5,1e-5 --measure mean_height --seeds 1000 --times 1000
fact a_cost_that_is_a_curve refused 'a run costs one number' \
    channel.cfg -s fluid.step=0.1,0.2 --measure u_x --cost profile.0
fact an_option_that_is_none refused 'did you mean --measure' \
    channel.cfg -s fluid.step=0.1,0.2 --mesure u_x
printf 'time [s],u [m/s]\n0,1\n1,inf\n' >endless.csv
fact a_table_that_is_not_finite refused 'an infinite number' \
    channel.cfg -s fluid.step=0.1,0.2 --measure u_x --truth endless.csv
sed 's/channel.cfg/there\/study.cfg/' there/study.cfg | sed 's/\.\.\///; s/truth.csv/none/' >study.cfg
fact a_study_of_a_study refused 'is a study, and a study asks for a case' study.cfg
# A link to nowhere is there, and is no folder.
ln -s nowhere link
why_no_folder() {
    "$winnow" study channel.cfg -s fluid.step=0.1,0.2 --measure u_x -o link 2>heard
    [ $? -eq 4 ] && cat heard && grep -q 'cannot make the folder link: File exists' heard
}
fact a_folder_that_cannot_be_made_says_why why_no_folder
mkdir linked others && ln -s ../others linked/runs
link_of_runs() {
    "$winnow" study channel.cfg -s fluid.step=0.1,0.2 --measure u_x -o linked 2>heard
    [ $? -eq 4 ] && cat heard && grep -q 'linked/runs is a link' heard && rmdir others
}
fact a_link_of_the_runs_leads_nowhere link_of_runs
cat >wrong.cfg <<'END'
case = "channel.cfg"; vary = (); measure = ();
END
fact a_study_file_with_a_wrong_key refused 'did you mean measures' wrong.cfg

echo "study: $facts passed, $failed failed"
[ $failed -eq 0 ]
