#!/bin/sh
# Everything about the book that a machine can check. Part of `make check`.
#
#   sh chapters/tools/check.sh build/winnow
set -u
winnow=${1:-build/winnow}
tools=$(dirname "$0")
failed=0

step() { "$@" || failed=1; }

step sh "$tools/weave.sh" check
step sh "$tools/ledger.sh" check
[ $failed = 0 ] && echo "book: as the source says"
exit $failed
