#!/bin/sh
# The energy of cases/open-heap.cfg, every 20 ms: how many grains there are,
# came and went; then what has come and where it has gone, all in uJ.
. "$(dirname "$0")/../here.sh"
winnow run cases/open-heap.cfg -o out/open-heap -j 1 --quiet >/dev/null 2>&1
awk -F, '
    NR == 1 { for (i = 1; i <= NF; i++) { split($i, w, " "); at[w[1]] = i }; next }
    function of(name) { return $at[name] }
    (NR - 2) % 20 == 0 {
        kinetic = of("kinetic_energy_particles") + of("rotational_energy_particles")
        springs = of("energy_normal_springs") + of("energy_tangential_springs")
        come = of("work_of_outside_forces") + of("energy_brought")
        printf "%.2f %d %d %d %.1f %.1f %.1f %.1f %.1f %.1f %.1f %.1f\n",
            of("time"), of("particles"), of("particles_in"), of("particles_out"),
            1e6 * come, 1e6 * kinetic, 1e6 * springs,
            1e6 * of("lost_in_normal_dashpots"),
            1e6 * of("lost_in_tangential_dashpots"),
            1e6 * (of("lost_by_sliding") + of("lost_by_tangential_springs")),
            1e6 * of("lost_by_rolling"), 1e6 * of("energy_residual")
        last = $0
    }
    END {
        print "## end"
        printf "came = %d\nwent = %d\n", of("particles_in"), of("particles_out")
        printf "come = %.0f uJ\n", 1e6 * (of("work_of_outside_forces") + of("energy_brought"))
        printf "normal = %.0f uJ\n", 1e6 * of("lost_in_normal_dashpots")
        printf "sliding = %.0f uJ\n", 1e6 * of("lost_by_sliding")
        printf "rolling = %.0f uJ\n", 1e6 * of("lost_by_rolling")
        printf "residual = %.1f %%\n", 100 * of("energy_residual") / (of("work_of_outside_forces") + of("energy_brought"))
    }' out/open-heap/history.csv
