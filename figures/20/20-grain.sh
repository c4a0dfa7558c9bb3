#!/bin/sh
# cases/one-grain.cfg with several treatments, side by side: the velocity of the
# grain after each step of the fluid. "exact": steps 50 times as short; with the
# word exact, all of these; with the word euler, XS11 Fig. 8a: forward Euler, which the
# explicit treatment without sub-steps is, with four steps.
. "$(dirname "$0")/../here.sh"
run() { # NAME OVERRIDES...
    name=$1
    shift
    winnow run cases/one-grain.cfg -o "out/grain-$name" --quiet "$@" >/dev/null
    sed 1d "out/grain-$name/probes.csv" | cut -d, -f2 >"out/grain-$name.txt"
}
mkdir -p out
if [ "${1:-}" = exact ]; then
    run fine -s exchange.slip_integration=exponential -s fluid.step=2.2e-5
    awk '{printf "%.6f %.5f\n", 2.2e-5 * (NR - 1), $1}' out/grain-fine.txt |
        awk 'NR % 5 == 1'
    exit
fi
if [ "${1:-}" = euler ]; then
    echo "# step [ms], velocity after 0, 1, ... 6 steps [m/s]"
    for step in 2.5e-4 5e-4 7.5e-4 1.1e-3; do
        run euler -s exchange.treatment=explicit -s fluid.step=$step -s particles.step=2.5e-5
        awk -v dt=$step 'BEGIN { printf "%.2f", 1e3 * dt }
            NR < 8 { printf " %8.5f", $1 }
            END { print "" }' out/grain-euler.txt
    done
    exit
fi
run 1 -s exchange.substeps=1
run 2 -s exchange.substeps=2
run 50 -s exchange.substeps=50
run relaxed -s exchange.slip_integration=exponential
run fine -s exchange.slip_integration=exponential -s fluid.step=2.2e-5
awk 'NR % 50 == 1' out/grain-fine.txt >out/grain-exact.txt
echo "# t [s], N_s = 1, 2, 50, exponential, exact [m/s]"
paste -d' ' out/grain-1.txt out/grain-2.txt out/grain-50.txt \
    out/grain-relaxed.txt out/grain-exact.txt |
    awk '{printf "%.4f %9.5f %8.5f %8.5f %8.5f %8.5f\n",
          1.1e-3 * (NR - 1), $1, $2, $3, $4, $5}'
