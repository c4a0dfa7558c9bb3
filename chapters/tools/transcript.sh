#!/bin/sh
# Runs the commands of transcripts and puts their output below them.
#
#   sh chapters/tools/transcript.sh [-w WINNOW] [check|age] FILE...
#
# A transcript is a text file with lines that begin with "$ ": commands, run in
# the top folder, where `winnow` is the one that was built. What they print goes
# up to the next command or the next "## part"; lines "## part" that a command
# prints itself belong to its output. check compares instead, numbers to 1e-6 of
# their size, because two processors may differ in the last digits.
#
# A file that begins with "# slow" is compared only if it is the only one. Its
# first line keeps the revision it was made at: "# slow, made at 1234abc: reason",
# with a "+" after the revision if what it depends on was changed since then. age
# names the slow ones that were made before the last change of what they depend
# on: the source, and the files that their commands name.
set -u
winnow=build/winnow
[ "${1:-}" = -w ] && winnow=$2 && shift 2
mode=write
case ${1:-} in check | age) mode=$1 && shift ;; esac
PATH=$(cd "$(dirname "$winnow")" && pwd):$PATH
new=$(mktemp)
trap 'rm -f "$new"' EXIT
failed=0

# The first reading notes which parts have a command of their own. Of those that
# have none, the ones below a command that prints parts are its old output.
replay() {
    awk '
    NR == FNR {
        if (/^## /) part = FNR
        else if (/^\$ / && part) own[part] = 1
        next
    }
    /^\$ / {
        print; fflush()
        command = substr($0, 3) " 2>&1"
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

slow() { head -1 "$1" | grep -q '^# slow'; }

# What a transcript depends on: the source, the files that its commands name but
# for pictures, which they make, and the program whose name program.sh is given.
depends() {
    echo src
    sed -n 's/^\$ //p' "$1" | sed 's|program\.sh \([^ ]*\)|program.sh figures/\1.c|' |
        grep -oE '(figures|cases|chapters/tools|tests/bench)/[A-Za-z0-9_.-]+' |
        grep -v -E '\.(svg|png)$' | sort -u
}

made_at() { sed -n '1s/^# slow, made at \([0-9a-f]*+\{0,1\}\).*/\1/p' "$1"; }

# unchanged FILE REVISION: what the file depends on is what it was then.
unchanged() {
    # shellcheck disable=SC2046 # one word a file
    git diff --quiet "$2" -- $(depends "$1") 2>/dev/null
}

stamp() {
    revision=$(git rev-parse --short HEAD 2>/dev/null) || return
    unchanged "$1" HEAD || revision=$revision+
    sed -i "1s/^# slow\(, made at [0-9a-f]*+\{0,1\}\)\{0,1\}/# slow, made at $revision/" "$2"
}

age() {
    revision=$(made_at "$1")
    if [ -z "$revision" ]; then
        echo "$1: made at a revision that it does not name"
    elif [ "${revision%+}" != "$revision" ] || ! unchanged "$1" "$revision"; then
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
    replay "$file" >"$new"
    [ $mode = check ] || ! slow "$file" || stamp "$file" "$new"
    if same "$file" "$new"; then
        :
    elif [ $mode = check ]; then
        echo "$file is not what its commands print:"
        diff -u "$file" "$new"
        failed=1
    else
        cat "$new" >"$file"
        echo "ran $file"
    fi
done
exit $failed
