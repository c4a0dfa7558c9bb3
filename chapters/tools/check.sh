#!/bin/sh
# Everything about the book that a machine can check. Part of `make check`.
#
#   sh chapters/tools/check.sh build/winnow
set -u
winnow=${1:-build/winnow}
tools=$(dirname "$0")
failed=0

step() { "$@" || failed=1; }

# shellcheck disable=SC2046 # one word a file
step awk -f "$tools/text.awk" chapters/*.md chapters/solutions/*.md \
    $(find src tests -name '*.[ch]')
[ ! -d figures ] || step sh "$tools/transcript.sh" -w "$winnow" check figures/*.txt
step sh "$tools/weave.sh" check
step sh "$tools/ledger.sh" check
step sh "$tools/unshown.sh" check
step sh "$tools/solutions.sh" "$(dirname "$winnow")"
if command -v pandoc >/dev/null; then
    step sh "$tools/book.sh" "$(dirname "$winnow")/book"
else
    echo "book: without pandoc no pages are made"
fi
[ $failed = 0 ] && echo "book: as the source says"
exit $failed
