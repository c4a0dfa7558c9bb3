#!/bin/sh
# Runs the commands of transcripts and puts their output below them.
#
#   sh chapters/tools/transcript.sh [-w WINNOW] [check] FILE...
#
# A transcript is a text file with lines that begin with "$ ": commands, run in
# the top folder, where `winnow` is the one that was built. What they print goes
# up to the next command or the next "## part". check compares instead, numbers
# to 1e-6 of their size, because two processors may differ in the last digits.
# A file that begins with "# slow" is compared only if it is the only one.
set -u
winnow=build/winnow
[ "${1:-}" = -w ] && winnow=$2 && shift 2
mode=write
[ "${1:-}" = check ] && mode=check && shift
PATH=$(cd "$(dirname "$winnow")" && pwd):$PATH
new=$(mktemp)
trap 'rm -f "$new"' EXIT
failed=0

replay() {
    awk '
    /^\$ / {
        print; fflush()
        command = substr($0, 3) " 2>&1"
        gap = 0
        while ((command | getline line) > 0) print line
        close(command)
        skip = 1
        next
    }
    /^## / { if (skip) print ""; skip = 0 }
    !skip' "$1"
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

for file in "$@"; do
    grep -q '^\$ ' "$file" || continue
    [ $# -gt 1 ] && head -1 "$file" | grep -q '^# slow' && continue
    replay "$file" >"$new"
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
