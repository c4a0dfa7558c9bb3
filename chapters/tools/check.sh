#!/bin/sh
# Everything about the book that a machine can check. `make check` does text, results
# and a tenth of the solutions a day, `make check-slow` all solutions and the pages.
#
#   sh chapters/tools/check.sh build/winnow [text|results|solutions|pages]...
set -u
winnow=${1:-build/winnow}
build=$(dirname "$winnow")
tools=$(dirname "$0")
failed=0
facts=0

step() {
    if "$@"; then
        facts=$((facts + 1))
    else
        echo "FAILED $*" | cut -c -100
        failed=$((failed + 1))
    fi
}

text() {
    # shellcheck disable=SC2046 # one word a file
    step awk -f "$tools/text.awk" $(find chapters -name '*.md' ! -path '*/steps/*' | LC_ALL=C sort) \
        $(find src tests chapters/steps -name '*.[ch]')
    step sh "$tools/weave.sh" check
    step sh "$tools/ledger.sh" check
    step sh "$tools/unshown.sh" check
    # shellcheck disable=SC2046
    awk -v half=1 -f "$tools/listings.awk" $(find chapters -name '[0-9]*.md' ! -path '*/solutions/*')
}

results() {
    step sh "$tools/transcript.sh" -w "$winnow" check figures/*.txt figures/*/*.txt
}

solutions() {
    step sh "$tools/solutions.sh" "$build"
}

pages() {
    if command -v pandoc >/dev/null; then
        step sh "$tools/book.sh" "$build/book.plain" plain
    else
        echo "book: without pandoc no pages are made"
    fi
}

[ $# -gt 0 ] && shift
[ $# -gt 0 ] || set -- text results solutions pages
for part in "$@"; do $part; done
echo "the book's $*: $facts passed, $failed failed"
[ $failed -eq 0 ]
