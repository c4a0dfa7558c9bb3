#!/bin/sh
# Which tests notice a change of the source?
#
#   sh chapters/solutions/try.sh PATCH TEST...
#
# Builds each tests/test_TEST.c with the files of src/ changed as the patch says
# and prints the names of the tests that fail. The source stays as it is.
set -eu
patch=$1
shift
for test in "$@"; do
    echo "tests/test_$test.c:"
    LIBS='-lcheck -lsubunit -lrt -lpthread' \
        sh figures/run.sh "tests/test_$test.c" "$patch" 2>&1 |
        awk '
        /: error: |FAILED/ { print; broken = 1 }
        /^tests.*:[FE]:/ {
            split($0, word, ":")
            if (!seen[word[5]]++) print "    " word[5]
            n++
        }
        END { if (!n && !broken) print "    nothing fails" }'
done
