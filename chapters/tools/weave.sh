#!/bin/sh
# Refreshes what the chapters quote from the source and from results of runs.
#
#   sh chapters/tools/weave.sh              rewrites the fences and numbers
#   sh chapters/tools/weave.sh check        prints what differs, and fails
set -u
mode=${1:-write}
tools=$(dirname "$0")
new=$(mktemp) calls=$(mktemp)
trap 'rm -f "$new" "$calls"' EXIT
failed=0

# shellcheck disable=SC2046 # one word a file
awk -f "$tools/c.awk" -f "$tools/calls.awk" $(find chapters -name '*.md') \
    $(find src -name '*.[ch]' | LC_ALL=C sort) >"$calls"
for chapter in $(find chapters -name '*.md' ! -path '*/steps/*' | LC_ALL=C sort); do
    # equations.md is made by ledger.sh. README.md shows the directives, and has minutes.
    case $chapter in
    */equations.md) continue ;;
    */README.md) set -- -f "$tools/minutes.awk" ;;
    *) set -- -v calls="$calls" -f "$tools/c.awk" -f "$tools/show.awk" -f "$tools/weave.awk" ;;
    esac
    if ! awk "$@" "$chapter" >"$new"; then
        failed=1
    elif cmp -s "$chapter" "$new"; then
        :
    elif [ "$mode" = check ]; then
        echo "$chapter is not what the source says (make weave):"
        diff -u --label "$chapter" --label woven "$chapter" "$new"
        failed=1
    else
        cat "$new" >"$chapter"
        echo "wove $chapter"
    fi
done
exit $failed
