#!/bin/sh
# Runs the commands of transcripts and puts their output below them.
#
#   sh chapters/tools/transcript.sh [-w WINNOW] [check|age|moved SECONDS] FILE...
#
# A transcript is a text file with lines that begin with "$ ": commands, run in
# the top folder. What they print goes
# up to the next command or the next "## part"; lines "## part" that a command
# prints itself belong to its output. check compares instead, numbers to 1e-6 of
# their size, because two processors may differ in the last digits. A file stays as
# it was if a command fails, or if one that printed something prints nothing now.
#
# A file that begins with "# slow" is compared only if it is the only one. Its
# first line keeps the revision it was made at, with a "+" if what it depends on was
# changed since, the processor time that it took, and a sum of what it depends on:
# "# slow, made at 1234abc in 12 s of 3870412: reason". age names the slow ones of which
# this sum is another now: that of their commands, of the files that these name, and of
# the numbers that figures/short-runs.txt has of the modules that their programs reach.
# These short runs stand for the code of src, which changes every day while few changes
# move a number; what moves longer runs only is not noticed. Of modules that have no short
# runs the code counts. Comments and layout do not. moved runs those of them that took at
# most so many seconds, and leaves out the ones that still print the same.
set -u
winnow=build/winnow
[ "${1:-}" = -w ] && winnow=$2 && shift 2
mode=write
most=0
case ${1:-} in
check | age) mode=$1 && shift ;;
moved) mode=age && most=$2 && shift 2 ;;
esac
BUILD=$(cd "$(dirname "$winnow")" && pwd)
export BUILD
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
new=$work/new
failed=0

