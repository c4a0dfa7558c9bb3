# The first line of the scripts of figures/, which read it: they work in the top folder, where
# `winnow` is that of this tree's build (or of the folder $BUILD); $work is a folder that is
# gone at the end; and a script that stops early says so.
set -eu
cd "$(dirname "$0")/../.."
[ -x "${BUILD:-build}/winnow" ] || { echo "$0: there is no build/winnow; type make" >&2; exit 1; }
PATH=$(cd "${BUILD:-build}" && pwd):$PATH
work=$(mktemp -d)
trap 'code=$?; rm -rf "$work"; [ $code -eq 0 ] || echo "$0: stopped, exit code $code" >&2' EXIT

# Columns of a table of a run, by their names.
columns() { # FILE NAME...
    from=$1
    shift
    awk -F, -v wanted="$*" '
        NR == 1 { n = split(wanted, want, " "); for (i = 1; i <= NF; i++) { split($i, w, " "); at[w[1]] = i }; next }
        { for (k = 1; k <= n; k++) printf "%s%s", $at[want[k]], k < n ? " " : "\n" }' "$from"
}
# A number of a run's summary.
summary() { sed -n "s/^.*\"$2\": \([^,]*\).*/\1/p" "$1/summary.json"; } # FOLDER KEY
