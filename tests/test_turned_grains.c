/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Grains between walls and surfaces, in other axes and other units: the same
 * motion. */
#include <gsl/gsl_math.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "dem/attraction.h"
#include "dem/energy.h"
#include "dem/surfaces/surfaces.h"
#include "dem/surfaces/surface.h"
#include "facts.h"
#include "spheres.h"
#include "turned.h"

enum { SIDE = 4, N = SIDE * SIDE * SIDE, SURFACES = 3 };

static const double half[3] = {0.030, 0.034, 0.028}; /* [m] of the box */

struct variant {
    const struct contact_law *law;
    int periodic[3];
    double rolling;
    const struct attraction_law *pull;
    int materials, surfaces, drag;
};

static const struct variant variants[] = {
    {&contact_linear, {0, 0, 0}, 0.0, NULL, 0, 0, 0},
    {&contact_hertz, {0, 0, 0}, 0.0, NULL, 0, 0, 0},
    {&contact_linear, {1, 0, 0}, 0.1, NULL, 1, 0, 0},
    {&contact_hertz, {0, 1, 1}, 0.1, NULL, 1, 0, 1},
    {&contact_linear, {0, 0, 0}, 0.1, &electrostatic, 1, 1, 0},
    {&contact_hertz, {0, 0, 0}, 0.1, &van_der_waals, 1, 1, 1},
    {&contact_linear, {1, 1, 1}, 0.0, &capillary, 0, 0, 1},
    {&contact_hertz, {1, 1, 1}, 0.0, &electrostatic, 1, 0, 0}};
enum { VARIANTS = sizeof variants / sizeof *variants };

struct scene {
    const struct frame *t;
    const struct variant *v;
    struct units in;
    double speed, force, charge[2]; /* [m/s], [N] in these units; [C] */
    struct surface surface[SURFACES];
    struct material steel;
    struct materials two;
    struct attraction pull;
    struct particles *ps;
    struct dem *dem;
    struct dem_report r;
};

/* An oblique plane that shakes, a tube that turns about an axis beside its own,
 * a sheet that moves. */
static void set_surfaces(struct scene *s)
{
    static const struct motion shakes = {.amplitude = {3e-4, -2e-4, 1e-4},
                                         .frequency = 300.0};
    static const struct motion turns = {.centre = {2e-3, 1e-3, 0.0},
                                        .spin = {3.0, -5.0, 2.0}};
    static const struct motion moves = {.velocity = {0.1, 0.2, -0.15}};
    double corner[2][3][3] = {
        {{-0.02, -0.02, 0.0}, {0.03, -0.015, 2e-4}, {0.001, 0.03, -1e-4}},
        {{-0.02, -0.02, 0.0}, {0.03, -0.015, 2e-4}, {0.0, -0.03, -1e-4}}};
    const double n = sqrt(14.0);
    s->surface[0] =
        (struct surface){.name = "plane",
                         .shape = &surface_plane,
                         .point = {-0.0405 / n, -0.1215 / n, 0.081 / n},
                         .normal = {1.0 / n, 3.0 / n, -2.0 / n},
                         .motion = shakes};
    s->surface[1] = (struct surface){.name = "tube",
                                     .shape = &surface_cylinder,
                                     .material = 1,
                                     .normal = {2.0 / n, 1.0 / n, 3.0 / n},
                                     .radius = 0.0432,
                                     .inside = 1,
                                     .motion = turns};
    for (int j = 0; j < 6; j++)
        turned_vector(s->t, corner[j / 3][j % 3], corner[j / 3][j % 3]);
    for (int j = 0; j < 6; j++)
        turned_scale(s->in.L, corner[j / 3][j % 3]);
    s->surface[2] = (struct surface){.name = "sheet",
                                     .shape = &surface_stl,
                                     .triangles = triangles_create(2, corner),
                                     .motion = moves};
    for (int k = 0; k < SURFACES; k++) {
        struct surface *const f = &s->surface[k];
        turned_scale(s->in.L, f->point);
        f->radius *= s->in.L;
        turned_scale(s->speed, f->motion.velocity);
        turned_scale(s->in.L, f->motion.amplitude);
        f->motion.frequency /= s->in.T;
        turned_scale(s->in.L, f->motion.centre);
        turned_scale(1.0 / s->in.T, f->motion.spin);
        turned_vector(s->t, f->point, f->point);
        turned_vector(s->t, f->normal, f->normal);
        turned_vector(s->t, f->motion.velocity, f->motion.velocity);
        turned_vector(s->t, f->motion.amplitude, f->motion.amplitude);
        turned_vector(s->t, f->motion.centre, f->motion.centre);
        turned_spin(s->t, f->motion.spin, f->motion.spin);
    }
}

static struct dem_options options_of(struct scene *s)
{
    const struct variant *const v = s->v;
    struct dem_options o = spheres_options(v->law, 5e-6 * s->in.T, 1.0);