# The first reading notes which parts have a command of their own. Of those that
# have none, the ones below a command that prints parts are its old output.
# A command of winnow may show how it fails; any other that does is noted.
replay() {
    rm -f "$work/failed"
    awk -v failed="$work/failed" '
    NR == FNR {
        if (/^## /) part = FNR
        else if (/^\$ / && part) own[part] = 1
        next
    }
    /^\$ / {
        print; fflush()
        command = substr($0, 3) " 2>&1"
        if (command !~ /^(build\/)?winnow /) command = command "\n[ $? = 0 ] || echo " FNR " >>" failed
        parts = 0
        while ((command | getline line) > 0) {
            if (line ~ /^## /) parts = 1
            print line
        }
        close(command)
        skip = 1
        next
    }
    /^## / && !(parts && !own[FNR]) {
        if (skip) print ""
        skip = parts = 0
    }
    !skip' "$1" "$1"
}

same() {
    awk -v old="$1" '
    function number(s) { return s ~ /^[-+]?[0-9.]+(e[-+]?[0-9]+)?,?$/ }
    function near(a, b,    d, size) {
        d = a - b; size = a < 0 ? -a : a
        return (d < 0 ? -d : d) <= 1e-6 * size
    }
    {
        if ((getline line < old) <= 0) { different = 1; exit }
        n = split(line, a, /[ \t(]+/)
        if (split($0, b, /[ \t(]+/) != n) { different = 1; exit }
        for (i = 1; i <= n; i++)
            if (a[i] != b[i] && !(number(a[i]) && number(b[i]) &&
                                  near(a[i] + 0, b[i] + 0))) {
                different = 1; exit
            }
    }
    END { exit different || (getline line < old) > 0 }' "$2"
}

# The commands that printed something in the old file and print nothing in the new.
silent() { # old new
    awk '
    /^\$ / { command = substr($0, 3); if (NR != FNR) asked[command] = 1; next }
    /^#/ || /^$/ { next }
    NR == FNR { had[command] = 1; next }
    { has[command] = 1 }
    END { for (c in asked) if (c in had && !(c in has)) print c }' "$1" "$2"
}

slow() { head -1 "$1" | grep -q '^# slow'; }

# The files that a text names but for pictures, which commands make.
named() {
    cat "$@" |
        grep -oE '(figures|figures/[0-9a-z]+|cases|chapters/tools|tests|tests/bench)/[A-Za-z0-9_.-]+\.[a-z]+' |
        grep -v -E '\.(svg|png)$' | sort -u
}

# Modules of src that programs reach, through the modules that these include, and the headers
# of tests.
reached() { # program.c...
    [ $# -gt 0 ] || return 0
    all=$(${CC:-gcc} -MM -MG -Isrc -Itests "$@" | grep -oE '(src/[a-z]+|tests/[a-z_]+\.h)' | sort -u)
    before=
    while [ "$all" != "$before" ]; do
        before=$all
        # shellcheck disable=SC2086 # one word a folder
        all=$({ echo "$all" && grep -rhoE '^#include "[a-z]+/' $(echo "$all" | grep ^src) /dev/null |
            sed 's|.*"|src/|; s|/$||'; } | sort -u)
    done
    echo "$all"
}

# What a transcript depends on: the files that its commands and their scripts name,
# and of the source the modules that its programs reach. The whole program has all
# but the modules aside that nothing names.
depends() {
    commands=$(sed -n 's/^\$ //p' "$1")
    files=$(echo "$commands" | named)
    scripts=$(echo "$files" | grep '\.sh$' | grep -v -E '/(run|last)\.sh$')
    # shellcheck disable=SC2086,SC2046 # one word a file
    [ -z "$scripts" ] || files=$(printf '%s\n' $files $(named $scripts) | sort -u)
    echo "$files" | grep -vxF "$1" # which a script may name
    if [ -n "$scripts" ] || echo "$commands" | grep -qE '(^|[ /|])winnow '; then
        # shellcheck disable=SC2086
        text=$commands$(cat $scripts /dev/null)
        echo src ':!src/distributed'
        echo "$text" | grep -q study || echo ':!src/study'
        # shellcheck disable=SC2086
        grep -qsE '^bodies|resolved|distance' $(echo "$files" | grep '^cases/.*cfg$') \
            /dev/null || echo ':!src/resolved'
    else
        # shellcheck disable=SC2046
        reached $(echo "$files" | grep '\.c$')
    fi
}

# The code in a file, without comments.
code() { # name
    case $1 in
    *.c | *.h) ${CC:-gcc} -fpreprocessed -dD -E -P "$1" 2>/dev/null ;;
    *.txt) cat "$1" ;;
    *) sed '/^ *#/d' "$1" ;;
    esac
}

# The numbers that short runs have of modules; all but those left out for src alone.
numbers_of() { # modules, with :!src/MODULE for what is left out
    awk -v modules="$1" '
    BEGIN {
        n = split(modules, r, /[ \n]+/)
        for (i = 1; i <= n; i++)
            if (sub(/^:!src\//, "", r[i])) out[r[i]]
            else if (sub(/^src\//, "", r[i])) in_[r[i]]
            else if (r[i] == "src") all = 1
    }
    /^\$ / { next }
    /^## / {
        shown = 0
        for (i = 2; i <= NF; i++) if ($i in in_ || (all && !($i in out))) shown = 1
    }
    shown' figures/short-runs.txt 2>/dev/null
}

# Sets sum to that of what the file depends on, and paths to the latter.
sum_up() { # file
    paths=$(depends "$1")
    numbers=$(numbers_of "$(echo "$paths" | grep -E '^(:!)?src')")
    [ -z "$numbers" ] || paths=$(echo "$paths" | grep -v -E '^(:!)?src')
    # shellcheck disable=SC2086 # one word a file
    sum=$({
        echo "$numbers"
        sed -n 's/^\$ //p' "$1"
        git ls-files -- figures/none $paths | while read -r name; do [ ! -f "$name" ] || code "$name"; done
    } | tr -d '[:space:]' | cksum | cut -d' ' -f1)
}

stamp() { # old new seconds
    revision=$(git rev-parse --short HEAD 2>/dev/null) || return
    sum_up "$1"
    # shellcheck disable=SC2086 # one word a file
    git diff --quiet HEAD -- figures/none $paths || revision=$revision+
    sed -i "1s/^# slow[^:]*/# slow, made at $revision in $3 s of $sum/" "$2"
}

# Sets seconds to the processor time of all that was run so far. (In a pipe or in
# $(...), times would be that of another shell.)
count_seconds() {
    times >"$work/times"
    seconds=$(awk 'NR == 2 { gsub(/[ms]/, " "); print int($1 * 60 + $2 + $3 * 60 + $4 + 0.5) }' \
        "$work/times")
}

took() { sed -n '1s/^# slow, made at [^ :]* in \([0-9]*\) s.*/\1/p' "$1"; }

# Whether it is cheap enough to try, and prints what it printed.
still_prints() {
    seconds=$(took "$1")
    [ -n "$seconds" ] && [ "$seconds" -le "$most" ] || return
    replay "$1" >"$new"
    same "$1" "$new"
}

age() {
    revision=$(sed -n '1s/^# slow, made at \([0-9a-f]*+\{0,1\}\).*/\1/p' "$1")
    sum_up "$1"
    head -1 "$1" | grep -q " of $sum\(:\|$\)" && return
    [ "$most" = 0 ] || ! still_prints "$1" || return 0
    if [ -z "$revision" ]; then
        echo "$1: made at a revision that it does not name"
    else
        echo "$1: made at $revision, and what it depends on has changed"
    fi
}

for file in "$@"; do
    grep -q '^\$ ' "$file" || continue
    if [ $mode = age ]; then
        if slow "$file"; then age "$file"; fi
        continue
    fi
    [ $# -gt 1 ] && slow "$file" && continue
    count_seconds
    before=$seconds
    replay "$file" >"$new"
    count_seconds
    if [ -s "$work/failed" ]; then
        sed -n "$(sed 's/$/p/' "$work/failed")" "$file" | sed "s|^\\$|$file stays as it is, because this fails:|" >&2
        failed=1
        continue
    fi
    lost=$(silent "$file" "$new")
    if [ $mode != check ] && [ -n "$lost" ]; then
        echo "$file stays as it was, because this prints nothing any more: $lost" >&2
        failed=1
        continue
    fi
    [ $mode = check ] || ! slow "$file" || stamp "$file" "$new" $((seconds - before))
    if same "$file" "$new"; then
        :
    elif [ $mode = check ]; then
        echo "$file is not what its commands print:"
        diff -u "$file" "$new" | head -12
        echo "sh chapters/tools/transcript.sh $file makes it again"
        failed=1
    else
        cat "$new" >"$file"
        echo "ran $file"
    fi
done
exit $failed
