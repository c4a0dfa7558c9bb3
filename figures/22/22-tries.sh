#!/bin/sh
# Ten cases, and scenes of tests/tables/advice.txt: what `winnow check` estimates
# of each effect, what a short run measures, and what changes without it; last
# what another seed changes. ~: no more than that.
#
#   sh figures/22/22-tries.sh cases >figures/22/22-tries.txt
#   sh figures/22/22-tries.sh scenes >figures/22/22-tries-scenes.txt
. "$(dirname "$0")/../here.sh"
top=$PWD

tried() { # NAME SECONDS CASE...
    name=$1 seconds=$2
    shift 2
    winnow check "$@" --try "$seconds" -j 1 | awk -v name="$name" '
        NR < 4 || $1 == "to" || /other rounding|the drop,|the jet brings/ { next }
        { gsub(/\(other seed\)/, "(seed)"); printf "%-20s %-18s %8s %8s %8s %8s %6s %s\n",
              name, $1, $2, $3, $4, $5, $6, /within/ ? "~" : "" }' | sed 's/ *$//'
}

# The scenes of the table as functions, with what they stand in.
scenes() {
    awk '/^\$ few/ { exit } /^== / { on = $2 == "scenes"; next } !on { next }
        /^< / { print "cat >" $2 " <<\\END"; file = 1; next }
        file && /^[^ ]/ { print "END"; file = 0 }
        { sub(file ? "^    " : "^[$] ", ""); print }' "$top/tests/tables/advice.txt"
}

echo "# estimate and measured size [%]; change of speed and drop [%]; time [%]"
if [ "$1" = scenes ]; then
    cd "$work"
    eval "$(scenes)"
fi
while read -r set name seconds more; do
    # shellcheck disable=SC2086 # words
    case $1$set in
    casescases) tried "$name" "$seconds" "cases/$name.cfg" $more ;;
    scenesscenes) $name tried "$name" "$seconds" ;;
    esac
done <<END
cases settling-sphere 0.1
cases upflow-sphere 0.2
cases one-grain 0.0066 -s fluid.step=2.2e-5
cases rising-bead 0.03
cases carried-bead 0.1
cases closed-box 0.05
cases shear-grain 6.5
cases falling-cloud 0.1
cases settling-suspension 0.05
cases small-bed 0.1
scenes sand 0.05
scenes swung 0.025
scenes hollow 0.1
scenes powder 0.002
scenes two_sizes 0.02
scenes gas 0.05
scenes jet 0.1
scenes swirl 0.1
scenes swung_grain 0.08
scenes fine 0.004
scenes steel 0.05
scenes bubbles 0.15
scenes water_jet 0.1
scenes hopper 0.05
scenes spout 0.05
scenes slurry 0.01
scenes near_wall 0.1
scenes tilted 0.05
scenes thick 0.02
scenes blown 0.05
END
