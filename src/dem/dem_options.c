/* SPDX-License-Identifier: GPL-3.0-or-later */
/* dem_options.c -- what is told about the ways to find the pairs. */
#include "dem/dem_options.h"

#include <stddef.h>

static const struct key skin_keys[] = {
    {"particles.skin", KEY_REAL, "m", "auto | > 0", "auto",
     "margin of the neighbour list beyond touching", "LS 5.15", ""},
    KEY_END};

const struct model dem_options_verlet = {
    .name = "verlet",
    .what = "pairs up to a skin apart, kept until they have moved it",
    .equations = "LS 5.15, 5.16",
    .function = "neighbours_refresh",
    .keys = {skin_keys},
    .value = 0,
};

const struct model dem_options_link_cells = {
    .name = "link-cells",
    .what = "pairs of neighbouring cells, sought in each step",
    .equations = "LS section 5.2.2",
    .function = "grid_find",
    .value = 1,
};
