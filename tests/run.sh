#!/bin/sh
# Runs every test program in a folder and prints the facts that they show.
#
#   sh tests/run.sh build/tests
#
# Check writes one line a test to its log: file, line, P or F or E, name. The
# names of the tests are the facts.
set -u
dir=$1
log=$dir/facts.log
failed=0
count=0
# Instrumented tests are many times slower than the limit of 4 s is meant for.
export CK_TIMEOUT_MULTIPLIER=20
# Threads that wait should not keep others from working on a busy machine.
export OMP_WAIT_POLICY=passive

for test in "$dir"/test_*; do
    case $test in *.*) continue ;; esac
    : >"$log"
    CK_LOG_FILE_NAME=$log "$test" >"$log.out" 2>&1 || failed=$((failed + 1))
    # A test that loops over a table is one fact.
    sed -n 's/^[^:]*:[0-9]*:P:[^:]*:\([^:]*\):.*/    \1/p' "$log" | uniq >"$log.facts"
    passed=$(wc -l <"$log.facts")
    count=$((count + passed))
    echo "$(basename "$test"): $passed facts"
    cat "$log.facts"
    if grep -q ':[FE]:' "$log" || ! grep -q ':P:' "$log"; then
        grep ':[FE]:' "$log" || cat "$log.out"
        grep -A 12 -E 'Sanitizer|runtime error' "$log.out" # why it ended early
        [ "$failed" -gt 0 ] || failed=1
    fi
done
if [ "$failed" -gt 0 ]; then
    echo "$failed test programs failed"
    exit 1
fi
echo "$count passed, 0 failed"
