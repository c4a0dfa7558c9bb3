/* SPDX-License-Identifier: GPL-3.0-or-later */
/* 24-gaps.c -- what mesh and film do in a narrow gap, over the exact force. */
#include <stdio.h>

#include "brenner.h"
#include "facts.h"
#include "resolved.h"
#include "resolved/squeeze_film.h"

enum { N = 8 }; /* cells in the diameter, 1 m */

static const double R = 0.5, h = 1.0 / N, U = 1e-6, mu = 1.0;

/* Force of the fluid on one sphere above a floor, or on one of two, `shift`
 * cells from where the cells are symmetric, over 6 pi mu R U. */
static double of_mesh(double z, int of_two, double shift)
{
    const struct pool_options o = {
        .size = {of_two ? 4.0 : 3.0, 3.0, 3.0},
        .cells = {(of_two ? 4 : 3) * N, 3 * N, 3 * N},
        .walls = {0, !of_two, 0},
        .rho = 1.0,
        .mu = mu,
        .dt = h * h,
        .virtual_mass = 2.0,
        .tolerance = 1e-6,
        .n = 2};
    const struct body_shape sphere = body_shape_sphere(2.0 * R);
    struct pool p;

    pool_create(&p, &o);
    for (int i = 0; i < 1 + of_two; i++) {
        const double sign = i == 0 ? -1.0 : 1.0;
        const double two[3] = {2.0 + shift * h + sign * (R + 0.5 * z), 1.5,
                               1.5},
                     one[3] = {1.5 + shift * h, R + z, 1.5};
        solid_bodies_add(p.bodies, &sphere, of_two ? two : one, 1.0,
                         BODY_PRESCRIBED);
        p.bodies->ps->vx[i] = of_two ? -sign * U : 0.0;
        p.bodies->ps->vy[i] = of_two ? 0.0 : -U;
    }
    if (solid_bodies_begin(p.bodies, p.fluid) != 0) return 0.0;
    for (int i = 0; i < 25; i++)
        if (fluid_step(p.fluid) != 0 ||
            body_motion_advance(p.bodies, p.fluid->options.dt) != 0)
            return 0.0;
    const double F = of_two ? -p.bodies->force[0] : p.bodies->force[1];
    pool_free(&p);
    return F / (6.0 * M_PI * mu * R * U);
}

static void row(double cells, int of_two, double shift)
{
    static const double reach[3] = {2.0, 1.0, 0.75};
    const double z = cells * h, exact = brenner_force(z / R, of_two),
                 mesh = of_mesh(z, of_two, shift);

    printf("%5s %6.3f %6.2f %8.3f %8.3f ", of_two ? "two" : "wall", cells,
           shift, exact, mesh / exact);
    for (int i = 0; i < 3; i++) {
        const double film =
            squeeze_film_coefficient(mu, of_two ? 0.5 * R : R, z, 1e-3 * R,
                                     reach[i] * h) *
            (of_two ? 2.0 : 1.0) / (6.0 * M_PI * mu * R);
        printf(" %7.3f", (mesh + film) / exact);
    }
    printf("\n");
}

int main(void)
{
    printf("# gap    z/h  shift    exact  mesh/exact; with the film from 2, 1, "
           "0.75 cells on\n");
    for (int of_two = 0; of_two < 2; of_two++)
        for (double cells = 2.0; cells > 0.1; cells *= 0.5)
            for (int place = 0; place < 1 + of_two; place++)
                row(cells, of_two, place == 0 ? 0.0 : 0.25);
    return 0;
}
