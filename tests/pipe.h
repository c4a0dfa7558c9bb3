/* pipe.h -- Poiseuille's flow at Re = 100 through a pipe of tetrahedra. */
#ifndef TESTS_PIPE_H
#define TESTS_PIPE_H

#include "fluid/fluid.h"
#include "tetrahedra.h"

static const double pipe_mu = 0.01; /* [Pa s] d = 1 m, rho = 1 kg/m^3 */

/* The unit cube becomes a pipe of the diameter 1 and the length 2. */
static void pipe_bend(double x[3])
{
    const double a = 2.0 * x[0] - 1.0, b = 2.0 * x[1] - 1.0;

    x[0] = 0.5 * a * sqrt(1.0 - 0.5 * b * b);
    x[1] = 0.5 * b * sqrt(1.0 - 0.5 * a * a);
    x[2] *= 2.0;
}

static double pipe_velocity(const double *x)
{
    return 2.0 - 8.0 * (x[0] * x[0] + x[1] * x[1]);
}

/* The slope of p along the middle half of the pipe, by least squares [Pa/m]. */
static double pipe_slope(const struct fluid *fl)
{
    double s = 0.0, z = 0.0, zz = 0.0, p = 0.0, pz = 0.0;

    for (int c = 0; c < fl->mesh->n_cells; c++) {
        const double at = fl->mesh->centre[3 * c + 2] - 1.0;
        const double V = fabs(at) < 0.5 ? fl->mesh->V[c] : 0.0;
        s += V, z += V * at, zz += V * at * at;
        p += V * fl->p[c], pz += V * at * fl->p[c];
    }
    return (s * pz - z * p) / (s * zz - z * z);
}

/* The profile at the inlet, and its mean [m/s]. */
static double pipe_enter(const struct mesh *m, double *profile)
{
    const struct patch *const in = mesh_patch(m, "back");
    double flow = 0.0, area = 0.0;

    for (int j = 0; j < in->n; j++) {
        const double S = fabs(mesh_S(m, in->first + j)[2]);
        profile[j] = pipe_velocity(&m->face_centre[3 * (in->first + j)]);
        flow += profile[j] * S;
        area += S;
    }
    return flow / area;
}

static struct fluid *pipe_begin(const struct mesh *m,
                                const struct fluid_options *o)
{
    struct fluid *const fl = fluid_create(m, o);

    for (int c = 0; c < m->n_cells; c++) {
        const double *const x = &m->centre[3 * c];
        fl->u[3 * c + 2] = pipe_velocity(x);
        fl->p[c] = 32.0 * pipe_mu * (2.0 - x[2]);
    }
    for (int f = 0; f < m->n_faces; f++)
        fl->phi[f] = pipe_velocity(&m->face_centre[3 * f]) * mesh_S(m, f)[2];
    return fl;
}

/* The pressure drop over the exact one, 32 mu U L / d^2, on 12 n^3 cells at the
 * time `end` [s], begun with the exact flow; NAN if a step fails. */
static double pipe_of_tetrahedra(int n, const char *convection,
                                 const char *gradient, double end)
{
    const int blocks[3] = {n, n, 2 * n};
    const double time = 0.0, one = 1.0;
    struct mesh *const m = tetrahedra_create(blocks, 0.2, pipe_bend);
    double *const profile = alloc_doubles(2 * n * n);
    const double U = pipe_enter(m, profile);
    struct boundary b[6] = {[4] = {.kind = BOUNDARY_INLET,
                                   .n_points = 1,
                                   .time = &time,
                                   .velocity = &one,
                                   .profile = profile},
                            [5] = {.kind = BOUNDARY_OUTLET}};
    for (int i = 0; i < 4; i++)
        b[i].kind = BOUNDARY_NO_SLIP;
    const struct fluid_options o = {
        .rho = 1.0,
        .mu = pipe_mu,
        .dt = 0.18 / n,
        .convection = convection_scheme_named(convection),
        .velocity_gradient =
            gradient ? velocity_gradient_scheme_named(gradient) : NULL,
        .correctors = 2,
        .piso_tolerance = 1e-3,
        .tolerance = 1e-5,
        .boundaries = b};
    struct fluid *const fl = pipe_begin(m, &o);
    int failed = 0;

    while (fl->t < end && !failed)
        failed = fluid_step(fl);
    const double drop = -pipe_slope(fl) / (32.0 * pipe_mu * U);
    owner_free(fl);
    mesh_free(m);
    free(profile);
    return failed ? NAN : drop;
}

#endif
