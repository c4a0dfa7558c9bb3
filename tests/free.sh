#!/bin/sh
# An effect that is off costs nothing. For each effect of coupling/effects a
# program is linked from whose list its descriptor is left out; the same bed in it
# and in the whole program, which has the effect and does not name it, must allocate
# the same arrays, enter the same functions and run the same pieces of code, counted in
# the modules coupling and dem. With the effect named more functions are entered, and no fewer
# arrays allocated (whole_drag needs none): the count sees it.
#
#   sh tests/free.sh build          (ends with "free: N passed, 0 failed")
set -u
build=${1:-build}
cc=${CC:-gcc}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0 facts=0
export OMP_NUM_THREADS=1

libs=${LIBS:-"-lconfig -lgsl -lgslcblas $(pkg-config --libs hdf5 2>/dev/null ||
    echo -lhdf5) -lz -lm"}
flags="-std=c11 -D_POSIX_C_SOURCE=200809L -fopenmp -Isrc -O1"
wrap="-Wl,--wrap=alloc_zeroed,--wrap=alloc_doubles,--wrap=alloc_ints"
counted="src/coupling/coupling.c src/coupling/effects.c src/coupling/transfer.c
    src/coupling/reaction.c
    src/dem/dem.c src/dem/fast/chunk_step.c
    src/dem/fast/rows.c"

# What says what it runs; the rest is as in the program.
instrument() { # source
    $cc $flags -finstrument-functions -fsanitize-coverage=trace-pc -c \
        -o "$work/$(basename "$1" .c).o" "$1"
}
objects=
for file in $counted; do
    instrument "$file" || exit
    objects="$objects $work/$(basename "$file" .c).o"
done
$cc $flags -c -o "$work/count.o" tests/free/count.c || exit

link() { # program
    # shellcheck disable=SC2086
    $cc -fopenmp $wrap -o "$1" "$work/count.o" $objects "$build/libwinnow.a" $libs
}

fact() { # name, 1 if it holds
    [ "$2" = 1 ] && facts=$((facts + 1)) && return
    echo "FAILED free: $1"
    failed=$((failed + 1))
}

link "$work/whole" || exit
off=$("$work/whole" tests/free/bed.cfg 5)
echo "# a hundred spheres, 5 steps: arrays, calls and pieces of code"
echo "# off, in the whole program: $off"
echo "# effect         without its file        named"

# Name in a case, descriptor, its group, and what else it takes.
while read -r name descriptor group more; do
    sed "s/&$descriptor,//" src/coupling/effects.c >"$work/effects.c"
    instrument "$work/effects.c" && link "$work/without" || exit
    without=$("$work/without" tests/free/bed.cfg 5)
    # shellcheck disable=SC2086
    on=$("$work/whole" tests/free/bed.cfg 5 "effects.$name=$group" $more)
    fact "off, $name costs nothing: $off, without its file $without" \
        "$([ -n "$off" ] && [ "$off" = "$without" ] && echo 1)"
    fact "the program without $name does not know it" \
        "$("$work/without" tests/free/bed.cfg 5 "effects.$name=$group" 2>&1 |
            grep -q "effects.$name" && echo 1)"
    fact "named, $name is seen by the count: $on" \
        "$(echo "$off $on" | awk '{ print ($4 >= $1 && $5 > $2) }')"
    echo "$name $without $on" | awk '{
        printf "%-16s %4d %6d %7d   %4d %6d %7d\n", $1, $2, $3, $4, $5, $6, $7 }'
done <<EOF
viscous_stress viscous_stress_effect {}
virtual_mass virtual_mass_effect {}
basset basset_effect {}
saffman saffman_effect {}
fluid_torque fluid_torque_effect {}
magnus magnus_effect {}
time_average time_average_effect {time=0.1;}
energy_budget energy_budget_effect {}
electrostatic cohesion_electrostatic {range=1e-3;} particles.grains.charge=1e-13
van_der_waals cohesion_van_der_waals {hamaker=1e-19;range=1e-5;}
capillary cohesion_capillary {tension=0.01;range=5e-5;}
whole_drag whole_drag_effect {}
stochastic_drag stochastic_drag_effect {sigma_low=0.1;sigma_high=0.1;time=0.01;}
lubrication lubrication_effect {roughness=1e-6;range=1e-4;}
particle_stress particle_stress_effect {pressure=1.0;} particles.list="none"
EOF
instrument src/coupling/effects.c || exit
# Contacts: without them none of the functions that compute them is entered.
alone='particles.list="none"'
none=$("$work/whole" tests/free/bed.cfg 5 "$alone")
all=$objects
objects=$(echo "$all" | tr ' ' '\n' | grep -v "/coupling.o\|/effects.o\|/transfer.o\|/reaction.o\|/dem.o")
link "$work/loops" || exit
loops=$("$work/loops" tests/free/bed.cfg 5 "$alone")
fact "without contacts their loops are not entered: $loops" \
    "$(echo "$loops" | awk '{ print ($1 > 0 && $2 == 0 && $3 == 0) }')"
objects=$all
fact "contacts on are seen by the count: $off" \
    "$(echo "$none $off" | awk '{ print ($4 > $1 && $6 > $3) }')"
echo "contacts $none $off" | awk '{
    printf "%-16s %4d %6d %7d   %4d %6d %7d\n", $1, $2, $3, $4, $5, $6, $7 }'
# The reaction of the particles on the fluid: one-way does as a program does that
# has something else in the place of its file.
one=$("$work/whole" tests/free/bed.cfg 5 'exchange.coupling="one-way"')
objects="$(echo "$objects" | tr ' ' '\n' | grep -v /reaction.o) $work/no_reaction.o"
$cc $flags -c -o "$work/no_reaction.o" tests/free/no_reaction.c || exit
link "$work/without" || exit
without=$("$work/without" tests/free/bed.cfg 5 'exchange.coupling="one-way"')
fact "one-way costs nothing of two-way: $one, without its file $without" \
    "$([ -n "$one" ] && [ "$one" = "$without" ] && echo 1)"
fact "a program without it has no two-way coupling" \
    "$("$work/without" tests/free/bed.cfg 5 >/dev/null 2>&1 || echo 1)"
fact "one-way runs less than two-way: $one" \
    "$(echo "$one $off" | awk '{ print ($1 <= $4 && $2 < $5 && $3 < $6) }')"
echo "two-way $without $off" | awk '{
    printf "%-16s %4d %6d %7d   %4d %6d %7d\n", $1, $2, $3, $4, $5, $6, $7 }'
echo "free: $facts passed, $failed failed"
[ $failed -eq 0 ]
