#!/bin/sh
# Reports of every kind of run in a browser, as wide as a phone and as a desk: no error is
# told, nothing is wider than the window, the scene and the slice have colours, and the
# numbers shown are those of the files. Left out with a word where there is no Chromium.
#
#   sh tests/report.sh build        (part of check-slow)
set -u
build=$(cd "$1" && pwd)
top=$PWD
browser=
for name in chromium chromium-browser google-chrome; do
    command -v $name >/dev/null && browser=$name && break
done
[ -n "$browser" ] || { echo "reports in a browser: no Chromium"; exit 0; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
cat >grains.cfg <<'END'
title = "grains </pre><script>console.error('a script of a stranger')</script>";
mesh = { size = [0.02, 0.01, 0.04]; cells = [1, 1, 1]; };
particles = { contact = "linear"; step = 1e-5;
    grains = { density = 1000; stiffness = 100; restitution = 0.9; friction = 0.1; };
    bed = { count = 200; diameter = 1e-3; }; };
effects = { gravity = [0.0, 0.0, -9.81]; };
output = { end = 0.01; every = 0.005; };
END
cat >bodies.cfg <<'END'
mesh = { size = [0.02, 0.04, 0.02]; cells = [8, 16, 8]; };
fluid = { density = 1000; viscosity = 0.1; step = 1e-3; bottom = "no-slip"; top = "no-slip";
          left = "no-slip"; right = "no-slip"; front_back = "no-slip"; };
bodies = { stiffness = 1000; spheres = ( { position = [0.01, 0.03, 0.01]; diameter = 0.008; density = 2000; } ); };
effects = { gravity = [0.0, -9.81, 0.0]; };
output = { end = 0.01; every = 0.005; };
END
cat >poly.cfg <<END
mesh = { polymesh = "$top/tests/data/poly/dual"; };
fluid = { density = 1.2; viscosity = 0.1; step = 0.01; bottom = { inlet = 0.2; };
          top = { outlet = 0.0; }; left = "no-slip"; right = "no-slip"; front = "slip"; back = "slip"; };
output = { end = 0.05; every = 0.05; };
END
cp "$top/cases/small-bed.cfg" bed.cfg
kinds="bed grains bodies poly"
for kind in $kinds; do
    end=
    [ $kind != bed ] || end='-s output.end=0.05'
    # shellcheck disable=SC2086
    { "$build/winnow" run $kind.cfg -o $kind --quiet $end && "$build/winnow" report $kind; } >said 2>&1 ||
        { echo "FAILED $kind:" && cat said && exit 1; }
done
"$build/winnow" report bed grains >said && cp bed/report.html two.html && "$build/winnow" report bed >said
# As a build without the libraries makes it.
awk '/^<\/script>$/ { closed++ } !(open > closed && open < 3) { print } /^<script>$/ { open++ }' bed/report.html >bare.html
cat >look.html <<'PAGE'
<!DOCTYPE html>
<style>iframe { border: 0; height: 800px; }</style><iframe></iframe><pre></pre>
<script>
const frame = document.querySelector('iframe'), out = document.querySelector('pre');
const wait = ms => new Promise(done => setTimeout(done, ms));
function colours(canvas) {
  const copy = document.createElement('canvas');
  copy.width = canvas.width; copy.height = canvas.height;
  const pen = copy.getContext('2d');
  pen.drawImage(canvas, 0, 0);
  return new Set(new Uint32Array(pen.getImageData(0, 0, copy.width, copy.height).data.buffer)).size;
}
async function look(kind, page, width) {
  const say = (...words) => out.append(['@', kind, ...words].join(' ') + '\n');
  frame.style.width = width + 'px';
  frame.src = page;
  await new Promise(done => frame.onload = done);
  frame.contentWindow.addEventListener('error', e => say('ERROR', e.message));
  const doc = frame.contentDocument, all = q => [...doc.querySelectorAll(q)];
  if (doc.documentElement.scrollWidth > width + 1) say('ERROR wider than ' + width);
  for (const id of ['scene', 'slice'])
    for (const canvas of all('#' + id + ' canvas:not(.bar)')) say(id, width, colours(canvas));
  const clock = () => doc.querySelector('output').textContent, before = clock();
  all('button')[1].click();
  if (clock() === before) say('ERROR a step back in time changes nothing');
  all('button')[0].click();
  await wait(500);
  all('button')[0].click();
  for (const box of all('select'))
    for (const o of box.options) { box.value = o.value; box.dispatchEvent(new Event('change')); }
  for (const note of all('#scene p, p.note')) say('NOTE', note.textContent);
  if (width < 1000) return;
  say('columns', all('figure').length, all('figure .plot canvas').length);
  for (const cell of all('td.number')) say('number', cell.dataset.key, cell.textContent);
  say('title', doc.querySelector('h1').textContent);
}
(async () => {
PAGE
for kind in $kinds; do
    echo "await look('$kind', '$kind/report.html', 390); await look('$kind', '$kind/report.html', 1280);"
done >>look.html
echo "await look('two', 'two.html', 390); await look('two', 'two.html', 1280);
await look('bare', 'bare.html', 390); await look('bare', 'bare.html', 1280); out.append('@ all'); })();</script>" >>look.html
timeout 300 "$browser" --headless --no-sandbox --disable-quic --no-first-run --hide-scrollbars \
    --use-gl=angle --use-angle=swiftshader --enable-unsafe-swiftshader --ignore-gpu-blocklist \
    --disable-background-networking --disable-component-update --disable-sync \
    --user-data-dir="$work/profile" --allow-file-access-from-files --enable-logging=stderr \
    --virtual-time-budget=120000 --dump-dom "file://$work/look.html" 2>log |
    sed -n 's/^.*<pre>@/@/; s/&gt;/>/g; s/&lt;/</g; s/&amp;/\&/g; s/^\(@ all\).*/\1/; /^@/p' >said
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
    elif [ $kind != poly ]; then
        fact "$kind: the scene has colours" awk -v k=$kind '$2 == k && $3 == "scene" { n += $5 > 20 } END { exit n != 2 }' said
    fi
    [ $kind = grains ] ||
        fact "$kind: the slice has colours" awk -v k=$kind '$2 == k && $3 == "slice" { n += $5 > 3 } END { exit n != 2 }' said
done
echo "reports in a browser: $facts passed, $failed failed"
[ $failed -eq 0 ]
