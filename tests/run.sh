#!/bin/sh
# Runs test programs and prints the facts that they show.
#
#   sh tests/run.sh build/tests              (all of a folder)
#   sh tests/run.sh build/tests/test_drag
#
# Check writes one line a test to its log: file, line, P or F or E, name. The
# names of the tests are the facts; PROGRAM.facts holds those of a program.
set -u
# Instrumented tests are many times slower than the limit of 4 s is meant for.
export CK_TIMEOUT_MULTIPLIER=20
# Threads that wait should not keep others from working on a busy machine.
export OMP_WAIT_POLICY=passive
failed=0
count=0

run() { # program
    log=$1.log
    : >"$log"
    CK_LOG_FILE_NAME=$log timeout 1200 "$1" >"$1.out" 2>&1
    code=$?
    # A test that loops over a table is one fact.
    sed -n 's/^[^:]*:[0-9]*:P:[^:]*:\([^:]*\):.*/    \1/p' "$log" | uniq >"$1.facts"
    passed=$(wc -l <"$1.facts")
    count=$((count + passed))
    echo "$(basename "$1"): $passed facts"
    cat "$1.facts"
    if [ $code -ne 0 ] || grep -q ':[FE]:' "$log" || [ "$passed" -eq 0 ]; then
        grep ':[FE]:' "$log" || cat "$1.out"
        grep -A 12 -E 'Sanitizer|runtime error' "$1.out" # why it ended early
        failed=$((failed + 1))
    fi
}

[ -d "$1" ] && set -- "$1"/test_*
for program in "$@"; do
    case ${program##*/} in *.*) continue ;; esac
    run "$program"
done
if [ "$failed" -gt 0 ]; then
    echo "$failed test programs failed"
    exit 1
fi
[ $# -eq 1 ] || echo "$count passed, 0 failed"
