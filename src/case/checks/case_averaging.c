/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/checks/case_averaging.h"

#include <math.h>
#include <stdio.h>

#include "averaging/averaging.h"
#include "case/build.h"
#include "case/case_mesh.h"
#include "case/checks/model_choice.h"

/* An average over more than that many lengths of the mesh is the same
 * everywhere, and images of images would be added up for ever [-]. */
static const double most_lengths = 10.0, most_widths = 100.0;

/* The cells of a second grid, at most [-]. */
static const double most_cells = 1e8;

static const int most_regions = 32; /* [-] */

/* The longest and the shortest side of the box around the mesh [m]. */
static void sides(const struct settings *s, double *longest, double *shortest)
{
    double lo[3], hi[3];

    case_mesh_ends(s, lo, hi);
    *longest = 0.0;
    *shortest = HUGE_VAL;
    for (int k = 0; k < 3; k++) {
        *longest = fmax(*longest, hi[k] - lo[k]);
        *shortest = fmin(*shortest, hi[k] - lo[k]);
    }
}

static int check_width(const struct settings *s, const char *key, double b)
{
    double longest, shortest;

    sides(s, &longest, &shortest);
    if (b > most_lengths * longest)
        return settings_wrong(s, key,
                              "%g m is more than %g times the mesh, which is "
                              "%g m long: the average would be the same "
                              "everywhere",
                              b, most_lengths, longest);
    if (b > most_widths * shortest)
        return settings_wrong(s, key,
                              "%g m is more than %g times the shortest side "
                              "of the mesh, %g m",
                              b, most_widths, shortest);
    return 0;
}

static int check_widths(const struct settings *s)
{
    const struct averaging_options *const o = &s->averaging;
    int code = check_width(s, "averaging.bandwidth", o->bandwidth);

    if (code == 0) code = check_width(s, "averaging.delta_05", o->delta_05);
    for (int i = 0; i < o->regions.n && code == 0; i++)
        code =
            check_width(s, "averaging.regions", o->regions.item[i].bandwidth);
    return code;
}

/* A second grid is as fine as its bandwidth. */
static int check_second_grid(const struct settings *s)
{
    const double b = s->averaging.bandwidth;
    double lo[3], hi[3], cells = 1.0;

    if (!s->averaging.method->has_own_grid) return 0;
    case_mesh_ends(s, lo, hi);
    for (int k = 0; k < 3; k++)
        cells *= fmax(1.0, floor((hi[k] - lo[k]) / b));
    if (cells <= most_cells) return 0;
    return settings_wrong(s, "averaging.bandwidth",
                          "a second grid of cells of %g m would have %.3g of "
                          "them; at most %g",
                          b, cells, most_cells);
}

static int case_averaging_check_given(const struct settings *s)
{
    const struct averaging_options *const o = &s->averaging;
    const int b = o->bandwidth > 0.0, delta = o->delta_05 > 0.0;

    if (delta && model_choice_unread(s, "averaging", "averaging.delta_05") != 0)
        return 2;
    if (o->regions.n > most_regions)
        return settings_wrong(s, "averaging.regions", "%d at most",
                              most_regions);
    if (b && delta)
        return settings_wrong(s, "averaging.delta_05",
                              "give either bandwidth or delta_05, not both");
    if (o->method->needs_bandwidth && !b && !delta)
        return settings_wrong(s, "averaging.method",
                              "%s needs averaging.bandwidth", o->method->name);
    return 0;
}

int case_averaging_check(const struct settings *s)
{
    int code = case_averaging_check_given(s);

    if (code == 0) code = check_widths(s);
    return code != 0 ? code : check_second_grid(s);
}
