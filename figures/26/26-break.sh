#!/bin/sh
# How PCM ends on fine meshes: the first 0.01 s, 50 steps, of the Mueller bed on
# the meshes C to E of SX15, without a cap and with one; and by diffusion.
. "$(dirname "$0")/../here.sh"
out=out/26-break
mkdir -p $out
echo "# mesh, method, last time [s], steps with a capped cell, lowest eps_f [-],"
echo "# mean pressure drop of the second half [Pa]; the bed weighs 186.4 Pa"
for mesh in C,18,50,4 D,36,100,8 E,72,200,16; do
    for how in pcm pcm,0.7 diffusion; do
        dir=$out/${mesh%%,*}-$how
        cap=
        [ "${how#*,}" = "$how" ] || cap="-s averaging.cap=${how#*,}"
        # shellcheck disable=SC2086 # two words or none
        winnow run cases/mueller-bed-sx15.cfg --quiet -o "$dir" -s output.end=0.01 \
            -s mesh.cells="[${mesh#*,}]" -s averaging.method="${how%,*}" $cap \
            >"$dir.log" 2>&1 || true
        echo "${mesh%%,*} $how $(summary "$dir" simulated_seconds)" \
            "$(summary "$dir" steps_with_capped_cells) $(summary "$dir" eps_f_lowest)" \
            "$(summary "$dir" mean_pressure_drop)" |
            awk '{ printf "%s %-9s %5.4g %3d  %5.3f  %5.1f\n", $1, $2, $3, $4, $5, $6 }'
        sed -n 's/^winnow: \(.*\) at t = .*/    \1/p' "$dir.log"
    done
done
