/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "resolved/body_outline.h"

#include <math.h>
#include <stdlib.h>

const int body_outline_row[6] = {0, 0, 0, 1, 1, 2},
          body_outline_column[6] = {0, 1, 2, 1, 2, 2};

/* C = <(x - c)(x - c)^T>, and the moments over the mass are tr C - C. */
void body_outline_set_moments(struct body_outline *o, double V,
                              const double first[3], const double second[6])
{
    const int *const row = body_outline_row, *const column =
                                                 body_outline_column;
    double C[6];

    o->volume = V;
    for (int k = 0; k < 3; k++)
        o->centre[k] = first[k] / V;
    for (int e = 0; e < 6; e++)
        C[e] = second[e] / V - o->centre[row[e]] * o->centre[column[e]];
    const double trace = C[0] + C[3] + C[5];
    for (int e = 0; e < 6; e++)
        o->gyration[e] = (row[e] == column[e] ? trace : 0.0) - C[e];
}

void body_outline_free(struct body_outline *o)
{
    if (o == NULL || o->kept) return;
    free(o->ball);
    o->free(o);
}

int body_outline_spans(const struct body_outline *o, int k, double L, double h)
{
    double lo = HUGE_VAL, hi = -HUGE_VAL;

    for (int c = 0; c < 3 * o->n_triangles; c++) {
        lo = fmin(lo, o->corner[c / 3][c % 3][k]);
        hi = fmax(hi, o->corner[c / 3][c % 3][k]);
    }
    return hi - lo > L - 0.5 * h;
}
