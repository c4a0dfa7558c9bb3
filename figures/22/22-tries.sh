#!/bin/sh
# Ten scenes: what `winnow check` estimates of each effect, what a short run
# measures, and what changes without it.
#
#   sh figures/22/22-tries.sh >figures/22/22-tries.txt
. "$(dirname "$0")/../here.sh"
echo "# case, effect: estimate and measured size [%]; change of speed and drop [%]; time [%]"
while read -r name seconds more; do
    # shellcheck disable=SC2086 # words
    winnow check "cases/$name.cfg" $more --try "$seconds" -j 1 |
        awk -v name="$name" 'NR > 3 && $1 != "(chance)" && $1 != "to" { $1 = sprintf("%-18s", $1)
            printf "%-20s %s %8s %8s %8s %8s %6s\n", name, $1, $2, $3, $4, $5, $6 }'
done <<END
settling-sphere 0.1
upflow-sphere 0.2
one-grain 0.0066 -s fluid.step=2.2e-5
rising-bead 0.03
carried-bead 0.1
closed-box 0.05
shear-grain 6.5
falling-cloud 0.1
settling-suspension 0.05
small-bed 0.1
END
