#!/bin/sh
# Cohesion over weight of two equal grains of quartz that touch, against their
# diameter. Columns: d [m], van der Waals, capillary, electrostatic at the
# largest charge that air lets a surface keep, 26 uC/m^2.
. "$(dirname "$0")/../here.sh"
value() {
    winnow eval "$@" | awk '{ print $3 < 0 ? -$3 : $3 }'
}
echo "# d [m]  van der Waals  capillary  electrostatic"
for d in 1e-6 1e-5 1e-4 1e-3 1e-2; do
    R=$(awk "BEGIN { print $d / 2 }")
    q=$(awk "BEGIN { print 26e-6 * atan2(0, -1) * $d * $d }")
    echo "$d $(value LS:4.14 A=6.5e-20 D_i=$d D_j=$d l=4e-10)" \
        "$(value LS:4.15 gamma=0.072 theta=0 R_i=$R R_j=$R)" \
        "$(value LS:4.13 q_i=$q q_j=-$q eps_r=1 l=$d)"
done | awk '{ w = 2650 * atan2(0, -1) / 6 * $1 ^ 3 * 9.81
    printf "%s %.3g %.3g %.3g\n", $1, $2 / w, $3 / w, $4 / w }'
