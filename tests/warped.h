/* SPDX-License-Identifier: GPL-3.0-or-later */
/* warped.h -- a mesh of bent faces, for tests. */
#ifndef WARPED_H
#define WARPED_H

#include "cloud.h"
#include "mesh/poly/poly.h"

#include <check.h>

/* A box whose inner points are moved at random by up to a quarter of a cell:
 * most faces are warped. */
static inline struct mesh *warped(void)
{
    struct poly_raw r = {0};
    uint64_t state = 5;

    ck_assert_int_eq(poly_raw_read(&r, "tests/data/poly/sheared"), 0);
    for (int i = 0; i < r.n_points; i++) {
        double *const x = &r.point[3 * i];
        const double along = x[0] - 0.4 * x[1];
        const int inner = along > 1e-6 && along < 1.0 - 1e-6 && x[1] > 1e-6 &&
                          x[1] < 1.0 - 1e-6 && x[2] > 1e-6 && x[2] < 0.5 - 1e-6;
        for (int k = 0; k < 3 && inner; k++)
            x[k] += 0.11 * (cloud_random(&state) - 0.5);
    }
    struct mesh *const m = poly_build(&r, "warped");
    ck_assert_ptr_nonnull(m);
    poly_raw_release(&r);
    return m;
}

#endif
