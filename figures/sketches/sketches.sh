#!/bin/sh
# Draws the sketches: what contacts, steps, averages, facets and beds look like.
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
draw 02-kinematics kinematics
draw 08-one-sphere one-sphere
draw 10-step step
draw 14-facet facet
draw 30-beds beds cases/fluidization-ramp.cfg \
    diameter=1.775e-3 cases/fluidization-two-sizes.cfg diameter=1.42e-3 cases/seepage.cfg
draw 23-beds beds grains=512 diameter=1 cases/ew18-liquid.cfg \
    grains=2000 diameter=1 cases/ew18-gas.cfg
draw 27-beds beds cases/van-wachem-bed.cfg cases/goldschmidt-bed.cfg cases/spouted-bed.cfg
