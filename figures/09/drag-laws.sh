#!/bin/sh
# The resistance of both laws, over Stokes' 18 mu / d^2, against the fluid
# fraction, at Re = 1 and Re = 100: grains of 1.2 mm in air.
. "$(dirname "$0")/../here.sh"
rho_f=1.2 mu=1.8e-5 d=1.2e-3

value() { winnow eval "$@" rho_f=$rho_f mu=$mu d=$d | awk '{ print $3 }'; }

echo "# eps_f, syamlal-obrien at Re 1, gidaspow at Re 1, the same at Re 100"
for eps_f in 0.36 0.40 0.45 0.50 0.55 0.60 0.65 0.70 0.75 0.80 0.8001 0.84 \
    0.85 0.8501 0.90 0.95 0.999; do
    eps_s=$(awk "BEGIN { print 1 - $eps_f }")
    for u_r in 0.0125 1.25; do # Re = 80 u_r
        value XS11:2.11 eps_s="$eps_s" u_r=$u_r
        value LS:5.27 alpha=$eps_f u_r=$u_r
    done | awk -v e=$eps_f -v s="$eps_s" -v stokes="$(awk \
        "BEGIN { print 18 * $mu / $d / $d }")" '
        { row = row sprintf(" %.5g", $1 / s / stokes) }
        END { print e row }'
done
