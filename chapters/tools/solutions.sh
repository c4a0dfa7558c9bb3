#!/bin/sh
# Applies each solution of an exercise to a copy of the source, and runs the tests
# that it names.
#
#   sh chapters/tools/solutions.sh build [PATCH...]
#
# A solution is a patch, chapters/solutions/09-3.patch. Above its first "diff" or
# "---" stand the program and the facts that tell whether it is right:
#   test_drag holds gidaspow_smooth_has_no_jump           (a test of the solution)
#   test_drag fails xs11_2_11_beta_is_the_printed_product (damage on purpose)
# With "fails", these facts and no others of the program may fail.
set -u
# A busy machine is slower than the limit of 4 s is meant for.
export CK_TIMEOUT_MULTIPLIER=20
build=$1
shift
[ $# -gt 0 ] || set -- chapters/solutions/*.patch
tree=$build/solution.$$ # several may run side by side
facts=$tree.facts
failed=0
count=0

# The build goes along, so that only what the patch touches is compiled anew. The
# files are links, which is many times faster than copies: patch, the assembler
# and the linker put a new file in the place of a link, and nothing else writes.
links() { cp -rpl "$@" 2>/dev/null || cp -rp "$@"; }
copy() {
    rm -rf "$tree"
    mkdir -p "$tree/build/tests" "$tree/chapters/tools"
    cp -rp cases "$tree"
    links src tests Makefile "$tree"
    links chapters/equations.md "$tree/chapters"
    links chapters/tools/rows.awk "$tree/chapters/tools"
    links "$build/src" "$build/libwinnow.a" "$build/packages" "$tree/build"
    links "$build"/tests/test_*.[od] "$tree/build/tests"
}

wanted() { # program, holds or fails
    sed -n "/^diff\|^---/q; s/^$1 $2 //p" "$patch" | LC_ALL=C sort
}

try() { # program
    # No dependencies are written, for they would be written through the links.
    MAKEFLAGS= make -s -C "$tree" B=build WERROR='-Werror -MMD -MF /dev/null' \
        "build/tests/$1" >"$facts.make" 2>&1 || {
        tail -5 "$facts.make"
        echo "$patch: $1 does not build"
        return 1
    }
    (cd "$tree" && CK_LOG_FILE_NAME=facts.log "build/tests/$1") >/dev/null 2>&1
    sed -n 's/^[^:]*:[0-9]*:[FE]:[^:]*:\([^:]*\):.*/\1/p' "$tree/facts.log" |
        LC_ALL=C sort -u >"$facts" # a loop of tests fails more than once
    wanted "$1" fails | diff - "$facts" >"$facts.diff" || {
        sed -n 's/^< \(.*\)/holds, and should fail: \1/p
            s/^> \(.*\)/fails, and should hold: \1/p' "$facts.diff"
        echo "$patch: $1 does not do what is said"
        return 1
    }
    for fact in $(wanted "$1" holds); do
        grep -q ":P:[^:]*:$fact:" "$tree/facts.log" ||
            { echo "$patch: $1 has no fact $fact"; return 1; }
    done
}

for patch in "$@"; do
    [ -f "$patch" ] || continue
    count=$((count + 1))
    copy
    if ! patch -s -p1 -d "$tree" <"$patch"; then
        echo "$patch: does not apply"
        failed=$((failed + 1))
        continue
    fi
    programs=$(sed -n '/^diff\|^---/q; s/^\(test_[a-z_0-9]*\) .*/\1/p' "$patch" |
        sort -u)
    right=1
    [ -n "$programs" ] || { echo "$patch: names no test"; right=0; }
    for program in $programs; do try "$program" || right=0; done
    failed=$((failed + 1 - right))
done
rm -rf "$tree" "$tree".*
echo "solutions, the last $(basename "$patch"): $((count - failed)) passed, $failed failed"
[ $failed -eq 0 ]
