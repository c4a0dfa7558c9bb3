#!/bin/sh
# The rebound of cases/rebound.cfg against the number of steps in the contact.
# Columns: steps; largest miss of the speed that comes back, over eight phases of
# the step in which the sphere touches, for e = 1 and for e = 0.7.
. "$(dirname "$0")/../here.sh"
# pi sqrt(m / k) for the sphere and the wall; the dashpot adds 1 % to it
t_c=$(awk 'BEGIN { pi = atan2(0, -1)
    print pi * sqrt(2000 * pi / 6 * 1.5e-3 ^ 3 / 5000) }')

miss() { # e, steps
    step=$(awk "BEGIN { print $t_c / $2 }")
    for phase in 0 1 2 3 4 5 6 7; do
        y=$(awk "BEGIN { printf \"%.12g\", 0.001 + $phase / 8 * $step }")
        winnow run cases/rebound.cfg -s particles.step=$step -o out/rebound \
            -s particles.unsafe_step=true \
            -s particles.grains.restitution=$1 --quiet \
            -s "particles.place.0.position=[0.005,$y,0.005]" >/dev/null 2>&1
        sh chapters/tools/last.sh out/rebound kinetic_energy_particles
    done | awk -v e=$1 '
        { kept = sqrt($3 / 1.767145868e-6); off = kept > e ? kept - e : e - kept
          if (off > most) most = off }
        END { if (NR != 8) exit 1; printf "%.2e", most }'
}

echo "# steps   e = 1     e = 0.7"
for steps in 2 4 8 15 25 50 100 200; do
    echo "$steps $(miss 1.0 $steps) $(miss 0.7 $steps)" |
        awk '{ printf "%7d %9s %9s\n", $1, $2, $3 }'
done
