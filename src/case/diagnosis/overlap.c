/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/diagnosis/overlap.h"

#include <stdio.h>
#include <stdlib.h>

#include "base/alloc.h"

static void other_name(const struct simulation *sim, int other, char *text,
                       size_t size)
{
    if (other >= 0)
        snprintf(text, size, "particle %d", other);
    else if (other > -7)
        snprintf(text, size, "the %s wall across %c",
                 (-1 - other) % 2 ? "upper" : "lower", 'x' + (-1 - other) / 2);
    else
        snprintf(text, size, "the wall \"%s\"", sim->surface_names[-7 - other]);
}

void overlap_describe(const struct simulation *sim, char text[OVERLAP_TEXT])
{
    const struct dem_overlap deep = dem_deepest(sim->dem);
    char other[128];

    other_name(sim, deep.other, other, sizeof other);
    snprintf(text, OVERLAP_TEXT,
             "particle %d and %s overlap by %.3g of their mean diameter, at "
             "[%g, %g, %g] m",
             deep.id, other, deep.depth, deep.at[0], deep.at[1], deep.at[2]);
}

int overlap_is_deeper(const struct simulation *sim)
{
    return sim->dem != NULL && dem_deepest(sim->dem).id >= 0;
}

void overlap_warn(int *told, const struct simulation *sim)
{
    char text[OVERLAP_TEXT];

    if (*told || !overlap_is_deeper(sim)) return;
    *told = 1;
    overlap_describe(sim, text);
    fprintf(stderr,
            "winnow: t = %g s: %s: more than %g (%s). That is more than the "
            "grains should have: try a stiffer material with a smaller "
            "particles.step, or give the key the overlap that is meant\n",
            sim->t, text, dem_deepest(sim->dem).expected,
            "particles.expected_overlap");
}
