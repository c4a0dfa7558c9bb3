#!/bin/sh
# Makes the moving pictures of figures/gallery.txt, figures/gallery/CASE.webp, and from
# that table the rows of chapters/gallery.md, each with what its run took here. Asks for
# pvpython and xvfb-run (Debian: paraview xvfb) and for img2webp (webp).
#
#   sh figures/gallery.sh build [CASE...]      only these; the page is written anyway
set -eu
build=$1
shift
for program in pvpython xvfb-run img2webp; do
    command -v $program >/dev/null || {
        echo "gallery: no $program here: apt-get install paraview xvfb webp" >&2
        exit 1
    }
done
start=$(date +%s)
most=150000 # bytes of a picture
page=chapters/gallery.md
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p figures/gallery

make() { # case, options of the run, of the view
    # shellcheck disable=SC2086 # several words
    "$build/winnow" run "cases/$1.cfg" -o "$work/$1" --quiet $2 &&
        xvfb-run -a -s -noreset pvpython figures/view.py "$work/$1" "$work/$1/film.png" film=1 $3
} >"$work/said" 2>&1 || { cat "$work/said" >&2; exit 1; }

seconds() { # of one core, of the run that is there or of the page as it was
    if [ -e "$work/$1/summary.json" ]; then
        sed -n 's/.*"processor": \([0-9.]*\).*/\1/p' "$work/$1/summary.json" | xargs printf '%.0f'
    else
        sed -n "\\|gallery/$1.webp|,/seconds of/s/^\\([0-9]*\\) seconds of.*/\\1/p" $page
    fi
}

sed '/^<!-- rows -->/q' $page >"$work/page"
grep -v '^#' figures/gallery.txt | sed 's/ *| */|/g' | while IFS='|' read -r name run view chapter what; do
    case " ${*:-$name} " in *" $name "*)
        make "$name" "$run" "$view"
        # Each a tenth of a second, the last one two seconds; fewer colours if it gets too large.
        last=$(find "$work/$name" -name 'film.*.png' | LC_ALL=C sort | tail -n 1)
        for quality in 60 45 30 20; do
            # shellcheck disable=SC2046 # a word each
            img2webp -loop 0 -lossy -q $quality -m 6 -d 100 $(find "$work/$name" -name 'film.*.png' | LC_ALL=C sort) \
                -d 1500 "$last" -o "figures/gallery/$name.webp" >/dev/null
            [ "$(wc -c <"figures/gallery/$name.webp")" -gt $most ] || break
        done
        [ "$(wc -c <"figures/gallery/$name.webp")" -le $most ] || { echo "$name: more than $most bytes" >&2; exit 1; }
        echo "$name: $(seconds "$name") s, $(wc -c <"figures/gallery/$name.webp") bytes" >&2 ;;
    esac
    {
        printf '\n## %s\n\n' "$(sed -n 's/^title = "\(.*\)";.*/\1/p' "cases/$name.cfg")"
        printf '![%s](../figures/gallery/%s.webp)\n\n' "$name" "$name"
        printf '%s\n\n    build/winnow run cases/%s.cfg%s\n\n' "$what" "$name" "${run:+ $run}"
        printf '%s seconds of a core. More: [%s](%s).\n' "$(seconds "$name")" \
            "$(sed -n 's/^# \([0-9]* \)*//p' "chapters/$chapter" | head -n 1)" "$chapter"
    } >>"$work/page"
done
cp "$work/page" $page
echo "gallery: $(($(date +%s) - start)) s"
