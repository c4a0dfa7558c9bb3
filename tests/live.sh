#!/bin/sh
# The steps of the course in their pages, in a browser: each program runs to its
# end and prints what the native one prints; so it does after the first slider
# was moved to an end; no error is told. Left out with a word where there is no
# Chromium, or where the book was made without the compiler.
#
#   sh tests/live.sh build
set -u
build=$(cd "$1" && pwd)
. chapters/tools/chromium.inc
[ -n "$browser" ] || { echo "steps in their pages: no Chromium"; exit 0; }
grep -q 'id="live"' "$build"/book/step-*.html ||
    { echo "steps in their pages: the book was made without clang for wasm32"; exit 0; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
steps=$(cd chapters/steps && ls [0-9]*.c | sed 's/[.]c$//')
# shellcheck disable=SC2086 # one word a step
opened "$work" 900000 "file://$PWD/tests/pages/live.html#$(echo "$build/book" $steps)" --disable-gpu >"$work/said"
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
for name in $steps; do
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
