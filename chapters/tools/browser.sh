#!/bin/sh
# Opens every page of the book in a browser, as wide as a phone and as a desk:
# nothing may be wider than the window, every image and font must load, every formula
# must take up room, and on a desk none may be wider than its column. Left out with a
# word where there is no Chromium. Search must find something, and a page that was left
# must be offered (browser.html).
#
#   sh chapters/tools/browser.sh build/book
set -eu
book=$(cd "$1" && pwd)
tools=$(cd "$(dirname "$0")" && pwd)
. "$tools/chromium.inc"
[ -n "$browser" ] || { echo "book: without Chromium no page is opened"; exit 0; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
opened "$work" 600000 "file://$tools/browser.html#$book $(cd "$book" && find . -name '*.html' | LC_ALL=C sort | tr '\n' ' ' | sed 's/ $//')" --disable-gpu >"$work/said"
grep '^WRONG' "$work/said" && failed=1 || failed=0
grep -q '^opened' "$work/said" || { echo "book: the browser gave up"; failed=1; }
echo "book: $(sed -n 's/^opened/pages opened:/p' "$work/said")"
exit $failed
