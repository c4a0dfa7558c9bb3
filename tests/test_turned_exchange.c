/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Spheres that move through a fluid, in other axes and other units: the same
 * numbers. */
#include "boxes.h"
#include "facts.h"
#include "suspension.h"
#include "turned.h"

enum { SPHERES = 64, STEPS = 3 };

static const struct {
    const char *averaging, *interpolation, *drag;
    enum treatment treatment;
    enum continuity continuity;
    enum slip_integration relaxation;
    int pressure, model_b, substeps, extras, one_way;
} variants[] = {
    {"pcm", "nearest", "syamlal-obrien", TREATMENT_EXPLICIT, CONTINUITY_MIXTURE,
     SLIP_INTEGRATION_FROZEN, 0, 0, 1, 0, 0},
    {"kernel", "linear", "gidaspow", TREATMENT_SEMI_IMPLICIT,
     CONTINUITY_VOID_RATE, SLIP_INTEGRATION_EXPONENTIAL, 1, 0, 1, 0, 0},
    {"diffusion", "same", "gidaspow", TREATMENT_SEMI_IMPLICIT,
     CONTINUITY_MIXTURE, SLIP_INTEGRATION_FROZEN, 1, 1, 3, 0, 0},
    {"dpvm", "same", "syamlal-obrien", TREATMENT_EXPLICIT, CONTINUITY_VOID_RATE,
     SLIP_INTEGRATION_EXPONENTIAL, 1, 0, 0, 1, 0},
    {"images", "linear", "syamlal-obrien", TREATMENT_SEMI_IMPLICIT,
     CONTINUITY_MIXTURE, SLIP_INTEGRATION_EXPONENTIAL, 1, 1, 1, 1, 0},
    {"diffusion", "linear", "schiller-naumann", TREATMENT_SEMI_IMPLICIT,
     CONTINUITY_VOID_RATE, SLIP_INTEGRATION_FROZEN, 1, 0, 2, 1, 1}};
enum { VARIANTS = sizeof variants / sizeof *variants };

static struct scene scene_of(int v, const struct frame *t, struct units in)
{
    const double speed = in.L / in.T, density = in.M / (in.L * in.L * in.L);
    struct scene s = air;

    s.averaging = variants[v].averaging;
    s.interpolation = variants[v].interpolation;
    s.drag = variants[v].drag;
    s.treatment = variants[v].treatment;
    s.continuity = variants[v].continuity;
    s.relaxation = variants[v].relaxation;
    s.pressure_gradient = variants[v].pressure;
    s.model_b = variants[v].model_b;
    s.substeps = variants[v].substeps;
    s.viscous_stress = variants[v].extras;
    s.virtual_mass = 0.5 * variants[v].extras;
    s.one_way = variants[v].one_way;
    s.n = SPHERES;
    s.cells = 4;
    s.dem_steps = 6;
    s.width = 1.0;
    s.size = 0.008 * in.L;
    s.d = 6e-4 * in.L;
    s.dt = 5e-5 * in.T;
    s.rho = 100.0 * density;
    s.rho_s = 2000.0 * density;
    s.mu = 1e-3 * density * in.L * speed;
    const double g[3] = {2.0 * speed / in.T, -9.81 * speed / in.T,
                         3.0 * speed / in.T};
    turned_vector(t, g, s.gravity);
    return s;
}

/* Off the lattice, so that nothing is symmetric by itself. */
static void place(struct simulation *sim, const struct frame *t,
                  struct units in)
{
    struct particles *const ps = sim->particles;
    const double size[3] = {0.008, 0.008, 0.008}, speed = in.L / in.T;
    gsl_rng *const random = gsl_rng_alloc(gsl_rng_mt19937);

    for (int i = 0; i < SPHERES; i++) {
        double x[3], v[3];
        for (int k = 0; k < 3; k++) {
            const int at = k == 0 ? i % 4 : k == 1 ? i / 4 % 4 : i / 16;
            x[k] = 0.002 * (at + 0.3 + 0.4 * gsl_rng_uniform(random));
            v[k] = gsl_rng_uniform(random) - 0.4;
        }
        turned_place(t, size, x, x);
        turned_vector(t, v, v);
        turned_scale(in.L, x);
        turned_scale(speed, v);
        ps->x[i] = x[0], ps->y[i] = x[1], ps->z[i] = x[2];
        ps->vx[i] = v[0], ps->vy[i] = v[1], ps->vz[i] = v[2];
    }
    gsl_rng_free(random);
    dem_changed(sim->dem);
}

