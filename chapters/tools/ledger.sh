#!/bin/sh
# Keeps chapters/equations.md: each equation of the four documents with the
# functions, tests and sections that cite it.
#
#   sh chapters/tools/ledger.sh            rewrites it, and shortens pending.txt
#   sh chapters/tools/ledger.sh check      fails where code, tests, chapters and
#                                          ledger.txt do not agree
set -u
mode=${1:-write}
tools=$(dirname "$0")
new=$(mktemp) left=$(mktemp)
trap 'rm -f "$new" "$left"' EXIT
failed=0

# shellcheck disable=SC2046 # one word a file
awk -v ledger=chapters/ledger.txt -v pending=chapters/pending.txt \
    -v left="$left" -f "$tools/c.awk" -f "$tools/cite.awk" \
    -f "$tools/table.awk" -f "$tools/ledger.awk" \
    $(find src tests -name '*.[ch]' | LC_ALL=C sort) chapters/[0-9]*.md \
    $(find chapters/manual chapters/journal -name '*.md' 2>/dev/null | LC_ALL=C sort) \
    >"$new" || failed=1

if [ "$mode" = check ]; then
    if [ $failed = 0 ] && ! diff -u chapters/equations.md "$new"; then
        echo "chapters/equations.md is not what the source says (make weave)"
        failed=1
    fi
    [ $failed = 1 ] || [ ! -s "$left" ] ||
        echo "ledger: $(wc -l <"$left") equations still wait (chapters/pending.txt)"
elif [ $failed = 0 ]; then
    cmp -s "$new" chapters/equations.md || cat "$new" >chapters/equations.md
    { grep '^#' chapters/pending.txt && cat "$left"; } >"$new"
    cmp -s "$new" chapters/pending.txt || cat "$new" >chapters/pending.txt
fi
exit $failed
