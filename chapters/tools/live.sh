#!/bin/sh
# Puts a step of the course into its page: the program itself, which runs there,
# at the heading "Run it here", and its listing at "The program". Where the
# compiler for WebAssembly is missing, the page has the picture instead.
#
#   sh chapters/tools/live.sh build/book/step-01-bounce.html anchors.txt [plain]
#
# A plain page has the listing only, and nothing is run.
set -eu
page=$1 anchors=$2 plain=${3:-}
tools=$(cd "$(dirname "$0")" && pwd)
name=$(basename "$page" .html)
name=${name#step-}
program=chapters/steps/$name.c
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

escaped() { sed 's/&/\&amp;/g; s/</\&lt;/g; s/>/\&gt;/g' "$@"; }

# shellcheck disable=SC2046 # one word a file
awk -v anchors="$anchors" -f "$tools/colour.awk" -f "$tools/steps.awk" \
    $(find chapters/steps -name '[0-9]*.c' | LC_ALL=C sort | awk -v last="$program" '$0 <= last') >"$work/listing"
: >"$work/live"
if [ -z "$plain" ]; then
    ${CC:-cc} -std=c11 -O2 -ffp-contract=off -o "$work/$name" "$program" -lm
    "$work/$name" >"$work/printed"
    cp "$work/$name.svg" "$(dirname "$page")/figures/$name.svg"
    picture="<p><img src=\"figures/$name.svg\" alt=\"What $name draws\" /></p>
<pre>$(escaped "$work/printed")</pre>"
    if clang --target=wasm32-wasi -std=c11 -O2 -ffp-contract=off -mexec-model=reactor \
        -Wl,--strip-all,--stack-first,-z,stack-size=1048576 -o "$work/wasm" "$program" 2>"$work/said"; then
        cat >"$work/live" <<PAGE
<div id="live" data-name="$name">
<canvas class="canvas" role="img" aria-label="What $name draws, while it runs"></canvas>
<div class="run">
<div class="numbers"></div>
<details><summary>More numbers</summary><div class="more"></div></details>
<p class="keys"><button class="again">Again</button> <button class="pause">Pause</button>
<button class="to-end">To the end</button> <button class="usual">Usual numbers</button></p>
<pre><code class="command"></code></pre>
<pre class="said" aria-live="polite"></pre>
<p class="beside"></p>
<pre class="native" hidden="hidden">$(escaped "$work/printed")
</pre>
</div>
<script class="wasm" type="application/wasm">$(base64 "$work/wasm" | tr -d '\n')</script>
</div>
<noscript>$picture</noscript>
<script src="live.js"></script>
PAGE
    else
        cat >"$work/live" <<PAGE
<p><em>This page was made without clang and wasi-libc, and the program cannot run in it.
This is what it draws and prints.</em></p>
$picture
PAGE
    fi
fi
# What tests/tables/steps.txt compares the program with, if `make book` has asked it.
beside=$(dirname "$page")/../steps-beside.txt
if [ -z "$plain" ] && [ -f "$beside" ]; then
    awk -F'|' -v step="$name" '
        BEGIN { print "<p>In the tests it stands beside winnow, or beside what is exact:</p><table><thead><tr><th>what is compared</th><th>the program</th>" \
            "<th>winnow, or exact</th></tr></thead><tbody>" }
        $1 == step { sub(/^--/, "", $4)
            printf "<tr><td>%s</td><td>%.6g</td><td>%.6g</td></tr>\n", $2, $3, $4 }
        END { print "</tbody></table>" }' "$beside" >>"$work/live"
fi
awk -v live="$work/live" -v listing="$work/listing" '
    function put(file,    line) { while ((getline line < file) > 0) print line }
    { print }
    /<h2 id="run-it-here">/ { put(live); n++ }
    /<h2 id="the-program">/ { put(listing); n++ }
    END { exit n != 2 }' "$page" >"$work/page" ||
    { echo "book: $page: not both headings, Run it here and The program" >&2; exit 1; }
cp "$work/page" "$page"
