/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/case_overlap.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "case/case_part.h"

static const char expected[] = "particles.expected_overlap";

void case_overlap_limit(const struct settings *s, struct simulation *sim)
{
    const double most = settings_real(s, "particles.max_overlap");

    dem_limit_overlap(sim->dem, fmin(settings_real(s, expected), most), most);
}

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

void case_overlap_describe(const struct simulation *sim,
                           char text[CASE_OVERLAP_TEXT])
{
    const struct dem_overlap deep = dem_deepest(sim->dem);
    char other[128];

    other_name(sim, deep.other, other, sizeof other);
    snprintf(text, CASE_OVERLAP_TEXT,
             "particle %d and %s overlap by %.3g of their mean diameter, at "
             "[%g, %g, %g] m",
             deep.id, other, deep.depth, deep.at[0], deep.at[1], deep.at[2]);
}

void case_overlap_warn(const struct simulation *sim, int *told)
{
    char text[CASE_OVERLAP_TEXT];

    if (*told || sim->dem == NULL || dem_deepest(sim->dem).id < 0) return;
    *told = 1;
    case_overlap_describe(sim, text);
    fprintf(stderr,
            "winnow: t = %g s: %s: more than %g (%s). That is more than the "
            "grains should have: try a stiffer material with a smaller "
            "particles.step, or give the key the overlap that is meant\n",
            sim->t, text, dem_deepest(sim->dem).expected, expected);
}

/* The key exists where a part of the case has it. */
double case_overlap_in_wall(const struct settings *s)
{
    static const char key[] = "particles.overlaps";

    for (int i = 0; case_parts[i] != NULL; i++)
        for (const struct key *k = case_parts[i]->keys;
             k != NULL && k->path != NULL; k++)
            if (strcmp(k->path, key) == 0 &&
                strcmp(settings_text(s, key), "allow") == 0)
                return 0.5;
    return 0.01;
}
