#!/bin/sh
# Remakes the slow transcripts and what is drawn from them, and says what moved.
#
#   sh chapters/tools/figures.sh build/winnow [figures/25/25-NAME.txt]...
#
# Those that were made from what is there now are skipped, so that a run that was
# interrupted goes on where it stopped; figures that are named are made anyway.
# What took the least processor time the last time comes first.
# The table has a line for each transcript: how many of its numbers changed, and
# the largest change of one, relative to its size. A command that ends with an
# error leaves its transcript as it was. SECONDS_EACH limits what one may take.
set -u
winnow=${1:-build/winnow}
tools=$(dirname "$0")
[ $# -gt 0 ] && shift
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
table=$work/table
: >"$table"

transcript() { sh "$tools/transcript.sh" -w "$winnow" "$@"; }

# moved OLD NEW: numbers that differ, word by word; lines that came or went.
moved() {
    awk '
    function number(s) { return s ~ /^[-+]?[0-9]*[.]?[0-9]+(e[-+]?[0-9]+)?$/ }
    FNR == NR { old[FNR] = $0; lines = FNR; next }
    {
        if (FNR == 1 && /^# slow/) next
        n = split($0, a, /[ \t,()=]+/); m = split(old[FNR], b, /[ \t,()=]+/)
        if (n != m) { words++; next }
        for (i = 1; i <= n; i++) {
            if (a[i] == b[i]) continue
            if (!number(a[i]) || !number(b[i])) { words++; continue }
            numbers++
            d = a[i] - b[i]; d = d < 0 ? -d : d
            size = b[i] < 0 ? -b[i] : b[i] + 0
            if (size > 0 && d / size > most) most = d / size
        }
    }
    END {
        if (FNR != lines) words += FNR > lines ? FNR - lines : lines - FNR
        if (numbers + words == 0) print "as it was"
        else printf "%d numbers, at most by %.2g of their size; %d other words or lines\n",
                    numbers, most, words
    }' "$1" "$2"
}

remake() { # file
    cp "$1" "$work/old"
    start=$(date +%s)
    timeout "${SECONDS_EACH:-3600}" sh "$tools/transcript.sh" -w "$winnow" "$1" \
        >"$work/said" 2>&1
    code=$?
    took=$(($(date +%s) - start))
    if [ $code != 0 ]; then
        cp "$work/old" "$1"
        printf '%-28s not made: exit code %d after %d s\n' "$1" $code $took
    else
        printf '%-28s %s\n' "$1" "$(moved "$work/old" "$1")"
        echo "$1 $took s" >&2
    fi
}

# What gnuplot draws from a transcript says so: it names the file, if only in the
# comment at its top.
draw() { # file
    for script in $(grep -l "${1##*/}" figures/*/*.gp); do
        gnuplot "$script" >"$work/said" 2>&1 ||
            printf '%-28s not drawn: %s\n' "$script" "$(tail -1 "$work/said")"
    done
}

chosen=$*
if [ -z "$chosen" ]; then
    chosen=$(transcript age figures/*.txt figures/*/*.txt | cut -d: -f1 | while read -r file; do
        echo "$(sed -n '1s/^# slow, made at [^ :]* in \([0-9]*\) s.*/\1/p' "$file") $file"
    done | awk '{ print NF == 2 ? $1 : 1e6, $NF }' | sort -n | cut -d' ' -f2)
fi
# shellcheck disable=SC2086 # one word a file
set -- $chosen
total=$#
n=0
for file in "$@"; do
    n=$((n + 1))
    echo "[$n/$total] $file" >&2
    remake "$file" >>"$table"
    ! command -v gnuplot >/dev/null || draw "$file" >>"$table"
done
echo "figures: $total made anew"
cat "$table"