    o.material.young *= s->force / (s->in.L * s->in.L);
    o.material.stiffness *= s->force / s->in.L;
    o.material.restitution = 0.7;
    o.material.friction = 0.3;
    o.material.rolling = v->rolling;
    for (int k = 0; k < 3; k++) {
        o.periodic[k] = v->periodic[s->t->axis[k]];
        o.hi[k] = half[s->t->axis[k]] * s->in.L;
        o.lo[k] = -o.hi[k];
    }
    s->steel = o.material;
    s->steel.young *= 3.0;
    s->steel.stiffness *= 3.0;
    s->steel.restitution = 0.9;
    s->two = (struct materials){.n = 2, .further = &s->steel, .wall = 1};
    if (v->materials) o.materials = &s->two;
    s->pull = (struct attraction){.law = v->pull,
                                  .range = 2e-3 * s->in.L,
                                  .strength = 1.0,
                                  .closest = 1e-6 * s->in.L,
                                  .charge = s->charge};
    if (v->pull == &van_der_waals) s->pull.strength = 1e-9 * s->force * s->in.L;
    if (v->pull == &capillary) s->pull.strength = 0.07 * s->force / s->in.L;
    if (v->pull != NULL) o.attractions = &s->pull;
    o.n_attractions = v->pull != NULL;
    o.surfaces = s->surface;
    o.n_surfaces = v->surfaces ? SURFACES : 0;
    return o;
}

/* One of them as it is in these units and axes. */
static void add_grain(struct scene *s, const struct particles *of, int i,
                      const double spin[3], const double accelerated[3])
{
    struct particles *const ps = s->ps;
    double x[3] = {of->x[i], of->y[i], of->z[i]}, w[3], e[3];
    double v[3] = {of->vx[i], of->vy[i], of->vz[i]};

    turned_vector(s->t, x, x);
    turned_vector(s->t, v, v);
    turned_vector(s->t, accelerated, e);
    turned_spin(s->t, spin, w);
    turned_scale(s->in.L, x);
    turned_scale(s->speed, v);
    turned_scale(1.0 / s->in.T, w);
    particles_add(ps, x, of->d[i] * s->in.L,
                  2000.0 * s->in.M / (s->in.L * s->in.L * s->in.L));
    turned_scale(ps->m[i] * s->speed / s->in.T, e);
    spheres_throw(ps, i, v[0], v[1], v[2]);
    spheres_spin(ps, i, w[0], w[1], w[2]);
    ps->ex[i] = e[0];
    ps->ey[i] = e[1];
    ps->ez[i] = e[2];
}

/* Two sizes, two materials, thrown and spun at random, with a force on each. */
static void add_grains(struct scene *s)
{
    struct particles *const of =
        spheres_cloud(SIDE, 0.009, 0.5, 0.0142, 1.0, 8);
    uint64_t state = 5;

    s->ps = particles_create(N);
    if (s->v->materials) particles_add_material(s->ps);
    if (s->v->drag) particles_add_implicit_drag(s->ps);
    for (int i = 0; i < N; i++) {
        double w[3], e[3];
        for (int k = 0; k < 3; k++) {
            w[k] = 100.0 * spheres_random(&state);
            e[k] = 20.0 * spheres_random(&state);
        }
        add_grain(s, of, i, w, e);
        if (s->v->materials) s->ps->material[i] = i % 3 == 0;
        if (!s->v->drag) continue;
        s->ps->drag_coefficient[i] = 5.0 * s->ps->m[i] / s->in.T;
        s->ps->added_mass[i] = 0.2 * s->ps->m[i];
    }
    particles_free(of);
}

static struct scene *create(const struct variant *v, const struct frame *t,
                            struct units in)
{
    struct scene *const s = calloc(1, sizeof *s);

    s->t = t;
    s->v = v;
    s->in = in;
    s->speed = in.L / in.T;
    s->force = in.M * s->speed / in.T;
    s->charge[0] = 2e-9 * sqrt(s->force) * in.L;
    s->charge[1] = -3e-9 * sqrt(s->force) * in.L;
    set_surfaces(s);
    add_grains(s);
    const struct dem_options o = options_of(s);
    s->dem = dem_create(s->ps, &o);
    ck_assert_ptr_nonnull(s->dem);
    dem_start_energy_budget(s->dem);
    ck_assert_int_eq(dem_run(s->dem, 600, &s->r), 0);
    return s;
}

static void discard(struct scene *s)
{
    owner_free((struct triangles *)(uintptr_t)s->surface[2].triangles);
    dem_free(s->dem);
    particles_free(s->ps);
    free(s);
}

static void assert_vectors(const double a[3], const double b[3], double tol)
{
    for (int k = 0; k < 3; k++)
        ck_assert_double_eq_tol(a[k], b[k], tol);
}

/* Rounding, 1e-16, grows by a factor of some ten in each collision; there are
 * one or two. */
