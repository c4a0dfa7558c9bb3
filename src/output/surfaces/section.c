/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/surfaces/section.h"

#include "base/number.h"

/* The points where the sides of a polygon cross the plane; a convex one has two
 * of them, or none. */
static int section_cross(const struct outline *o, int first, int end, double z,
                         double at[2][2])
{
    int n = 0;

    for (int i = first; i < end && n < 2; i++) {
        const double *const a = &o->x[3 * i];
        const double *const b = &o->x[3 * (i + 1 < end ? i + 1 : first)];
        const double u = a[2] - z, v = b[2] - z;
        if ((u >= 0.0) == (v >= 0.0)) continue;
        for (int k = 0; k < 2; k++)
            at[n][k] = a[k] + u / (u - v) * (b[k] - a[k]);
        n++;
    }
    return n;
}

void section_write(FILE *out, const struct outline *o, double z)
{
    char x[NUMBER_LENGTH], y[NUMBER_LENGTH];
    double at[2][2];
    int first = 0;

    for (int p = 0; p < o->n_polygons; first = o->end[p++]) {
        if (section_cross(o, first, o->end[p], z, at) < 2) continue;
        for (int i = 0; i < 2; i++)
            fprintf(out, "%s %s\n", number_rounded(at[i][0], 6, x),
                    number_rounded(at[i][1], 6, y));
        fputc('\n', out);
    }
}
