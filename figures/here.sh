# The first line of the scripts of figures/, which read it: they work in the top folder, where
# `winnow` is that of this tree's build (or of the folder $BUILD); $work is a folder that is
# gone at the end; and a script that stops early says so.
set -eu
cd "$(dirname "$0")/../.."
[ -x "${BUILD:-build}/winnow" ] || { echo "$0: there is no build/winnow; type make" >&2; exit 1; }
PATH=$(cd "${BUILD:-build}" && pwd):$PATH
work=$(mktemp -d)
trap 'code=$?; rm -rf "$work"; [ $code -eq 0 ] || echo "$0: stopped, exit code $code" >&2' EXIT
