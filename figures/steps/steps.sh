#!/bin/sh
# The pictures of the thirteen steps on one page, figures/steps/steps.png. Asks for
# rsvg-convert (Debian: librsvg2-bin) and montage (imagemagick).
#
#   make steps && sh figures/steps/steps.sh
. "$(dirname "$0")/../here.sh"
for program in chapters/steps/*.c; do
    name=$(basename "$program" .c)
    cp "build/steps/$name" "$work"
    "$work/$name" >"$work/said"
    rsvg-convert -w 560 -h 380 --keep-aspect-ratio --background-color white \
        "$work/$name.svg" -o "$work/$name.png"
done
montage -font "$(fc-match -f '%{file}' sans)" -label '%t' "$work"/*.png -tile 3x5 -geometry 330x226+8+4 -pointsize 13 \
    +dither -colors 32 PNG8:figures/steps/steps.png
