#!/bin/sh
# The Mueller bed by pcm and by diffusion on the meshes A to E of SX15 fig. 4-7:
# time averages across the bed and along its height, from 1 s to END.
#
#   sh figures/26/26-mueller.sh run END [MESH...]   runs into out/26-mueller: hours
#   sh figures/26/26-mueller.sh collect             what is there, in one table
#
# A run that is there already, and was to END, is left as it is; one that was stopped goes on.
. "$(dirname "$0")/../here.sh"
out=out/26-mueller
meshes="A,6,16,1 B,9,25,2 B',12,32,3 C,18,50,4 D,36,100,8 E,72,200,16"

run() { # mesh cells method end
    dir=$out/$3-$(echo "$2" | tr , x)
    grep -qs "\"simulated_seconds\": $4,\$" "$dir/summary.json" && return
    cap=
    [ "$3" = pcm ] && cap="-s averaging.cap=0.7"
    [ ! -e "$dir/checkpoint" ] || cap="$cap --resume"
    # shellcheck disable=SC2086 # words or none
    winnow run cases/mueller-bed-sx15.cfg --quiet -o "$dir" -s mesh.cells="[$2]" \
        -s averaging.method="$3" $cap -s output.end="$4" -s output.every=0.5 >"$dir.log" 2>&1 ||
        echo "$1, $3: $(grep '^winnow' "$dir.log")" >&2
}

collect() { # mesh cells method
    dir=$out/$3-$(echo "$2" | tr , x)
    [ -s "$dir/summary.json" ] || return 0
    echo "run $1 $3 $(echo "$2" | tr , x) $(summary "$dir" simulated_seconds) $(summary "$dir" steps)" \
        "$(summary "$dir" steps_with_capped_cells) $(summary "$dir" eps_f_lowest)" \
        "$(summary "$dir" mean_pressure_drop)"
    for file in "$dir"/profiles/*.csv; do
        [ -e "$file" ] || continue
        line=$(basename "$file" .csv) # eps_f_y16.4mm, eps_f_along_y_x11mm
        case $line in
        *_along*) of="up $1 $3 ${line%_along*} ${line##*_x}" ;;
        *) of="at $1 $3 ${line%_y*} ${line##*_y}" ;;
        esac
        awk -F, -v of="${of%mm}" \
            'NR > 1 { printf "%s %.5f %.5f %.5f\n", of, $1, $2, $3 }' "$file"
    done
}

mkdir -p $out
todo=$1
end=${2:-5}
[ $# -lt 2 ] || shift
shift
echo '# run: mesh, method, cells, end [s], steps, of them with a capped cell,'
echo '#      lowest eps_f [-], mean pressure drop of the second half [Pa]'
echo '# at: mesh, method, field, height [mm], x [m], mean, standard deviation'
echo '# up: mesh, method, field, x [mm], height [m], mean, standard deviation'
for mesh in $meshes; do
    name=${mesh%%,*}
    case " ${*:-$name} " in *" $name "*) ;; *) continue ;; esac
    for method in diffusion pcm; do
        case $name$method in Dpcm | Epcm) continue ;; esac # figures/26/26-break.sh
        [ "$todo" = collect ] || run "$name" "${mesh#*,}" $method "$end"
        collect "$name" "${mesh#*,}" $method
    done
done
