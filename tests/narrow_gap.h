/* narrow_gap.h -- for tests and figures: what the mesh alone does in a narrow
 * gap. */
#ifndef NARROW_GAP_H
#define NARROW_GAP_H

#include "resolved.h"
#include "resolved/body_motion.h"

enum { NARROW_GAP_CELLS = 8 }; /* in the diameter, 1 m */
static const double narrow_gap_R = 0.5, narrow_gap_h = 1.0 / NARROW_GAP_CELLS,
                    narrow_gap_mu = 1.0;

/* Force of the fluid over 6 pi mu R U on a sphere that comes to a floor with U,
 * or on one of two that come to each other with U each, at the gap z [m]. The
 * fluid is at rest but for them, and inertia is none. Shifted by so much [m]
 * from where the cells are symmetric. */
static inline double narrow_gap_force(double z, int of_two, double shift_x,
                                      double shift_y)
{
    enum { N = NARROW_GAP_CELLS };
    static const double R = narrow_gap_R, U = 1e-6, mu = narrow_gap_mu;
    const struct pool_options o = {
        .size = {of_two ? 4.0 : 3.0, 3.0, 3.0},
        .cells = {(of_two ? 4 : 3) * N, 3 * N, 3 * N},
        .walls = {0, !of_two, 0},
        .rho = 1.0,
        .mu = mu,
        .dt = narrow_gap_h * narrow_gap_h,
        .virtual_mass = 2.0,
        .tolerance = 1e-6,
        .n = 2};
    const struct body_shape sphere = body_shape_sphere(2.0 * R);
    struct pool p;

    pool_create(&p, &o);
    for (int i = 0; i < 1 + of_two; i++) {
        const double sign = i == 0 ? -1.0 : 1.0;
        const double two[3] = {2.0 + shift_x + sign * (R + 0.5 * z),
                               1.5 + shift_y, 1.5},
                     one[3] = {1.5 + shift_x, R + z, 1.5};
        solid_bodies_add(p.bodies, &sphere, of_two ? two : one, 1.0,
                         BODY_PRESCRIBED);
        p.bodies->ps->vx[i] = of_two ? -sign * U : 0.0;
        p.bodies->ps->vy[i] = of_two ? 0.0 : -U;
    }
    int failed = solid_bodies_begin(p.bodies, p.fluid);
    for (int i = 0; i < 25 && !failed; i++)
        failed = fluid_step(p.fluid) != 0 ||
                 body_motion_advance(p.bodies, o.dt) != 0;
    const double F = of_two ? -p.bodies->force[0] : p.bodies->force[1];
    pool_free(&p);
    return failed ? NAN : F / (6.0 * M_PI * mu * R * U);
}

/* The film's part of the same, if it begins at the gap `reach` [m]. */
static inline double narrow_gap_film(double z, int of_two, double reach)
{
    const double R = narrow_gap_R;
    return (of_two ? 2.0 : 1.0) *
           squeeze_film_coefficient(narrow_gap_mu, of_two ? 0.5 * R : R, z,
                                    1e-3 * R, reach) /
           (6.0 * M_PI * narrow_gap_mu * R);
}

#endif
