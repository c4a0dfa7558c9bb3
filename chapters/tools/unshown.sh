#!/bin/sh
# Lists the functions of src/ that a reader should meet and does not: public
# ones, and those that compute an equation.
#
#   sh chapters/tools/unshown.sh            their number, by file
#   sh chapters/tools/unshown.sh names      each with its file and line
#   sh chapters/tools/unshown.sh check      only the totals; fails on a useless
#                                           exemption in chapters/unshown.txt, and
#                                           where calls of the course lead nowhere
set -u
tools=$(dirname "$0")
list=$(mktemp)
trap 'rm -f "$list"' EXIT
names=
[ "${1:-}" = names ] && names=1

# shellcheck disable=SC2046 # one word a file
awk -v exempt=chapters/unshown.txt -v names=$names -f "$tools/c.awk" \
    -f "$tools/unshown.awk" chapters/[0-9]*.md \
    $(find chapters/manual chapters/journal -name '*.md' 2>/dev/null) \
    $(find src -name '*.[ch]' | LC_ALL=C sort) >"$list"
failed=$?
if [ "${1:-}" = check ]; then tail -2 "$list"; else cat "$list"; fi
exit $failed
