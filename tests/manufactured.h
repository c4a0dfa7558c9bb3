/* SPDX-License-Identifier: GPL-3.0-or-later */
/* manufactured.h -- two manufactured solutions of the averaged equations, with
 * walls and a fluid fraction that varies in space and time.
 * Chapter "The flow, verified".
 *
 * From a vector field W and a stream A of choice, both functions of x and t,
 *
 *   eps = e - div W,   eps u = dW/dt + curl A,   eps_s u_s = -dW/dt
 *
 * satisfy both forms of continuity exactly: d eps/dt + div(eps u) = 0, and eps
 * u + eps_s u_s = curl A has no divergence. A pressure and a friction K are
 * chosen, too; F is the remainder of the momentum equation,
 *
 *   F = eps rho (du/dt + u . grad u) + gamma grad p - mu lap u + K u,
 *
 * with differences of fourth order over 1/500 of the size (their error: 1e-6).
 *
 * MANUFACTURED_BOX: W and A vanish with their slopes on all six sides: walls,
 * and the box may be sheared. MANUFACTURED_CHANNEL: a parabola enters at x = 0
 * with a course in time and leaves at x = 1, between walls at y = 0, 1 and slip
 * walls at z = 0, 1.
 */
#ifndef TESTS_MADE_H
#define TESTS_MADE_H

#include "mesh/poly/poly.h"
#include "tetrahedra.h"
#include "fluid/fluid.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum manufactured_kind { MANUFACTURED_BOX, MANUFACTURED_CHANNEL };

struct manufactured {
    enum manufactured_kind kind;
    int n;               /* cells a side */
    int flat;            /* 1: one cell in z, and nothing depends on it */
    double grading;      /* last cell over first, in x and y; and back in z */
    double shear[3];     /* of MANUFACTURED_BOX */
    double shake;        /* [-] above 0: on tetrahedra, shaken so much */
    int shared, mixture; /* gamma = eps; form of continuity */
    const char *time, *convection, *slope;
    double dt, end, K; /* [s], [s], [kg/(m^3 s)] */
    int steady;        /* 1: nothing changes in time */
    int still;         /* 1: of a steady box A is 0, and the fluid at rest */
};

static const double manufactured_pi = 3.14159265358979323846;
static const double manufactured_rho = 1.0, manufactured_mu = 0.1;

/* The errors of u and p, over all cells and over those at a wall: root mean
 * square and largest. */
struct manufactured_error {
    double u, p, u_max, p_max, u_wall, p_wall;
};

static double manufactured_bump(double x)
{
    return pow(sin(manufactured_pi * x), 2.0);
}

static double manufactured_bump_slope(double x)
{
    return manufactured_pi * sin(2.0 * manufactured_pi * x);
}

/* The course of A and of p in time. */
static double manufactured_course(const struct manufactured *a, double t)
{
    return a->steady ? 1.0 : 1.0 + 0.4 * sin(4.0 * t);
}

/* The amplitude of W at a time. */
static double manufactured_way(const struct manufactured *a, double t)
{
    return a->steady ? 0.02 : 0.02 * (1.0 + 0.8 * sin(5.0 * t));
}

static double manufactured_way_slope(const struct manufactured *a, double t)
{
    return a->steady ? 0.0 : 0.02 * 0.8 * 5.0 * cos(5.0 * t);
}

/* The slope of S = bump(xi) bump(eta) bump(zeta), squared in xi for the
 * channel, and S itself; xi, eta, zeta count from the walls. */
static double manufactured_hill(const struct manufactured *a, const double x[3],
                                double grad[3])
{
    const double zeta = x[2], eta = x[1] - a->shear[2] * zeta;
    const double xi = x[0] - a->shear[0] * eta - a->shear[1] * zeta;
    const int thin = a->flat;
    double X = manufactured_bump(xi), dX = manufactured_bump_slope(xi);
    const double Y = manufactured_bump(eta), dY = manufactured_bump_slope(eta);
    const double Z = thin ? 1.0 : manufactured_bump(zeta);
    const double dZ = thin ? 0.0 : manufactured_bump_slope(zeta);

    if (a->kind == MANUFACTURED_CHANNEL) {
        dX *= 2.0 * X;
        X *= X;
    }
    /* xi = x - s0 eta - s1 zeta, eta = y - s2 zeta */
    const double by_xi = dX * Y * Z, by_eta = X * dY * Z, by_zeta = X * Y * dZ;
    grad[0] = by_xi;
    grad[1] = by_eta - a->shear[0] * by_xi;
    grad[2] = by_zeta - a->shear[2] * by_eta +
              (a->shear[0] * a->shear[2] - a->shear[1]) * by_xi;
    return X * Y * Z;
}

