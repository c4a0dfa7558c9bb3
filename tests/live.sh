#!/bin/sh
# The steps of the course in their pages, in a browser: each program runs to its
# end and prints what the native one prints; so it does after the first slider
# was moved to an end; no error is told. Left out with a word where there is no
# Chromium, or where the book was made without the compiler.
#
#   sh tests/live.sh build
set -u
build=$(cd "$1" && pwd)
browser=
for name in chromium chromium-browser google-chrome; do
    command -v $name >/dev/null && browser=$name && break
done
[ -n "$browser" ] || { echo "steps in their pages: no Chromium"; exit 0; }
grep -q 'id="live"' "$build"/book/step-*.html ||
    { echo "steps in their pages: the book was made without clang for wasm32"; exit 0; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
check=$build/live-check.html
{
    cat <<'PAGE'
<!DOCTYPE html>
<iframe style="width: 390px; height: 800px"></iframe>
<pre></pre>
<script>
const frame = document.querySelector('iframe'), out = document.querySelector('pre');
const done = box => new Promise(tell => {
  const look = () => box.dataset.state === 'done' ? tell() : setTimeout(look, 20);
  look();
});
async function open(name) {
  frame.src = 'book/step-' + name + '.html#hurry';
  await new Promise(tell => frame.onload = tell);
  const page = frame.contentDocument, box = page.getElementById('live');
  const part = c => box.querySelector('.' + c);
  const say = s => out.append('@ ' + name + ' ' + s + '\n');
  frame.contentWindow.addEventListener('error', e => say('ERROR ' + e.message));
  frame.contentWindow.addEventListener('unhandledrejection', e => say('ERROR ' + e.reason));
  const tell = () => out.append('@ ' + name + ' $' +
    part('command').textContent.replace(/^\S+/, '') + '\n' + part('said').textContent);
  await done(box);
  tell();
  const slider = part('numbers').querySelector('input');
  slider.value = slider.value === slider.max ? slider.min : slider.max;
  slider.dispatchEvent(new Event('input'));
  await done(box);
  tell();
  const canvas = part('canvas');
  const dots = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
  if (!dots.some(d => d)) say('ERROR the canvas is empty');
}
(async () => {
PAGE
    for program in chapters/steps/[0-9]*.c; do
        echo "  await open('$(basename "$program" .c)');"
    done
    echo "  out.append('@ all');"
    echo "})();"
    echo "</script>"
} >"$check"
timeout 400 "$browser" --headless --no-sandbox --disable-gpu --disable-quic --no-first-run \
    --disable-background-networking --disable-component-update --disable-sync \
    --user-data-dir="$work/profile" --allow-file-access-from-files \
    --enable-logging=stderr --virtual-time-budget=900000 --dump-dom "file://$check" \
    2>"$work/log" | sed -n '/^<pre>/,/^<\/pre>/p; s/^<iframe.*<pre>@/@/p' |
    sed 's/^<pre>//; s/^<\/pre>.*//; s/&gt;/>/g; s/&lt;/</g; s/&amp;/\&/g' >"$work/said"
rm -f "$check"
grep -q '^@ all' "$work/said" || { echo "FAILED the browser gave up"; tail -3 "$work/said"; }
failed=0
facts=0
wrong() {
    failed=$((failed + 1))
    echo "FAILED $*"
}
grep 'CONSOLE.*\(Error\|Uncaught\)' "$work/log" && wrong "the console tells errors"
grep '^@ .* ERROR' "$work/said" && wrong "a page tells errors"
cp "$build"/steps/[0-9]* "$work"
for program in chapters/steps/[0-9]*.c; do
    name=$(basename "$program" .c)
    for k in 1 2; do
        # shellcheck disable=SC2046 # NAME=VALUE is one word
        set -- $(grep "^@ $name \\$" "$work/said" | sed -n "$k s/^[^\$]*\\\$//p")
        awk -v name="$name" -v k=$k '
            $1 == "@" { here = $2 == name && $3 == "$" && ++n == k; next }
            here' "$work/said" >"$work/page"
        "$work/$name" "$@" >"$work/native" 2>&1
        if cmp -s "$work/page" "$work/native" && [ -s "$work/page" ]; then
            facts=$((facts + 1)) && echo "    $name $* prints the same in its page"
        else
            wrong "$name $* prints something else in its page"
            diff "$work/page" "$work/native" | head -4
        fi
    done
done
echo "steps in their pages: $facts passed, $failed failed"
[ $failed -eq 0 ] && [ $facts -gt 0 ]
