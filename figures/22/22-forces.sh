#!/bin/sh
# The cases of the chapter on further forces with and without what they show.
#
#   22-forces.sh history|shear|spin|rebound|bead|turn|cloud|carry
#
# history: velocity of the bead over the terminal one against time over T = (2
# a^2/9 nu) (ratio + 1/2): without the force, with it, exact. shear: where the
# grain is, with and without lift. spin: the flights of the grain. rebound: speed
# after over before the impact, by Stokes number: without lubrication, with it,
# with history too. bead: velocity of the bead with all, without virtual mass,
# without the pressure gradient. turn: spin of the grain with the torque, without,
# exact. cloud: how fast it falls one-way, two-way and four-way. carry: by how much
# the bead is ahead of the oil, with pressure and stress, without the stress,
# without both.
. "$(dirname "$0")/../here.sh"
mkdir -p out
run() { # CASE NAME OVERRIDES...
    file=cases/$1.cfg to=out/22-$2
    shift 2
    winnow run "$file" -o "$to" --quiet "$@" >/dev/null
}
# Columns of the history of such a run.
of() { # NAME COLUMN...
    which=$1
    shift
    columns "out/22-$which/history.csv" "$@"
}

# v/v_t of Boussinesq, Basset and Oseen for a tenth of the density: E(z) =
# exp(z^2 t) erfc(-z sqrt(t)) = (2/sqrt(pi)) int exp(-s^2 + 2 z sqrt(t) s) ds.
exact='
function E(z, t,    i, s, sum) {
    sum = 1
    for (i = 1; i <= 1000; i++) {
        s = 0.008 * i
        sum += (i == 1000 ? 1 : i % 2 ? 4 : 2) * exp(-s * s + 2 * z * sqrt(t) * s)
    }
    return 2 / sqrt(3.141592653589793) * sum * 0.008 / 3
}
function exact(t,    B, p, q) {
    B = 3 / sqrt(1.2); p = (-B + sqrt(B * B - 4)) / 2; q = (-B - sqrt(B * B - 4)) / 2
    return 1 + (q * E(p, t) - p * E(q, t)) / (p - q)
}
BEGIN { v_t = 873 * 9.81 * 4e-6 / 18; T = 4e-6 / 18 * 970 * 0.6 }'

history() {
    run history-sphere history-with
    run history-sphere history-without \
        -s "effects={gravity=[0.0,-9.81,0.0];pressure_gradient={};virtual_mass={};}"
    of history-with time mean_fall_velocity >out/history-with.txt
    of history-without mean_fall_velocity >out/history-without.txt
    echo "# t/T; v/v_t without, with, exact [-]"
    paste -d' ' out/history-with.txt out/history-without.txt | awk "$exact"'
        NR % 5 == 1 { printf "%6.3f %8.5f %8.5f %8.5f\n",
            $1 / T, -$3 / v_t, -$2 / v_t, exact($1 / T) }'
}

# The momentum along x is that of the grain alone, from its release on.
shear() {
    echo "# t [s]; x [mm] with lift, without"
    for name in with without; do
        run shear-grain shear-$name -s output.history=0.002 $(
            [ $name = with ] ||
                echo "-s effects={gravity=[0.0,-9.81,0.0];pressure_gradient={};}"
        )
        of shear-$name time momentum_x | awk '
            BEGIN { m = 2650 * 3.141592653589793 / 6 * 8e-12; x = 1 }
            { if (t >= 6) x += 1e3 * $2 / m * ($1 - t)
              t = $1
              if (t >= 6 && NR % 10 == 1) printf "%.2f %.4f\n", t - 6, x }' \
            >out/shear-$name.txt
    done
    paste -d' ' out/shear-with.txt out/shear-without.txt | cut -d' ' -f1,2,4
}

spin() {
    echo "# x, y [mm] with Magnus and the torque; without the torque; with neither"
    for name in both magnus none; do
        case $name in
            both) more="magnus={};fluid_torque={};" ;;
            magnus) more="magnus={};" ;;
            none) more="" ;;
        esac
        run saltating-grain spin-$name -s "effects={gravity=[0.0,-9.81,0.0];pressure_gradient={};$more}"
        of spin-$name time momentum_x mean_height | awk '
            BEGIN { m = 2650 * 3.141592653589793 / 6 * 1.25e-10; x = 20 }
            { x += 1e3 * $2 / m * ($1 - t); t = $1
              printf "%.2f %.3f\n", x, 1e3 * $3 }' >out/spin-$name.txt
    done
    paste -d' ' out/spin-both.txt out/spin-magnus.txt out/spin-none.txt |
        awk 'NR % 4 == 1'
}

