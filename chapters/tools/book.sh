#!/bin/sh
# Renders the book: build/book/index.html. Asks for pandoc.
#
#   sh chapters/tools/book.sh [build/book [plain]]
#
# In plain pages, of which only links and form are looked at, no step runs.
set -eu
out=${1:-build/book}
plain=${2:-}
tools=$(cd "$(dirname "$0")" && pwd)
anchors=$out/anchors.txt functions=$out/functions.txt plan=$out/plan.txt
steps=
[ ! -d chapters/steps ] || steps=chapters/steps
# The pages in the order of the plan, README.md; then what it does not name.
pages=$({
    sed -n 's/^| \[[^]]*\](\([^)]*[.]md\)).*/chapters\/\1/p' chapters/README.md
    find chapters -name '*.md' ! -path '*/solutions/*' ! -path '*/steps/*' \
        ! -path chapters/README.md | LC_ALL=C sort
} | awk '!seen[$0]++ { print }
    /steps\/README/ { while (("ls chapters/steps/step-*.md" | getline step) > 0) print step }')

command -v pandoc >/dev/null || { echo "book: asks for pandoc" >&2; exit 1; }
rm -rf "$out"
mkdir -p "$out/figures"
cp "$tools/book.css" "$tools/live.js" "$tools/book.js" "$tools/math.woff2" "$tools/math-licence.txt" "$out"
find figures -name '*.svg' -o -name '*.png' -o -name '*.webp' | while read -r figure; do
    mkdir -p "$out/${figure%/*}" && cp "$figure" "$out/$figure"
done

name() { case $1 in */steps/README.md) echo steps ;; *) basename "$1" .md ;; esac; }
title() { sed -n 's/^# //p' "$1" | head -1; }

# What may be linked to by its name, and on which page it is.
for page in $pages; do
    html=$(name "$page").html
    sed -n "s/.*\\\\tag{\\([0-9a-z.]*\\)}.*/(\\1) $html/p" "$page"
    sed -n "s/.*<a id=\"\\([A-Za-z0-9-]*\\)\">.*/\\1 $html/p" "$page"
    case $html in [0-9]*) # 09-drag is Chapter 9, and Chapter "Drag"
        echo "$html" | sed 's/^0*\([0-9]*\)-.*/Chapter-\1 &/'
        title "$page" | sed "s/^[0-9]* //; s/:.*//; s/ /-/g; s/.*/Chapter-& $html/" ;;
    esac
done >"$anchors"

# Where each function is defined, and what stands at the side of each page.
# shellcheck disable=SC2046 # one word a file
awk -f "$tools/c.awk" -f /dev/stdin $(find src -name '*.c' | LC_ALL=C sort) >"$functions" <<'END'
FNR == 1 {
    cut(FILENAME)
    for (i = 1; i <= items[FILENAME]; i++)
        if (kind[FILENAME, i] == "function") print name[FILENAME, i], FILENAME
}
END
sed -n 's/^## \(Course\|Manual\|Journal\)$/part \1/p; s/^### \(.*\)/group \1/p
    s/^| \[[^]]*\](\([^)]*[.]md\)).*/chapters\/\1/p' chapters/README.md |
    while read -r line; do
        case $line in chapters/*) ;; *) echo "$line" && continue ;; esac
        echo "page $(name "$line") $(title "$line")"
        case $line in */steps/README.md) for step in chapters/steps/step-*.md; do
            echo "page $(name "$step") $(title "$step")"
        done ;; esac
    done >"$plan"

render() { # page, page before, page after
    [ ! -f "$out/$(name "$1").html" ] ||
        { echo "book: $1: a page of this name is there already" >&2; exit 1; }
    case $(name "$1") in [0-9]*) toc=1 ;; *) toc= ;; esac
    # What cannot be woven, weave.sh has said.
    awk -v places=1 -f "$tools/c.awk" -f "$tools/show.awk" -f "$tools/weave.awk" \
        "$1" 2>/dev/null |
        pandoc -f gfm+tex_math_dollars -t html5 --standalone --mathml --wrap none --no-highlight \
            --template "$tools/page.html" --toc --toc-depth 2 \
            --lua-filter "$tools/cite.lua" \
            --lua-filter "$tools/book.lua" -M anchors="$anchors" \
            ${toc:+-V page_toc=1} \
            -V page="$(name "$1")" -M pagetitle="$(title "$1")" \
            ${2:+-V before="$(name "$2")" -V before_title="$(title "$2")"} \
            ${3:+-V after="$(name "$3")" -V after_title="$(title "$3")"} |
        awk -f "$tools/tidy.awk" |
        awk -v anchors="$anchors" -v functions="$functions" -f "$tools/colour.awk" -f "$tools/listing.awk" |
        awk -v plan="$plan" -v page="$(name "$1")" -f "$tools/side.awk" >"$out/$(name "$1").html"
    case $1 in */step-*) sh "$tools/live.sh" "$out/$(name "$1").html" "$anchors" "$plain" ;; esac
}

# The contents: README.md up to what is for authors, each row of a table as a link to a
# page, with its question and the times to read and to run; then all other pages.
contents() {
    echo "# Winnow"
    echo
    sed '/^## Models/,$d; /^## Commands/,$d; /^# /d' chapters/README.md >"$out/contents"
    while IFS= read -r line; do
        case $line in '|'*) ;; *) printf '%s\n' "$line"; continue ;; esac
        for page in $pages; do
            case $line in "| [$(name "$page")]"* | "| $(name "$page") "*)
                entry "$page" "$line" ;;
            esac
        done
    done <"$out/contents"
    echo
    for page in $pages; do
        case $page in */step-*) continue ;; esac # steps.html names them
        grep -q -E "^[|] [[]?$(name "$page")[] ]" "$out/contents" || entry "$page" ""
    done
    rm "$out/contents"
}

entry() { # page, its row: | page | question | read | run | source |
    printf -- '- [%s](%s.md)' "$(title "$1")" "$(name "$1")"
    echo "$2" | awk -F' *[|] *' '{
        if ($3 != "") printf "<br>%s", $3
        if (NF > 5) printf " (%s to read, %s to run)", $4, $5
        print "" }'
}

contents >"$out/index.md"
render "$out/index.md" "" ""
rm "$out/index.md"

for page in chapters/solutions/*.md; do render "$page" "" ""; done
before=
set -- $pages
while [ $# -gt 0 ]; do
    render "$1" "$before" "${2:-}"
    before=$1
    shift
done

files=$out/files.txt
# shellcheck disable=SC2086 # none or one
find src tests cases figures chapters/solutions $steps -name '*.[ch]' -o -name '*.cfg' \
    -o -name '*.sh' -o -name '*.gp' -o -name '*.txt' -o -name '*.py' \
    -o -name '*.patch' >"$files"
sed "s|^|$out/|; s|/[^/]*\$||" "$files" | sort -u | xargs mkdir -p
awk -v anchors="$anchors" -v functions="$functions" -v out="$out" -f "$tools/c.awk" \
    -f "$tools/colour.awk" -f "$tools/source.awk" "$files"
(cd "$out" && awk -v functions="${functions##*/}" -f "$tools/colour.awk" -f "$tools/search.awk" ./*.html >search.js)
rm "$files" "$anchors" "$functions" "$plan"
cd "$out"
find . -type f | awk -f "$tools/pages.awk"
echo "book: $out/index.html"
