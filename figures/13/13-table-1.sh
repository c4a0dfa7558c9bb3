#!/bin/sh
# XS11 Table 1 recomputed with two sets of properties. Columns: U [m/s], eps_s,
# d [mm], printed [s]; tau_p [s] and tau_p over printed, first with the 2000
# kg/m^3 and the air that XS11 name elsewhere, then with quartz and round air.
. "$(dirname "$0")/../here.sh"
tau() { winnow eval XS11:3.17 "$@" | awk '{ print $3 }'; }

echo "# fluid U eps_s d_mm printed sand ratio quartz ratio"
while read -r fluid U eps_s d printed; do
    case $fluid in
    water) named="rho_f=1000 mu=1e-3" round="rho_f=1000 mu=1e-3" ;;
    air) named="rho_f=1.2 mu=1.8e-5" round="rho_f=1.0 mu=1e-5" ;;
    esac
    a=$(tau rho_s=2000 eps_s=$eps_s $named d=${d}e-3 u_r=$U)
    b=$(tau rho_s=2650 eps_s=$eps_s $round d=${d}e-3 u_r=$U)
    awk "BEGIN { printf \"%-5s %d %.1f %-3s %8.2g %9.3g %5.2f %9.3g %5.2f\n\",
        \"$fluid\", $U, $eps_s, $d, $printed,
        $a, $a / $printed, $b, $b / $printed }"
done <<EOF | awk '
    { print; sand += off($7); quartz += off($9) }
    function off(r) { return r < 1 ? 1 - r : r - 1 }
    END { printf "mean_miss_sand = %.3f\nmean_miss_quartz = %.3f\n",
              sand / NR, quartz / NR }'
water 3 0.2 0.1 7.0e-5
water 3 0.2 1 1.0e-3
water 3 0.6 0.1 3.0e-5
water 3 0.6 1 4.0e-4
water 1 0.2 0.1 1.5e-4
water 1 0.2 1 3.0e-3
water 1 0.6 0.1 6.7e-5
water 1 0.6 1 1.0e-3
air 3 0.2 0.1 3.0e-2
air 3 0.2 1 0.72
air 3 0.6 0.1 1.3e-2
air 3 0.6 1 0.29
air 1 0.2 0.1 3.9e-2
air 1 0.2 1 1.5
air 1 0.6 0.1 1.9e-2
air 1 0.6 1 0.66
EOF
