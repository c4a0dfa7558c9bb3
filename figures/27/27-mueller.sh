#!/bin/sh
# Mueller's bed with several bandwidths, velocities, seeds and meshes: means across it
# from 1 s on, and from later times on, so that the series can be cut into blocks.
#
#   sh figures/27/27-mueller.sh run NAME U SEED B CELLS END [-s ...]   into out/27-mueller
#   sh figures/27/27-mueller.sh vary                one choice after the other, on mesh B'
#   sh figures/27/27-mueller.sh forms               SX15's own equations, whole_drag, on mesh C
#   sh figures/27/27-mueller.sh parcels             with contacts and under a stress
#   sh figures/27/27-mueller.sh means [FOLDER]      drop, height, fluctuations and time of all
#   sh figures/27/27-mueller.sh collect [FOLDER]                       one table of all
#
# B is the bandwidth [m], CELLS are 18,50,4 for mesh C. A second of mesh C takes 57 s of a
# processor, of B' 36 s. An interrupted run leaves its means up to there; told again, it
# goes on, and a run that is done is not made again.
. "$(dirname "$0")/../here.sh"
out=out/27-mueller
froms="1 2 3 4 5 6 8 10 12 14 16"

run() { # NAME U SEED B CELLS END ...
    name=$1 U=$2 seed=$3 b=$4 cells=$5 end=$6
    shift 6
    ! grep -q '"exit_reason": "done"' "$out/$name/summary.json" 2>/dev/null || return 0
    asked="$name $U $seed $b $cells $*"
    [ ! -e "$out/$name/checkpoint" ] || set -- "$@" --resume
    lines=
    for from in $froms; do
        for height in 0.015 0.0164 0.025 0.0312 0.035; do
            for field in eps_s us_y; do
                lines="$lines{field=\"$field\";height=$height;from=$from.0;},"
            done
        done
    done
    winnow run "cases/${case:-mueller-bed}.cfg" --quiet -j 1 -o "$out/$name" \
        -s fluid.bottom.inlet="$U" -s particles.bed.seed="$seed" \
        -s averaging.bandwidth="$b" -s mesh.cells="[$cells]" -s output.end="$end" \
        -s output.every=0.05 -s output.history=0.001 \
        -s output.profiles="(${lines%,})" "$@" && code=0 || code=$?
    echo "$asked" >"$out/$name/asked"
    return "$code"
}

# What the experiment or SX15 leave open, one after the other, for 4 s each and with
# three seeds; and other seeds of the bed as it is, which tell what a difference must
# exceed to mean anything.
vary() {
    out=out/27-vary grains=particles.grains
    mkdir -p $out
    for seed in 1 2 3 4 5 6; do
        run seed-$seed 0.9 $seed 2.4e-3 12,32,3 4.0
    done
    for seed in 1 2 3; do
        while read -r name change; do
            [ $seed = 1 ] || name=$name+$seed
            # shellcheck disable=SC2086 # words
            run "$name" 0.9 $seed 2.4e-3 12,32,3 4.0 $change </dev/null
        done <<END
slip -s fluid.sides=slip
same -s averaging.interpolation=same
friction-0.3 -s $grains.friction=0.3
young-1.2e6 -s $grains.young=1.2e6 -s particles.step=1e-5
di-felice -s exchange.drag=di-felice
gidaspow -s exchange.drag=gidaspow
restitution-0.9 -s $grains.restitution=0.9
beetstra -s exchange.drag=beetstra
model-B -s exchange.model=B
fewer-8960 -s particles.bed.count=8960
one-deep -s mesh.cells=[12,32,1]
diameter-1.17 -s particles.bed.diameter=1.17e-3
whole -s effects={gravity=[0.0,-9.81,0.0];whole_drag={};}
END
    done
    run young-1.2e7 0.9 1 2.4e-3 12,32,3 4.0 -s $grains.young=1.2e7 -s particles.step=4e-6
}

# SX15's equations as printed, with the whole pressure gradient in that of the fluid and
# none on the grains, and the shared form with their b, beside C-0.9-1 with the case's b.
forms() {
    out=out/27-forms
    mkdir -p $out
    whole='effects={gravity=[0.0,-9.81,0.0];whole_drag={};}'
    run whole-2d 0.9 1 2.4e-3 18,50,4 "${1:-18.0}" -s "$whole"
    run whole-2d+2 0.9 2 2.4e-3 18,50,4 "${1:-18.0}" -s "$whole"
    run whole-4d 0.9 1 4.8e-3 18,50,4 "${1:-18.0}" -s "$whole"
    run shared-4d 0.9 1 4.8e-3 18,50,4 "${1:-18.0}"
    run whole-2d+3 0.9 3 2.4e-3 18,50,4 "${1:-18.0}" -s "$whole"
    run shared-2d+3 0.9 3 2.4e-3 18,50,4 "${1:-18.0}"
}

# Parcels of 8 and of 27, with cells and averages as wide as they ask for; three seeds.
parcels() {
    out=out/27-parcels of=particles.parcel.grains
    mkdir -p $out
    for seed in 1 2 3; do
        run contacts-8+$seed 0.9 $seed 4.8e-3 12,32,3 4.0 -s $of=8 -s particles.step=4e-5
        run contacts-27+$seed 0.9 $seed 7.2e-3 12,32,3 4.0 -s $of=27 -s particles.step=5e-5
        case=mueller-stress
        run stress-8+$seed 0.9 $seed 4.8e-3 9,25,2 4.0
        run stress-27+$seed 0.9 $seed 7.2e-3 6,16,1 4.0 -s $of=27
        [ $seed != 1 ] || run stress-1+1 0.9 1 4.8e-3 9,25,2 3.0 -s $of=1
        case=
    done
}

means() { # FOLDER: of the history, from 1 s on
    echo "# drop [Pa], mean height [mm], square of the fluctuations [m^2/s^2], processor [s] a second"
    for dir in "$1"/*/; do
        time=$(summary "$dir" processor) end=$(summary "$dir" simulated_seconds)
        columns "$dir/history.csv" time pressure_drop mean_height granular_temperature |
            awk -v name="$(basename "$dir")" -v each="$time/$end" '
                $1 >= 1 { n++; p += $2; y += $3; T += $4 }
                END { split(each, t, "/")
                      printf "%-14s %6.1f %6.2f %7.4f %6.1f\n", name, p / n, 1000 * y / n, T / n, t[1] / t[2] }'
    done
}

# run: name, U [m/s], seed, b [m], cells, what else; end [s]
# from: name, since [s], field, height [mm], x [m], mean since then
collect() { # FOLDER
    for dir in "$1"/*/; do
        name=$(basename "$dir")
        if [ ! -s "$dir/asked" ] || [ ! -d "$dir/profiles" ]; then continue; fi
        end=$(summary "$dir" simulated_seconds)
        echo "run $(cat "$dir/asked") end $end"
        for file in "$dir"/profiles/*.csv; do
            line=$(basename "$file" .csv) # us_y_y25mm or us_y_y25mm_from6s
            since=1
            case $line in *_from*) since=${line##*_from} since=${since%s} line=${line%_from*} ;; esac
            height=${line##*_y}
            awk -F, -v of="from $name $since ${line%_y*} ${height%mm}" \
                'NR > 1 && $2 != "nan" { printf "%s %.5f %.5f\n", of, $1, $2 }' "$file"
        done
    done
}

todo=$1
shift
mkdir -p $out
case $todo in
run) run "$@" ;;
vary) vary ;;
forms) forms "$@" ;;
parcels) parcels ;;
means) means "${1:-$out}" ;;
collect) collect "${1:-$out}" ;;
esac
