#!/bin/sh
# Reports of every kind of run in a browser, as wide as a phone and as a desk: no error is
# told, nothing is wider than the window, the scene and the slice have colours, and the
# numbers shown are those of the files. Left out with a word where there is no Chromium.
#
#   sh tests/report.sh build        (part of check-slow)
set -u
build=$(cd "$1" && pwd)
top=$PWD
. chapters/tools/chromium.inc
[ -n "$browser" ] || { echo "reports in a browser: no Chromium"; exit 0; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
kinds="small-bed grains bodies dual"
for kind in $kinds; do
    end=
    file=$top/tests/data/vtk/$kind.cfg
    [ $kind != small-bed ] || { end='-s output.end=0.05' && file=$top/cases/$kind.cfg; }
    # shellcheck disable=SC2086
    { "$build/winnow" run "$file" -o $kind --quiet $end && "$build/winnow" report $kind; } >said 2>&1 ||
        { echo "FAILED $kind:" && cat said && exit 1; }
done
"$build/winnow" report small-bed grains >said && cp small-bed/report.html two.html && "$build/winnow" report small-bed >said
# As a build without the libraries makes it.
awk '/^<\/script>$/ { closed++ } !(open > closed && open < 3) { print } /^<script>$/ { open++ }' small-bed/report.html >bare.html
opened "$work" 120000 "file://$top/tests/pages/report.html#$work $kinds two bare" \
    --use-gl=angle --use-angle=swiftshader --enable-unsafe-swiftshader --ignore-gpu-blocklist >said
facts=0
failed=0
wrong() { failed=$((failed + 1)) && echo "FAILED $*"; }
fact() { # NAME COMMAND...
    name=$1
    shift
    if "$@"; then facts=$((facts + 1)) && echo "    $name"; else wrong "$name"; fi
}
nothing() { ! grep "$@"; }
fact "the browser comes to the end" grep -q '^@ all' said
fact "no page tells an error" nothing '^@ [a-z]* ERROR' said
fact "the console is silent" nothing -i 'CONSOLE' log
fact "texts of a stranger stay texts" grep -q '^@ grains title grains </pre><script>' said
fact "without libraries a page says what is missing" test "$(grep -c '^@ bare NOTE.*libjs-\(three\|dygraphs\)' said)" = 4
fact "and has its slice" grep -q '^@ bare slice' said
for kind in $kinds; do
    # Five digits are shown, so half of the fifth may differ. inf is no number of JSON.
    awk -v kind=$kind 'FILENAME == "said" { if ($1 == "@" && $2 == kind && $3 == "number") shown[$4] = $5; next }
        /^  "[a-z_]*": *{/ { group = $1 == "\"worst\":" }
        group && /^    "/ { gsub(/[":,]/, ""); n++; d = shown[$1] - $2; d = d < 0 ? -d : d
                            if (!($1 in shown) || d > 5.1e-5 * ($2 < 0 ? -$2 : $2)) { print $1, shown[$1], $2; bad = 1 } }
        END { exit bad || !n }' said $kind/summary.json
    fact "$kind: the numbers are those of its summary" test $? = 0
    columns=$(head -n 1 $kind/history.csv | tr ',' '\n' | wc -l)
    fact "$kind: every column has a plot" grep -q "^@ $kind columns $((columns - 1)) $((2 * columns - 2))\$" said
    if grep -q "^@ $kind NOTE .*WebGL" said; then
        echo "    $kind: no scene, for this browser has no WebGL"
    elif [ $kind != dual ]; then
        fact "$kind: the scene has colours" awk -v k=$kind '$2 == k && $3 == "scene" { n += $5 > 20 } END { exit n != 2 }' said
    fi
    [ $kind = grains ] ||
        fact "$kind: the slice has colours" awk -v k=$kind '$2 == k && $3 == "slice" { n += $5 > 3 } END { exit n != 2 }' said
done
echo "reports in a browser: $facts passed, $failed failed"
[ $failed -eq 0 ]
