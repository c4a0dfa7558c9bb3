#!/bin/sh
# Draws the sketches of which a program knows the numbers: averages of one sphere, and beds
# to scale. The others stand as SVG, and are changed there.
#
#   sh figures/sketches/sketches.sh
set -eu
tools=figures/sketches
draw() { # figure, program, cases of beds
    figure=figures/${1%%-*}/$1.svg program=$tools/$2.awk
    shift 2
    awk -f $tools/svg.awk -f "$program" "${@:-/dev/null}" >"$figure"
}
draw 01-beds beds cases/small-bed.cfg cases/mueller-bed.cfg cases/packed-column.cfg
draw 08-one-sphere one-sphere
draw 30-beds beds cases/fluidization-ramp.cfg \
    diameter=1.775e-3 cases/fluidization-two-sizes.cfg diameter=1.42e-3 cases/seepage.cfg
draw 23-beds beds grains=512 diameter=1 cases/ew18-liquid.cfg \
    grains=2000 diameter=1 cases/ew18-gas.cfg
draw 27-beds beds cases/van-wachem-bed.cfg cases/goldschmidt-bed.cfg cases/spouted-bed.cfg
