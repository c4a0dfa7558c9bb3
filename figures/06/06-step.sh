#!/bin/sh
# How far a steady pressure depends on the time step: with Winnow's flux through
# a face, with the storage of momentum interpolated from the cells, and with
# plain linear interpolation.
. "$(dirname "$0")/../here.sh"
one() {
    sh figures/run.sh figures/06/06-step.c $2 | sed "s/difference/$1/"
}
one winnow ''
one cell_storage chapters/solutions/06-3.patch
one linear_flux chapters/solutions/06-linear-flux.patch