static void assert_motion(const struct scene *a, const struct scene *b)
{
    for (int id = 0; id < N; id++) {
        const struct particles *const p = a->ps, *const q = b->ps;
        const int i = spheres_place(p, id), j = spheres_place(q, id);
        double x[3] = {p->x[i], p->y[i], p->z[i]};
        double v[3] = {p->vx[i], p->vy[i], p->vz[i]};
        double w[3] = {p->wx[i], p->wy[i], p->wz[i]};
        double F[3] = {p->cfx[i], p->cfy[i], p->cfz[i]};
        turned_vector(b->t, x, x);
        turned_vector(b->t, v, v);
        turned_spin(b->t, w, w);
        turned_vector(b->t, F, F);
        assert_vectors(x, (double[]){q->x[j], q->y[j], q->z[j]}, 1e-12);
        assert_vectors(v, (double[]){q->vx[j], q->vy[j], q->vz[j]}, 1e-9);
        assert_vectors(w, (double[]){q->wx[j], q->wy[j], q->wz[j]}, 1e-6);
        assert_vectors(F, (double[]){q->cfx[j], q->cfy[j], q->cfz[j]}, 1e-8);
    }
}

static void assert_sums(const struct scene *a, const struct scene *b)
{
    const struct energy *const e = dem_energy(a->dem), *const f =
                                                           dem_energy(b->dem);
    ck_assert_int_eq(a->r.contacts, b->r.contacts);
    ck_assert_int_gt(a->r.contacts, 3);
    ck_assert_double_gt(a->r.max_overlap, 1e-3);
    ck_assert_double_eq_tol(a->r.max_speed, b->r.max_speed, 1e-9);
    ck_assert_double_eq_tol(e->kinetic, f->kinetic, 1e-12);
    ck_assert_double_eq_tol(e->slid, f->slid, 1e-12);
    ck_assert_double_eq_tol(e->damped_n, f->damped_n, 1e-12);
    ck_assert_double_eq_tol(e->attracted, f->attracted, 1e-12);
    ck_assert_double_eq_tol(e->walls, f->walls, 1e-12);
    for (int k = 0; k < SURFACES && a->v->surfaces; k++) {
        const struct dem_surface s = dem_surface(a->dem, k);
        const struct dem_surface z = dem_surface(b->dem, k);
        double impulse[3], angular[3];
        turned_vector(b->t, s.impulse, impulse);
        turned_spin(b->t, s.angular, angular);
        ck_assert_double_gt(fabs(s.impulse[0]), 0.0);
        assert_vectors(impulse, z.impulse, 1e-11);
        assert_vectors(angular, z.angular, 1e-12);
        ck_assert_double_eq_tol(s.work, z.work, 1e-12);
    }
    ck_assert_double_eq_tol(a->r.max_overlap, b->r.max_overlap, 1e-10);
    ck_assert_double_eq_tol(e->normal, f->normal, 1e-12);
}

FACT_FOR_EACH(the_motion_of_particles_does_not_depend_on_the_axes, VARIANTS)
{
    struct scene *const a = create(&variants[_i], &turned_frames[0], turned_si);
    for (int t = 1; t < TURNED; t++) {
        struct scene *const b =
            create(&variants[_i], &turned_frames[t], turned_si);
        assert_motion(a, b);
        assert_sums(a, b);
        discard(b);
    }
    discard(a);
}

/* To the last bit: all units are powers of two, and those of length and mass of
 * four, because the contact loop takes roots of R* delta and of m*. */
FACT_FOR_EACH(the_motion_of_particles_does_not_depend_on_the_units, VARIANTS)
{
    const struct frame *const t = &turned_frames[0];
    struct scene *const a = create(&variants[_i], t, turned_si);
    struct scene *const b = create(&variants[_i], t, turned_units);
    const double L = b->in.L, joule = b->force * L;
    for (int i = 0; i < N; i++) {
        ck_assert_int_eq(a->ps->id[i], b->ps->id[i]);
        ck_assert_double_eq(a->ps->x[i] * L, b->ps->x[i]);
        ck_assert_double_eq(a->ps->y[i] * L, b->ps->y[i]);
        ck_assert_double_eq(a->ps->z[i] * L, b->ps->z[i]);
        ck_assert_double_eq(a->ps->vx[i] * b->speed, b->ps->vx[i]);
        ck_assert_double_eq(a->ps->wx[i] / b->in.T, b->ps->wx[i]);
        ck_assert_double_eq(a->ps->cfx[i] * b->force, b->ps->cfx[i]);
    }
    const struct energy *const e = dem_energy(a->dem);
    const struct energy *const f = dem_energy(b->dem);
    ck_assert_double_eq(e->kinetic * joule, f->kinetic);
    ck_assert_double_eq(e->normal * joule, f->normal);
    ck_assert_double_eq(e->tangential * joule, f->tangential);
    ck_assert_double_eq(e->damped_n * joule, f->damped_n);
    ck_assert_double_eq(e->damped_t * joule, f->damped_t);
    ck_assert_double_eq(e->slid * joule, f->slid);
    ck_assert_double_eq(e->released * joule, f->released);
    ck_assert_double_eq(e->rolled * joule, f->rolled);
    ck_assert_double_eq(e->work * joule, f->work);
    ck_assert_double_eq(e->attracted * joule, f->attracted);
    ck_assert_double_eq(e->walls * joule, f->walls);
    ck_assert_int_eq((int)a->r.rebuilds, (int)b->r.rebuilds);
    discard(a);
    discard(b);
}