/* The direction of W: along the slip walls in a channel. */
static double manufactured_w(const struct manufactured *a, int k)
{
    static const double w[3] = {1.0, -0.7, 0.5};

    return k == 2 && (a->flat || a->kind == MANUFACTURED_CHANNEL) ? 0.0 : w[k];
}

static double manufactured_eps(const struct manufactured *a, const double x[3],
                               double t)
{
    double g[3];

    manufactured_hill(a, x, g);
    return 0.6 - manufactured_way(a, t) * (manufactured_w(a, 0) * g[0] +
                                           manufactured_w(a, 1) * g[1] +
                                           manufactured_w(a, 2) * g[2]);
}

/* eps_s u_s */
static void manufactured_solids(const struct manufactured *a, const double x[3],
                                double t, double to[3])
{
    double g[3];
    const double S = manufactured_hill(a, x, g);

    for (int k = 0; k < 3; k++)
        to[k] = -manufactured_way_slope(a, t) * manufactured_w(a, k) * S;
}

/* eps u */
static void manufactured_flux(const struct manufactured *a, const double x[3],
                              double t, double q[3])
{
    static const double amount[3] = {0.08, -0.06, 0.1};
    const double T = manufactured_course(a, t);
    double g[3], s[3];
    const double S = manufactured_hill(a, x, g);

    manufactured_solids(a, x, t, s);
    if (a->kind == MANUFACTURED_CHANNEL) { /* psi = T (3 y^2 - 2 y^3 + 0.1 S) */
        q[0] = T * (6.0 * x[1] * (1.0 - x[1]) + 0.1 * g[1]);
        q[1] = -T * 0.1 * g[0];
        q[2] = 0.0;
    } else { /* A_k = amount_k (1 + k x / 2) S */
        double c[3], A[3][3];
        for (int k = 0; k < 3; k++) {
            c[k] = amount[k] * (1.0 + 0.5 * k * x[0]);
            if (a->still || (a->flat && k < 2)) c[k] = 0.0;
            for (int j = 0; j < 3; j++)
                A[k][j] = c[k] * g[j];
            if (c[k] != 0.0) A[k][0] += amount[k] * 0.5 * k * S;
        }
        q[0] = T * (A[2][1] - A[1][2]);
        q[1] = T * (A[0][2] - A[2][0]);
        q[2] = T * (A[1][0] - A[0][1]);
    }
    for (int k = 0; k < 3; k++)
        q[k] -= s[k];
}

static double manufactured_p(const struct manufactured *a, const double x[3],
                             double t)
{
    const double z = a->flat ? 0.0 : x[2];
    const double wave = cos(2.0 * x[0] + x[1]) * sin(1.0 + 1.5 * x[1] - z);

    if (a->kind == MANUFACTURED_CHANNEL)
        return manufactured_course(a, t) * (1.0 - x[0]) * (2.0 + wave);
    return manufactured_course(a, t) * wave;
}

static double manufactured_friction(const struct manufactured *a,
                                    const double x[3])
{
    return a->K * (1.0 + 0.5 * sin(2.0 * x[0] + x[1]));
}

static void manufactured_u(const struct manufactured *a, const double x[3],
                           double t, double u[3])
{
    manufactured_flux(a, x, t, u);
    for (int k = 0; k < 3; k++)
        u[k] /= manufactured_eps(a, x, t);
}

