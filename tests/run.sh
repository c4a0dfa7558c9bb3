#!/bin/sh
# Runs test programs and prints the facts that they show.
#
#   sh tests/run.sh build/tests              (all of a folder)
#   sh tests/run.sh build/tests/test_drag
#
# Check writes one line a test to its log: file, line, P or F or E, name. The
# names of the tests are the facts; PROGRAM.facts holds those of a program.
set -u
# Instrumented tests are many times slower than the limit of a minute is meant for.
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
    cat "$1.facts"
    wrong=$(grep -c ':[FE]:' "$log")
    if [ $code -ne 0 ] || grep -q ':[FE]:' "$log" || [ "$passed" -eq 0 ]; then
        [ "$wrong" -gt 0 ] || wrong=1 # it ended early, or has no fact
        grep ':[FE]:' "$log" || cat "$1.out"
        grep -A 12 -E 'Sanitizer|runtime error' "$1.out" # why it ended early
    fi
    echo "$(basename "$1"): $passed passed, $wrong failed"
    failed=$((failed + wrong))
}

[ -d "$1" ] && set -- "$1"/test_*
for program in "$@"; do
    case ${program##*/} in *.*) continue ;; esac
    run "$program"
done
[ $# -eq 1 ] || echo "together: $count and $failed"
[ "$failed" -eq 0 ]
