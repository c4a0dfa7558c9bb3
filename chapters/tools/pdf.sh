#!/bin/sh
# The course as one PDF, from its rendered pages. Asks for Chromium.
#
#   sh chapters/tools/pdf.sh build/book.plain build/course.pdf
set -eu
book=$(cd "$1" && pwd) pdf=$2
. "$(dirname "$0")/chromium.inc"
[ -n "$browser" ] || { echo "pdf: asks for Chromium (apt-get install chromium)" >&2; exit 1; }
all=$book/all.html
trap 'rm -rf "$all" "$all.profile"' EXIT
# The pages of the course, in the order of its contents.
pages=$(sed -n '/<summary>Course/,/<\/details>/s/^<li><a href="\([^"]*\)[.]html".*/\1/p' "$book/index.html")
pages=$(for page in $pages; do
    echo "$page"
    [ "$page" != steps ] || (cd "$book" && ls step-*.html | sed 's/[.]html//')
done)
{
    echo '<!DOCTYPE html><html lang="en"><head><meta charset="utf-8" />'
    echo '<title>Winnow: the course</title><link rel="stylesheet" href="book.css" />'
    echo '</head><body class="book"><h1>Winnow: the course</h1><ul>'
    for page in $pages; do
        sed -n "s/.*<title>\(.*\)<\/title>.*/<li><a href=\"#$page\">\1<\/a><\/li>/p" "$book/$page.html"
    done
    echo '</ul>'
    for page in $pages; do
        # Links lead to places in this file; what is not in it is no link.
        echo "<article id=\"$page\">"
        awk -v page="$page" -v pages="$pages" '
            BEGIN { n = split(pages, w, " "); for (i = 1; i <= n; i++) known[w[i]] }
            function to(address,    p) {
                if (address ~ /^[a-z]+:/) return address
                if (address ~ /^#/) return "#" page "--" substr(address, 2)
                p = address
                sub(/[.]html.*/, "", p)
                if (!(p in known)) return ""
                return "#" p (index(address, "#") ? "--" substr(address, index(address, "#") + 1) : "")
            }
            /^<main>/ { within = 1; next }
            /^<\/main>/ { exit }
            !within { next }
            {
                gsub(/ id="/, "&" page "--")
                done = ""
                while (match($0, / href="[^"]*"/)) {
                    place = to(substr($0, RSTART + 7, RLENGTH - 8))
                    done = done substr($0, 1, RSTART - 1) (place == "" ? "" : " href=\"" place "\"")
                    $0 = substr($0, RSTART + RLENGTH)
                }
                print done $0
            }' "$book/$page.html"
        echo '</article>'
    done
    echo '</body></html>'
} >"$all"
"$browser" --headless --no-sandbox --disable-gpu --user-data-dir="$all.profile" \
    --allow-file-access-from-files --no-pdf-header-footer --virtual-time-budget=60000 \
    --print-to-pdf="$pdf" "file://$all" >/dev/null 2>&1 || true
[ -s "$pdf" ] || { echo "pdf: the browser made none" >&2; exit 1; }
echo "pdf: $pdf, $(grep -ac '/Type /Page$' "$pdf") pages"