static void manufactured_force(const struct manufactured *a, const double x[3],
                               double t, double F[3])
{
    static const double first[4] = {1.0 / 12.0, -2.0 / 3.0, 2.0 / 3.0,
                                    -1.0 / 12.0};
    static const double second[4] = {-1.0 / 12.0, 4.0 / 3.0, 4.0 / 3.0,
                                     -1.0 / 12.0};
    static const double at[4] = {-2.0, -1.0, 1.0, 2.0};
    const double h = 2e-3, eps = manufactured_eps(a, x, t),
                 K = manufactured_friction(a, x);
    const double gamma = a->shared ? eps : 1.0;
    double u[3], v[3];

    manufactured_u(a, x, t, u);
    for (int k = 0; k < 3; k++)
        F[k] = K * u[k];
    for (int j = 0; j < (a->flat ? 2 : 3); j++) {
        for (int k = 0; k < 3; k++)
            F[k] += 2.5 * manufactured_mu * u[k] / (h * h);
        for (int i = 0; i < 4; i++) {
            double y[3] = {x[0], x[1], x[2]};
            y[j] += at[i] * h;
            manufactured_u(a, y, t, v);
            F[j] += gamma * first[i] * manufactured_p(a, y, t) / h;
            for (int k = 0; k < 3; k++)
                F[k] += eps * manufactured_rho * u[j] * first[i] * v[k] / h -
                        manufactured_mu * second[i] * v[k] / (h * h);
        }
    }
    for (int i = 0; i < 4 && !a->steady; i++) {
        manufactured_u(a, x, t + at[i] * h, v);
        for (int k = 0; k < 3; k++)
            F[k] += eps * manufactured_rho * first[i] * v[k] / h;
    }
}

/* Sets the fields that the coupling would set, for the time at the end of a
 * step. */
static void manufactured_set(const struct manufactured *a, struct fluid *fl,
                             double t)
{
    const struct mesh *const m = fl->mesh;

    for (int c = 0; c < m->n_cells; c++) {
        const double *const x = &m->centre[3 * c];
        fl->eps[c] = manufactured_eps(a, x, t);
        fl->K[c] = manufactured_friction(a, x);
        manufactured_force(a, x, t, &fl->F[3 * c]);
        manufactured_solids(a, x, t, &fl->eps_us[3 * c]);
    }
}

/* The patches of a box are left right bottom top back front; the inlet's course
 * is a table of 2000 corners. */
enum { MANUFACTURED_COURSE = 2000 };
struct manufactured_boundaries {
    struct boundary side[6];
    double time[MANUFACTURED_COURSE], velocity[MANUFACTURED_COURSE];
    double *profile;
};

/* The middle of a face. */
static void manufactured_middle(const struct mesh *m, int f, double x[3])
{
    const double w = f < m->n_internal ? 1.0 - m->w[f] : 1.0;

    for (int k = 0; k < 3; k++)
        x[k] = m->face_centre != NULL
                   ? m->face_centre[3 * f + k]
                   : m->centre[3 * m->owner[f] + k] + w * mesh_d(m, f)[k];
}

static void manufactured_bound(const struct manufactured *a,
                               const struct mesh *m,
                               struct manufactured_boundaries *b)
{
    memset(b, 0, sizeof *b);
    for (int i = 0; i < 6; i++)
        b->side[i].kind = i >= 4 && (a->flat || a->kind == MANUFACTURED_CHANNEL)
                              ? BOUNDARY_SLIP
                              : BOUNDARY_NO_SLIP;
    if (a->kind == MANUFACTURED_BOX) return;
    const struct patch *const p = mesh_patch(m, "left");
    b->profile = malloc((size_t)p->n * sizeof *b->profile);
    for (int j = 0; j < p->n; j++) {
        const int f = p->first + j;
        double x[3];
        manufactured_middle(m, f, x);
        b->profile[j] = 6.0 * x[1] * (1.0 - x[1]);
    }
    for (int i = 0; i < MANUFACTURED_COURSE; i++) {
        b->time[i] = 1.2 * a->end * i / (MANUFACTURED_COURSE - 1);
        b->velocity[i] = manufactured_course(a, b->time[i]);
    }
    b->side[0] = (struct boundary){.kind = BOUNDARY_INLET,
                                   .n_points = MANUFACTURED_COURSE,
                                   .time = b->time,
                                   .velocity = b->velocity,
                                   .profile = b->profile};
    b->side[1] = (struct boundary){.kind = BOUNDARY_OUTLET};
}

static struct mesh *manufactured_mesh(const struct manufactured *a)
{
    const int n[3] = {a->n, a->n, a->n};
    const double g = a->grading > 0.0 ? a->grading : 1.0;
    const struct box_spec spec = {{1.0, 1.0, 1.0},
                                  {a->n, a->n, a->flat ? 1 : a->n},
                                  {g, g, a->flat ? 1.0 : 1.0 / g},
                                  {0, 0, 0}};
    const int straight =
        a->shear[0] == 0.0 && a->shear[1] == 0.0 && a->shear[2] == 0.0;

