/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/box_domain.h"

struct box_domain box_domain_of(const double lo[3], const double hi[3],
                                const int periodic[3])
{
    struct box_domain box;

    for (int k = 0; k < 3; k++) {
        box.lo[k] = lo[k];
        box.hi[k] = hi[k];
        box.periodic[k] = periodic[k];
        box.length[k] = periodic[k] ? hi[k] - lo[k] : 0.0;
        box.inverse[k] = periodic[k] ? 1.0 / (hi[k] - lo[k]) : 0.0;
    }
    return box;
}

double box_domain_inside(const struct box_domain *box, int k, double x)
{
    return x - box->length[k] * floor((x - box->lo[k]) * box->inverse[k]);
}
