#!/bin/sh
# Opens every page of the book in a browser, as wide as a phone and as a desk:
# nothing may be wider than the window, every image and font must load, every formula
# must take up room, and on a desk none may be wider than its column. Left out with a
# word where there is no Chromium. Search must find something, and a page that was left
# must be offered.
#
#   sh chapters/tools/browser.sh build/book
set -eu
book=$(cd "$1" && pwd)
check=$book-check.html
browser=
for name in chromium chromium-browser google-chrome; do
    command -v $name >/dev/null && browser=$name && break
done
[ -n "$browser" ] || { echo "book: without Chromium no page is opened"; exit 0; }
trap 'rm -rf "$check" "$check.profile"' EXIT

{
    cat <<'END'
<!DOCTYPE html>
<iframe></iframe>
<pre></pre>
<script>
const say = s => document.querySelector('pre').append(s + '\n');
const frame = document.querySelector('iframe');
frame.style.height = '800px';
function look(page, width) {
  const doc = frame.contentDocument;
  const wrong = s => say('WRONG ' + page + ' at ' + width + ': ' + s);
  const root = doc.documentElement;
  if (!doc.querySelector('main')) wrong('no text');
  if (root.scrollWidth > width + 1) {
    const wide = [...doc.querySelectorAll('main *')].find(
      e => !e.closest('pre, table, .formula') &&
           e.getBoundingClientRect().right > width + 1);
    wrong('wider than the window: ' + (wide ? wide.textContent.slice(0, 40) : ''));
  }
  for (const word of doc.querySelectorAll('pre > span > span'))
    if (frame.contentWindow.getComputedStyle(word).display !== 'inline') {
      wrong('a line of code is torn');
      break;
    }
  for (const image of doc.images)
    if (!image.naturalWidth) wrong('no image ' + image.getAttribute('src'));
  for (const formula of doc.querySelectorAll('math'))
    if (!formula.closest('details') &&
        !formula.getBoundingClientRect().width) wrong('a formula is empty');
  for (const box of doc.querySelectorAll('.formula'))
    if (width > 1000 && box.scrollWidth > box.clientWidth + 1)
      wrong('a formula is cut: ' + box.parentNode.id);
}
async function open(page, width) {
  frame.style.width = width + 'px';
  frame.src = page;
  await new Promise(done => frame.onload = done);
  for (const font of frame.contentDocument.fonts) // a page may be there before them
    await font.load().catch(() => say('WRONG ' + page + ': no font ' + font.family));
  look(page, width);
}
const wait = ms => new Promise(done => setTimeout(done, ms));
// Search finds a section by a word, and the first page knows where one has read.
async function serve(folder) {
  await open(folder + '/09-drag.html', 1200);
  const box = frame.contentDocument.getElementById('search');
  box.value = 'richardson zaki';
  box.dispatchEvent(new Event('input'));
  await wait(2000);
  if (!frame.contentDocument.querySelector('#found a')) say('WRONG search finds nothing');
  frame.contentDocument.getElementById('a-packed-bed').scrollIntoView();
  frame.contentWindow.dispatchEvent(new Event('scroll')); // no frame is drawn here
  await wait(1000);
  await open(folder + '/index.html', 1200);
  const back = frame.contentDocument.querySelector('a.return');
  if (!back || !back.href.endsWith('09-drag.html#a-packed-bed'))
    say('WRONG no place to return to: ' + (back && back.href));
}
(async () => {
  await serve(pages[0].replace(/\/.*/, ''));
  for (const page of pages)
    for (const width of [360, 1200]) await open(page, width);
  say('opened ' + pages.length);
})();
</script>
END
} >"$check"
# A frame has no border, so that its width is that of a window.
pages=$(cd "$book/.." && find "$(basename "$book")" -name '*.html' | sort |
    sed "s/.*/'&',/")
{ echo "<style>iframe { border: 0 }</style><script>const pages = [$pages];</script>"
    cat "$check"; } >"$check.new"
mv "$check.new" "$check"

"$browser" --headless --no-sandbox --disable-gpu --hide-scrollbars \
    --user-data-dir="$check.profile" --allow-file-access-from-files \
    --virtual-time-budget=600000 --dump-dom "file://$check" 2>/dev/null |
    sed -n '/^WRONG/p; /<pre>WRONG/s/.*<pre>//p; s/.*\(opened [0-9]*\)$/\1/p' \
        >"$check.said"
grep -v '^opened' "$check.said" && failed=1 || failed=0
grep -q '^opened' "$check.said" || { echo "book: the browser gave up"; failed=1; }
echo "book: $(sed -n 's/^opened/pages opened:/p' "$check.said")"
rm -f "$check.said"
exit $failed