    if (a->shake > 0.0) return tetrahedra_create(n, a->shake, NULL);
    return straight ? mesh_create_box(&spec)
                    : mesh_create_sheared(&spec, a->shear);
}

static struct fluid *manufactured_create(const struct manufactured *a,
                                         struct manufactured_boundaries *b)
{
    struct mesh *const m = manufactured_mesh(a);
    const struct fluid_options o = {
        .rho = manufactured_rho,
        .mu = manufactured_mu,
        .dt = a->dt,
        .time = time_scheme_named(a->time),
        .convection = convection_scheme_named(a->convection),
        .blend = 0.8,
        .velocity_gradient =
            a->slope ? velocity_gradient_scheme_named(a->slope) : NULL,
        .continuity = a->mixture ? CONTINUITY_MIXTURE : CONTINUITY_VOID_RATE,
        .correctors = 3,
        .piso_tolerance = 1e-6,
        .tolerance = 1e-9,
        .coupled = 1,
        .pressure_shared = a->shared,
        .boundaries = b->side};

    manufactured_bound(a, m, b);
    struct fluid *const fl = fluid_create(m, &o);
    manufactured_set(a, fl, 0.0);
    fluid_reset_eps_history(fl);
    for (int c = 0; c < m->n_cells; c++) {
        const double *const x = &m->centre[3 * c];
        manufactured_u(a, x, 0.0, &fl->u[3 * c]);
        fl->p[c] = manufactured_p(a, x, 0.0);
    }
    for (int f = 0; f < m->n_faces; f++) {
        double x[3], q[3];
        manufactured_middle(m, f, x);
        manufactured_flux(a, x, 0.0, q);
        fl->phi[f] = 0.0;
        for (int k = 0; k < 3; k++)
            fl->phi[f] += q[k] * mesh_S(m, f)[k];
    }
    return fl;
}

static struct manufactured_error
manufactured_compare(const struct manufactured *a, const struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    struct manufactured_error e = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    double V = 0.0, V_wall = 0.0, level = 0.0;

    for (int c = 0; c < m->n_cells && a->kind == MANUFACTURED_BOX; c++) {
        V += m->V[c];
        level +=
            m->V[c] * (fl->p[c] - manufactured_p(a, &m->centre[3 * c], fl->t));
    }
    if (V > 0.0) level /= V;
    V = 0.0;
    for (int c = 0; c < m->n_cells; c++) {
        const double *const x = &m->centre[3 * c];
        double u[3], square = 0.0;
        int wall = 0;
        manufactured_u(a, x, fl->t, u);
        for (int k = 0; k < 3; k++)
            square += pow(fl->u[3 * c + k] - u[k], 2.0);
        const double p = fl->p[c] - level - manufactured_p(a, x, fl->t);
        for (int i = m->cell_start[c]; i < m->cell_start[c + 1]; i++)
            wall = wall ||
                   (m->cell_face[i] >= m->n_internal &&
                    (!a->flat || fabs(mesh_S(m, m->cell_face[i])[2]) < 1e-9));
        V += m->V[c];
        e.u += m->V[c] * square;
        e.p += m->V[c] * p * p;
        e.u_max = fmax(e.u_max, sqrt(square));
        e.p_max = fmax(e.p_max, fabs(p));
        if (!wall) continue;
        V_wall += m->V[c];
        e.u_wall += m->V[c] * square;
        e.p_wall += m->V[c] * p * p;
    }
    e.u = sqrt(e.u / V);
    e.p = sqrt(e.p / V);
    e.u_wall = sqrt(e.u_wall / V_wall);
    e.p_wall = sqrt(e.p_wall / V_wall);
    return e;
}

/* Its errors at the end; all NAN if a step failed. */
static struct manufactured_error manufactured_run(const struct manufactured *a)
{
    struct manufactured_boundaries b;
    struct fluid *const fl = manufactured_create(a, &b);
    const int steps = (int)ceil(a->end / a->dt - 1e-9);
    int failed = 0;

    for (int i = 0; i < steps && !failed; i++) {
        manufactured_set(a, fl, fl->t + a->dt);
        failed = fluid_step(fl);
    }
    struct manufactured_error e = manufactured_compare(a, fl);
    if (failed) e = (struct manufactured_error){NAN, NAN, NAN, NAN, NAN, NAN};
    struct mesh *const m = (struct mesh *)fl->mesh;
    owner_free(fl);
    mesh_free(m);
    free(b.profile);
    return e;
}

#endif
