/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fluid/fluid.h"

#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "mesh/mesh.h"
#include "boxes.h"
#include "facts.h"

/* left: a wall that moves along y; right: slip; bottom: inlet; top: outlet;
 * back and front: no-slip at rest. */
static void fill_boundaries(const struct mesh *m, struct boundary b[6])
{
    static const double zero = 0.0, speed = 0.9;

    for (int i = 0; i < m->n_patches; i++) {
        const char *const name = m->patches[i].name;
        b[i].kind = BOUNDARY_NO_SLIP;
        if (strcmp(name, "left") == 0) b[i].wall[1] = 3.0;
        if (strcmp(name, "right") == 0) b[i].kind = BOUNDARY_SLIP;
        if (strcmp(name, "top") == 0) b[i].kind = BOUNDARY_OUTLET;
        if (strcmp(name, "bottom") != 0) continue;
        b[i].kind = BOUNDARY_INLET;
        b[i].n_points = 1;
        b[i].time = &zero;
        b[i].velocity = &speed;
    }
}

/* u = (1, 2, 4) in all cells; the inlet's flux is 0.9 a square metre, and the
 * fluid fraction is 0.6: 1.5 m/s. */
FACT(each_kind_of_side_has_its_velocity)
{
    static const double expected[6][3] = {{0.0, 3.0, 0.0}, {0.0, 2.0, 4.0},
                                          {0.0, 1.5, 0.0}, {1.0, 2.0, 4.0},
                                          {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
    static const char *const name[6] = {"left", "right", "bottom",
                                        "top",  "back",  "front"};
    struct mesh *const m = closed_box(1.0, 2.0, 1.0, 2, 3, 2);
    struct boundary b[6] = {{0}};
    const struct fluid_options o = {.rho = 1.2,
                                    .mu = 1.8e-5,
                                    .dt = 1e-3,
                                    .convection =
                                        convection_scheme_named("upwind"),
                                    .correctors = 2,
                                    .tolerance = 1e-8,
                                    .coupled = 1,
                                    .boundaries = b};
    fill_boundaries(m, b);
    struct fluid *const fl = fluid_create(m, &o);
    double *const u_b = alloc_doubles(3 * (m->n_faces - m->n_internal));

    for (int c = 0; c < m->n_cells; c++) {
        fl->eps[c] = 0.6;
        fl->u[3 * c] = 1.0;
        fl->u[3 * c + 1] = 2.0;
        fl->u[3 * c + 2] = 4.0;
    }
    const struct patch *const bottom = mesh_patch(m, "bottom");
    for (int f = bottom->first; f < bottom->first + bottom->n; f++)
        fl->phi[f] = 0.9 * mesh_S(m, f)[1]; /* S points down: a flux inward */
    fluid_boundary_velocity(fl, u_b);
    for (int i = 0; i < 6; i++) {
        const struct patch *const p = mesh_patch(m, name[i]);
        for (int f = p->first; f < p->first + p->n; f++)
            for (int k = 0; k < 3; k++)
                ck_assert_double_eq_tol(u_b[3 * (f - m->n_internal) + k],
                                        expected[i][k], 1e-14);
    }
    free(u_b);
    owner_free(fl);
    mesh_free(m);
}
