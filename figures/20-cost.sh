#!/bin/sh
# What accuracy costs for the grain of cases/one-grain.cfg: its error after 1.1 ms,
# over the speed of the water, against the drag evaluations in that time.
set -eu
velocity() { # OVERRIDES...: after 1.1 ms
    winnow run cases/one-grain.cfg -o out/grain-cost --quiet -s output.end=1.1e-3 \
        "$@" >/dev/null
    tail -n 1 out/grain-cost/probes.csv | cut -d, -f2
}
step() { awk "BEGIN { printf \"%.9g\", $1 }"; }
mkdir -p out
exact=$(velocity -s exchange.slip_integration=exponential -s fluid.step=2.2e-6 \
    -s particles.step=2.2e-6)
error() { awk "BEGIN { e = ($1 - $exact) / 0.05; printf \" %9.2e\", e < 0 ? -e : e }"; }
echo "# evaluations, error with sub-steps, with exponential sub-steps, with steps"
echo "# of the fluid, exponential [-]"
for n in 1 2 4 8 16 32; do
    printf '%2d' $n
    fine=$(step "1.1e-3 / 32")
    error "$(velocity -s particles.step="$fine" -s exchange.substeps=$n)"
    error "$(velocity -s particles.step="$fine" -s exchange.substeps=$n \
        -s exchange.slip_integration=exponential)"
    error "$(velocity -s particles.step="$fine" -s exchange.substeps=1 \
        -s fluid.step="$(step "1.1e-3 / $n")" -s exchange.slip_integration=exponential)"
    echo
done