/* A stream in all directions that varies from cell to cell of the original. */
static void blow(struct simulation *sim, const struct mesh *plain,
                 const struct frame *t, struct units in)
{
    const double speed = in.L / in.T, U[3] = {0.3, -0.2, 0.1};
    struct fluid *const fl = sim->fluid;
    double turned[3];

    turned_vector(t, U, turned);
    for (int c = 0; c < plain->n_cells; c++) {
        const int to = turned_cell(t, plain, sim->mesh, c);
        for (int k = 0; k < 3; k++)
            fl->u[3 * to + k] =
                speed *
                (turned[k] + t->sign[k] * 0.05 * sin(3.0 * c * c + t->axis[k]));
    }
    for (int f = 0; f < sim->mesh->n_faces; f++) {
        fl->phi[f] = 0.0;
        for (int k = 0; k < 3; k++)
            fl->phi[f] += speed * turned[k] * mesh_S(sim->mesh, f)[k];
    }
}

static struct simulation *moved(int v, const struct mesh *plain,
                                const struct frame *t, struct units in)
{
    const struct scene s = scene_of(v, t, in);
    struct simulation *const sim = build(&s);

    place(sim, t, in);
    blow(sim, plain, t, in);
    ck_assert_int_eq(coupling_start(sim), 0);
    run(sim, STEPS);
    return sim;
}

static struct mesh *mesh_in(struct units in)
{
    const double size = 0.008 * in.L;
    return periodic_box(size, size, size, 4, 4, 4);
}

static void particle(const struct particles *ps, int id, double v[3],
                     double F[3])
{
    int i = 0;
    while (ps->id[i] != id)
        i++;
    v[0] = ps->vx[i], v[1] = ps->vy[i], v[2] = ps->vz[i];
    F[0] = ps->ex[i], F[1] = ps->ey[i], F[2] = ps->ez[i];
}

/* Speeds are of 0.3 m/s, forces of 1e-5 N; the solver leaves 1e-10 of its right
 * side. A term of one direction would be missed by 1e-4 of them. */
static void assert_alike(const struct simulation *a, const struct simulation *b,
                         const struct mesh *plain, const struct frame *t)
{
    for (int id = 0; id < SPHERES; id++) {
        double v[3], F[3], w[3], G[3];
        particle(a->particles, id, v, F);
        particle(b->particles, id, w, G);
        turned_vector(t, v, v);
        turned_vector(t, F, F);
        for (int k = 0; k < 3; k++) {
            ck_assert_double_eq_tol(v[k], w[k], 1e-8);
            ck_assert_double_eq_tol(F[k], G[k], 1e-11);
        }
    }
    for (int c = 0; c < plain->n_cells; c++) {
        const int to = turned_cell(t, plain, b->mesh, c);
        double u[3];
        turned_vector(t, &a->fluid->u[3 * c], u);
        ck_assert_double_eq_tol(a->fluid->eps[c], b->fluid->eps[to], 1e-10);
        for (int k = 0; k < 3; k++)
            ck_assert_double_eq_tol(u[k], b->fluid->u[3 * to + k], 1e-8);
    }
    ck_assert_double_eq_tol(a->coupling->report.shortest_time,
                            b->coupling->report.shortest_time, 1e-9);
    ck_assert_double_eq_tol(a->coupling->report.lowest_interpolated,
                            b->coupling->report.lowest_interpolated, 1e-10);
}

FACT_FOR_EACH(the_coupling_does_not_depend_on_the_axes, VARIANTS)
{
    struct mesh *const plain = mesh_in(turned_si);
    struct simulation *const a = moved(_i, plain, &turned_frames[0], turned_si);
    for (int t = 1; t < TURNED; t++) {
        const struct frame *const f = &turned_frames[t];
        struct simulation *const b = moved(_i, plain, f, turned_si);
        assert_alike(a, b, plain, f);
        discard(b);
    }
    discard(a);
    mesh_free(plain);
}

/* Drag laws take powers of numbers without a unit: to the last bit. */
FACT_FOR_EACH(the_coupling_does_not_depend_on_the_units, VARIANTS)
{
    const struct units in = turned_units;
    const double speed = in.L / in.T, force = in.M * speed / in.T;
    const struct frame *const t = &turned_frames[0];
    struct mesh *const plain = mesh_in(turned_si), *const other = mesh_in(in);
    struct simulation *const a = moved(_i, plain, t, turned_si);
    struct simulation *const b = moved(_i, other, t, in);
    for (int i = 0; i < SPHERES; i++) {
        ck_assert_double_eq(a->particles->vx[i] * speed, b->particles->vx[i]);
        ck_assert_double_eq(a->particles->vy[i] * speed, b->particles->vy[i]);
        ck_assert_double_eq(a->particles->ez[i] * force, b->particles->ez[i]);
    }
    for (int i = 0; i < 3 * plain->n_cells; i++)
        ck_assert_double_eq(a->fluid->u[i] * speed, b->fluid->u[i]);
    ck_assert_double_eq(a->coupling->report.shortest_time * in.T,
                        b->coupling->report.shortest_time);
    discard(a);
    discard(b);
    mesh_free(plain);
    mesh_free(other);
}
