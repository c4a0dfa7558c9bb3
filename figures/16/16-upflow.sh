#!/bin/sh
# cases/upflow-sphere.cfg beside the reference of MFiX's case DEM06: time [s],
# velocity [m/s], the reference's, and the largest difference over the end
# velocity.
. "$(dirname "$0")/../here.sh"
winnow run cases/upflow-sphere.cfg -o out/upflow --quiet >/dev/null 2>&1
awk -F, '
FNR == 1 { file++ }
/^#/ || /^t_s/ { next }
file == 1 { if ($1 != "") { t[++n] = $1; v[n] = $2 }; next }
FNR == 1 { for (i = 1; i <= NF; i++) if ($i ~ /^mean_fall_velocity/) c = i; next }
{ for (; k < n && t[k + 1] < $1 + 1e-9; ) {
      k++
      if (t[k] > $1 - 1e-9) {
          d = -$c - v[k]; d = d < 0 ? -d : d; if (d > most) most = d
          printf "%.2f %.8f %.8f\n", t[k], -$c, v[k]
      }
  } }
END { printf "largest_difference = %.2e\n", most / 0.0573925 }
' figures/data/mfix_dem06_velocity.csv out/upflow/history.csv
