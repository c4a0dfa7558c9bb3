#!/bin/sh
# What a reader is told to type runs.
#
#   sh tests/commands.sh build          (part of make check)
#   sh tests/commands.sh build whole    (part of make check-slow)
#
# The short form compiles every program of figures/, and runs every command of
# winnow that the book and the README name: cases two steps far, their beds not settled,
# without pictures; and of studies and other commands each day those of another tenth
# of the lines.
# The whole form runs the commands as they stand, and those of scripts as well.
# Cases that `winnow check` expects to take more than a minute settle their beds
# (more than half an hour: do not settle them) and go two steps; long validation is
# left out, and of make's targets it is only seen that they are there.
set -u
top=$PWD
build=$(cd "${1:-build}" && pwd)
whole=${2:-}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export OMP_WAIT_POLICY=passive
failed=0
facts=0
lines=0
turn=$(($(date +%s) / 86400 % 10))

# All at once; gcc names the file of each error.
compile() {
    # shellcheck disable=SC2046 # one word a flag
    if ${CC:-gcc} -std=c11 -D_POSIX_C_SOURCE=200809L -fopenmp -fsyntax-only \
        -Werror=implicit-function-declaration -Wall -Wextra -Isrc -Itests \
        $(pkg-config --cflags hdf5 2>/dev/null) figures/*/*.c; then
        facts=$((facts + $(ls figures/*/*.c | wc -l)))
    else
        echo "FAILED a program of figures/ does not compile"
        failed=$((failed + 1))
    fi
}

# What is made by a rule of its own may be the first that is made.
first() { # goal
    if (cd "$work" && MAKEFLAGS='' make -s B="$work/fresh" "$work/fresh/$1") >/dev/null; then
        facts=$((facts + 1)) && echo "    first of a fresh clone: $1"
    else
        echo "FAILED $1 cannot be made first"
        failed=$((failed + 1))
    fi
    rm -rf "$work/fresh"
}

# What a bounded run goes to: two steps of the fluid, or else 2 ms.
end_of() { # case
    (cd "$work" && build/winnow check "$1" 2>/dev/null) | awk '
        $1 == "step" && $3 == "s" { end = 2 * $2 }
        END { print end ? end : "2e-3" }'
}

# A bounded run samples statistics from its start.
ended() { # build/winnow run CASE ...
    samples=
    grep -qs 'statistics = {' "$3" "${3%%-[a-z]*.cfg}"*.inc && samples='-s output.statistics.from=0.0'
    echo "$* $samples -s output.end=$(end_of "$3")"
}

# The short form of `winnow run CASE ...`: a picture takes longer than two steps.
shortened() {
    bed= picture='-s output.picture=false'
    grep -q 'bed = {' "$3" && bed='-s particles.bed.settle=0'
    case $* in *animation*) picture= ;; esac
    # shellcheck disable=SC2086 # words
    ended "$@" $bed $picture
}

# The whole form of `winnow run CASE ...`.
bounded() {
    seconds=$(cd "$work" && build/winnow check "$3" | awk '$1 == "time" { print int($2) * (/at least/ ? 10 : 1) }')
    if [ "${seconds:-61}" -le 60 ]; then echo "$*"
    elif [ "${seconds:-61}" -le 1800 ]; then ended "$@"
    else shortened "$@"; fi
}

today() { [ -z "$whole" ] && [ $((lines % 10)) -ne "$turn" ] || echo "$1"; }

# What is to be run of a command that should end with the code; nothing if it is
# left out here.
form_of() { # code command...
    code=$1
    shift
    case $* in
    'make build/'*) [ -z "$whole" ] || echo "$*" ;;
    sudo\ *) ;; # tests/bare.sh does
    make\ *) echo "grep -q ^$2: Makefile" ;;
    mkdir\ * | 'awk -f cases/'*) echo "$*" ;; # a mesh for the run that follows
    diff\ *) echo "$*" ;;
    *validate/* | 'sh chapters/tools/check.sh') ;;
    'sh figures/27/27-mueller.sh forms') [ -z "$whole" ] || echo "$* 2e-3" ;; # not 18 s
    'sh figures/27/27-mueller.sh run'*) [ -z "$whole" ] || echo "${*% *} 2e-3" ;;
    xvfb-run*)
        [ -z "$whole" ] || ! command -v xvfb-run >/dev/null || ! command -v pvpython >/dev/null || echo "$*" ;;
    'build/winnow run'*)
        # shellcheck disable=SC2086 # words
        if [ "$code" != 0 ]; then echo "$*"
        elif [ -n "$whole" ]; then bounded $*
        else shortened $*; fi ;;
    build/winnow\ study*) today "$*" ;;
    build/winnow\ *) echo "$*" ;;
    *) today "$*" ;;
    esac
}

try() { # where code command...
    where=$1 code=$2
    lines=$((lines + 1))
    shift 2
    run=$(form_of "$code" "$@")
    [ -n "$run" ] || return 0
    (cd "$work" && timeout 900 sh -c "$run") >"$work/said" 2>&1 </dev/null
    found=$?
    if [ $found = "$code" ]; then
        facts=$((facts + 1)) && echo "    $where: $*"
    else
        echo "FAILED $where: exit code $found, not $code: $run"
        tail -5 "$work/said"
        failed=$((failed + 1))
    fi
}

# Commands may write beside what they read, so they run in a copy.
cp -Rp Makefile README.md .ci cases chapters figures tests src "$work"
ln -s "$build" "$work/build"
cd "$top" || exit 1

compile
first src/tell/equation_index_rows.o
first tests/winnow_main.o
awk -f tests/commands.awk README.md chapters/*.md chapters/manual/*.md \
    chapters/journal/*.md chapters/steps/README.md >"$work/commands"
while read -r where code command; do
    # shellcheck disable=SC2086 # words
    try "$where" "$code" $command
done <"$work/commands"
[ -z "$whole" ] || sh chapters/tools/transcript.sh -w "$build/winnow" moved 5 figures/*.txt figures/*/*.txt |
    awk -F: '
        { late = late "\n    " $1 }
        END { if (NR) print "note: slow results that may have moved (make figures):" late }'
echo "commands of the book: $facts passed, $failed failed"
[ $failed -eq 0 ]
