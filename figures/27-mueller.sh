#!/bin/sh
# Mueller's bed with several bandwidths, velocities, seeds and meshes: means across it
# from 1 s on, and from later times on, so that the series can be cut into blocks.
#
#   sh figures/27-mueller.sh run NAME U SEED B CELLS END [-s ...]   into out/27-mueller
#   sh figures/27-mueller.sh collect [FOLDER]                       one table of all
#
# B is the bandwidth [m], CELLS are 18,50,4 for mesh C. On one quiet core a second of
# mesh C takes two minutes. An interrupted run leaves its means up to there.
set -eu
out=out/27-mueller
froms="1 2 3 4 5 6 8 10 12 14 16"

run() { # NAME U SEED B CELLS END ...
    name=$1 U=$2 seed=$3 b=$4 cells=$5 end=$6
    shift 6
    lines=
    for from in $froms; do
        for height in 0.015 0.0164 0.025 0.0312 0.035; do
            for field in eps_s us_y; do
                lines="$lines{field=\"$field\";height=$height;from=$from.0;},"
            done
        done
    done
    winnow run cases/mueller-bed.cfg --quiet -j 1 -o "$out/$name" \
        -s fluid.bottom.inlet="$U" -s particles.bed.seed="$seed" \
        -s averaging.bandwidth="$b" -s mesh.cells="[$cells]" -s output.end="$end" \
        -s output.every=0.05 -s output.history=0.001 \
        -s output.profiles="(${lines%,})" "$@" && code=0 || code=$?
    echo "$name $U $seed $b $cells" "$@" >"$out/$name/asked"
    return "$code"
}

# run: name, U [m/s], seed, b [m], cells, what else; end [s]
# from: name, since [s], field, height [mm], x [m], mean since then
collect() { # FOLDER
    for dir in "$1"/*/; do
        name=$(basename "$dir")
        if [ ! -s "$dir/asked" ] || [ ! -d "$dir/profiles" ]; then continue; fi
        end=$(sed -n 's/.*"simulated_seconds": \([0-9.]*\).*/\1/p' "$dir/summary.json")
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
collect) collect "${1:-$out}" ;;
esac
