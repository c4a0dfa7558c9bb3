#!/bin/sh
# Long runs of beds beside their measurements: Mueller's at 0.9 m/s (two seeds,
# 18 s) and at 0.6 m/s, van Wachem's (12 s), Goldschmidt's (10 s), the spouted bed
# (4 s). Hours each on one core. A run that was interrupted goes on where it was.
#
#   sh tests/validate/beds.sh build/winnow [mueller|six|wachem|goldschmidt|spouted ...]
set -eu
PATH=$(cd "$(dirname "$1")" && pwd):$PATH
shift
[ $# -gt 0 ] || set -- mueller six wachem goldschmidt spouted

# NAME CASE: a case as it stands, in out/27-NAME.
whole() {
    go=
    [ -e "out/27-$1/checkpoint" ] && go=--resume
    # shellcheck disable=SC2086 # one word or none
    winnow run "$2" -o "out/27-$1" --quiet $go >/dev/null
}

for part; do
    case $part in
    mueller)
        sh figures/27/27-mueller.sh run C-0.9-1 0.9 1 2.4e-3 18,50,4 18.0
        sh figures/27/27-mueller.sh run C-0.9-2 0.9 2 2.4e-3 18,50,4 18.0
        sh figures/27/27-mueller.sh run Bp-0.9-1 0.9 1 2.4e-3 12,32,3 18.0
        { echo "# Made by sh tests/validate/beds.sh build/winnow mueller"
          sh figures/27/27-mueller.sh collect; } >out/27-table
        mv out/27-table figures/27/27-mueller.txt
        gnuplot figures/27/27-mueller.gp
        python3 figures/27/27-compare.py distance figures/27/27-mueller.txt
        ;;
    six)
        mkdir -p out/27-mueller-06
        sh figures/27/27-mueller.sh run C-0.6-1 0.6 1 2.4e-3 18,50,4 18.0
        mv out/27-mueller/C-0.6-1 out/27-mueller-06
        { echo "# Made by sh tests/validate/beds.sh build/winnow six"
          sh figures/27/27-mueller.sh collect out/27-mueller-06; } >figures/27/27-mueller-06.txt
        python3 figures/27/27-compare.py profile figures/27/27-mueller-06.txt
        ;;
    wachem)
        whole wachem cases/van-wachem-bed.cfg
        python3 figures/27/27-pulse.py out/27-wachem/probes.csv 1 2
        ;;
    goldschmidt)
        whole goldschmidt cases/goldschmidt-bed.cfg
        sh chapters/tools/last.sh out/27-goldschmidt mean_height
        ;;
    spouted)
        whole spouted cases/spouted-bed.cfg
        sh figures/27/27-spouted.sh out/27-spouted >figures/27/27-spouted.txt
        gnuplot figures/27/27-spouted.gp
        python3 figures/27/27-spouted.py figures/27/27-spouted.txt
        ;;
    esac
done