# The speeds with which the ball enters the gap of the effect, and leaves it, in
# several liquids; 0 where it does not leave it.
rebound() {
    echo "# St; rebound over impact: without, lubrication, and history [-]"
    for mu in 0.1 0.05 0.03 0.02 0.01 0.005 0.002 0.001; do
        for more in "" "lubrication={roughness=1e-6;range=7.5e-4;};" \
            "lubrication={roughness=1e-6;range=7.5e-4;};basset={};"; do
            run wet-rebound rebound -s fluid.viscosity=$mu -s fluid.step=2e-5 \
                -s output.history=2e-5 -s output.every=0.025 -s output.end=0.025 \
                -s "effects={gravity=[0.0,-9.81,0.0];pressure_gradient={};virtual_mass={};$more}"
            of rebound mean_height mean_fall_velocity |
                awk '$1 > 2.25e-3 && $2 > 0 && !up { down = $2 }
                     $1 > 2.25e-3 && $2 < 0 && !up { up = -$2 }
                     END { printf "%.4f %.3f\n", down, up / down }'
        done | awk -v mu=$mu '{ e[NR] = $2; u = $1 }
            NR == 1 { first = u }
            END { printf "%7.1f %6.3f %6.3f %6.3f\n",
                  7800 * first * 3e-3 / (9 * mu), e[1], e[2], e[3] }'
    done
}

bead() {
    echo "# t [ms]; velocity upwards [m/s] with both, without virtual mass, without buoyancy"
    g="gravity=[0.0,-9.81,0.0];"
    run rising-bead bead-both
    run rising-bead bead-light -s "effects={${g}pressure_gradient={};}"
    run rising-bead bead-heavy -s "effects={${g}virtual_mass={};}"
    of bead-both time mean_fall_velocity >out/bead-both.txt
    of bead-light mean_fall_velocity >out/bead-light.txt
    of bead-heavy mean_fall_velocity >out/bead-heavy.txt
    paste -d' ' out/bead-both.txt out/bead-light.txt out/bead-heavy.txt |
        awk 'NR % 6 == 1 { printf "%4.1f %8.5f %8.5f %8.5f\n", 1e3 * $1, -$2, -$3, -$4 }'
}

turn() {
    echo "# t [ms]; spin over that at the start with torque, without, exact"
    run spinning-grain turn-with
    run spinning-grain turn-without -s "effects={}"
    of turn-with time rotational_energy_particles >out/turn-with.txt
    of turn-without rotational_energy_particles >out/turn-without.txt
    paste -d' ' out/turn-with.txt out/turn-without.txt | awk '
        NR == 1 { first = $2 }
        NR % 4 == 1 { printf "%.1f %.6f %.6f %.6f\n", 1e3 * $1, sqrt($2 / first),
            sqrt($3 / first), exp(-60e-3 / (2650 * 4e-8) * $1) }'
}

cloud() {
    echo "# t [s]; velocity of the fall [mm/s] one-way, two-way, four-way"
    run falling-cloud cloud-1 -s 'particles.list="none"' -s 'exchange.coupling="one-way"'
    run falling-cloud cloud-2 -s 'particles.list="none"'
    run falling-cloud cloud-4
    of cloud-1 time mean_fall_velocity >out/cloud-1.txt
    of cloud-2 mean_fall_velocity >out/cloud-2.txt
    of cloud-4 mean_fall_velocity >out/cloud-4.txt
    paste -d' ' out/cloud-1.txt out/cloud-2.txt out/cloud-4.txt |
        awk 'NR % 5 == 1 { printf "%.2f %7.3f %7.3f %7.3f\n", $1, 1e3 * $2, 1e3 * $3, 1e3 * $4 }'
}

# Its velocity from its energy; that of the oil at its place from the probe.
carry() {
    echo "# t [s]; oil [mm/s]; bead ahead of it [um/s] with both, without stress, with neither"
    for name in both push none; do
        case $name in
            both) effects="pressure_gradient={};viscous_stress={};" ;;
            push) effects="pressure_gradient={};" ;;
            none) effects="" ;;
        esac
        run carried-bead carry-$name -s "effects={$effects}" -s output.every=0.01
        of carry-$name time kinetic_energy_particles >out/carry-e.txt
        tail -n +2 out/22-carry-$name/probes.csv | cut -d, -f2 |
            paste -d' ' out/carry-e.txt - | awk '
                { printf "%.2f %.4f %.3f\n", $1, 1e3 * $3,
                  1e6 * (sqrt(2 * $2 / (1000 * 3.141592653589793 / 6 * 8e-9)) - $3) }' \
            >out/carry-$name.txt
    done
    paste -d' ' out/carry-both.txt out/carry-push.txt out/carry-none.txt |
        awk 'NR % 5 == 1 { print $1, $2, $3, $6, $9 }'
}

$1
