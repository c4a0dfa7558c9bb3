/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The loop over the contacts, with all its lanes, blocks and strips, against
 * one that asks every pair: in boxes of all kinds, every number it gives. */
#include <gsl/gsl_math.h>
#include <omp.h>

#include "particles/capillary.h"
#include "particles/dem_inside.h"
#include "particles/electrostatic.h"
#include "particles/van_der_waals.h"
#include "plain_contacts.h"

/* --- all pairs ------------------------------------------------------------ */

/* From particle j to particle i, nearest image. */
static void between(const struct plain *p, int i, int j, double x[3])
{
    vector_between(p->body[i].x, p->body[j].x, x);
    for (int k = 0; k < 3; k++) {
        const double L = p->o->hi[k] - p->o->lo[k];
        if (p->o->periodic[k]) x[k] -= L * rint(x[k] / L);
    }
}

/* [N] of one attraction; b = NULL: of a wall. Positive pushes apart. */
static double attraction(const struct attraction *a,
                         const struct plain_body *one,
                         const struct plain_body *b, double gap)
{
    const double R = one->R, other = b != NULL ? b->R : 0.0;

    if (gap > a->range) return 0.0;
    if (a->law == &electrostatic)
        return b == NULL ? 0.0
                         : electrostatic_force(a->charge[0], a->charge[0],
                                               a->strength, R + other + gap);
    if (a->law == &capillary)
        return capillary_force(a->strength,
                               b == NULL ? 2.0 * R : capillary_mean(R, other));
    return -van_der_waals_force(
        a->strength,
        b == NULL ? 2.0 * R : van_der_waals_diameter(2.0 * R, 2.0 * other),
        fmax(gap, a->closest));
}

static void attract(struct plain *p, struct plain_body *a, struct plain_body *b,
                    const double x[3], double gap, double dt)
{
    double F = 0.0;

    for (int k = 0; k < p->o->n_attractions; k++)
        F += attraction(&p->o->attractions[k], a, b, gap);
    for (int k = 0; k < 3; k++) {
        const double part = F * x[k] / vector_length(x);
        const double v = a->v[k] - (b != NULL ? b->v[k] : 0.0);
        a->pull[k] += part;
        if (b != NULL) b->pull[k] -= part;
        p->e.attracted += dt * part * v;
    }
}

/* The sphere behind wall w is the mirror image that touches it, as in
 * sweep_buffers.h. */
static void meet_wall(struct plain *p, struct plain_body *a, int w, double dt)
{
    const int k = w / 2, upper = w % 2;
    const double gap = upper ? p->o->hi[k] - a->x[k] : a->x[k] - p->o->lo[k];
    double x[3] = {0.0, 0.0, 0.0};

    x[k] = (upper ? -1.0 : 1.0) * (gap + a->R);
    plain_touch(p, a, NULL, -1 - w, x, dt);
    attract(p, a, NULL, x, gap - a->R, dt);
}

static void forget_those_that_parted(struct plain_body *b)
{
    int n = 0;

    for (int q = 0; q < b->n_springs; q++)
        if (b->spring[q].seen) b->spring[n++] = b->spring[q];
    b->n_springs = n;
    for (int q = 0; q < n; q++)
        b->spring[q].seen = 0;
}

static void sweep(struct plain *p, double dt)
{
    const double stored = p->e.tangential;

    p->contacts = 0;
    p->e.normal = p->e.tangential = 0.0;
    if (dt > 0.0) p->e.released += stored;
    for (int i = 0; i < p->n; i++)
        for (int k = 0; k < 3; k++)
            p->body[i].F[k] = p->body[i].T[k] = p->body[i].pull[k] = 0.0;
    for (int i = 0; i < p->n; i++) {
        struct plain_body *const a = &p->body[i];
        for (int w = 0; w < 6; w++)
            if (!p->o->periodic[w / 2]) meet_wall(p, a, w, dt);
        for (int j = i + 1; j < p->n; j++) {
            struct plain_body *const b = &p->body[j];
            double x[3];
            between(p, i, j, x);
            plain_touch(p, a, b, j, x, dt);
            attract(p, a, b, x, vector_length(x) - a->R - b->R, dt);
        }
        forget_those_that_parted(a);
    }
}

static void move(struct plain *p, double kick, double drift)
{
    for (int i = 0; i < p->n; i++) {
        struct plain_body *const b = &p->body[i];
        const double I = 0.4 * b->m * b->R * b->R;
        for (int k = 0; k < 3; k++) {
            b->v[k] += kick * (b->F[k] + b->pull[k] + b->push[k]) / b->m;
            b->w[k] += kick * b->T[k] / I;
            b->x[k] += drift * b->v[k];
            p->e.work += drift * b->push[k] * b->v[k];
        }
    }
}

static double kinetic(const struct plain *p)
{
    double sum = 0.0;

    for (int i = 0; i < p->n; i++) {
        const struct plain_body *const b = &p->body[i];
        sum += 0.5 * b->m * vector_dot(b->v, b->v) +
               0.2 * b->m * b->R * b->R * vector_dot(b->w, b->w);
    }
    return sum;
}

/* Velocity Verlet, as dem_run does it from lists that are made anew. */
static void run_plain(struct plain *p, int steps)
{
    const double dt = p->o->step;

    sweep(p, 0.0);
    p->e.released = 0.0;
    p->e.brought = kinetic(p) + p->e.normal;
    for (int k = 0; k < steps; k++) {
        move(p, k == 0 ? 0.5 * dt : dt, dt);
        sweep(p, dt);
    }
    move(p, 0.5 * dt, 0.0);
    p->e.kinetic = kinetic(p);
}

enum { STEPS = 3 };

/* --- the scenes ----------------------------------------------------------- */

/* Spheres at random, many of which overlap; the box has the side L, and there
 * is room for so many more. */
static struct particles *swarm(int n, int room, double L, uint64_t seed)
{
    struct particles *const ps = particles_create(n + room);
    const double d = fmin(0.5 / cbrt(n), 0.18) * L;

    for (int i = 0; i < n; i++) {
        const double own = d * (1.3 + 0.3 * spheres_random(&seed));
        const double x = spheres_random(&seed), y = spheres_random(&seed);
        spheres_add(ps, 0.48 * L * x, 0.48 * L * y,
                    0.48 * L * spheres_random(&seed), own);
        spheres_throw(ps, i, L * spheres_random(&seed),
                      L * spheres_random(&seed), L * spheres_random(&seed));
        spheres_spin(ps, i, 20.0 * spheres_random(&seed),
                     20.0 * spheres_random(&seed), 9.0 * spheres_random(&seed));
        ps->ey[i] = -9.81 * ps->m[i];
    }
    return ps;
}

/* What is on and what is off. */
struct scene {
    int n, periodic; /* bit k: direction k */
    double L;        /* [m] */
    int room;        /* [-] for spheres that are not there */
    int law, cohesion, rolling, budget;
};

/* Springs and attractions are so strong that in three steps a velocity changes
 * by some per cent, in a box of any size. */

static struct dem_options options_of(const struct scene *s,
                                     struct attraction pull[3], double *charge)
{
    struct dem_options o =
        spheres_options(contact_laws[s->law], 1e-4, 0.5 * s->L);
    const double weight = 1e4 * gsl_pow_3(0.2 * s->L), range = 0.01 * s->L;

    *charge = 1e-5 * sqrt(gsl_pow_5(s->L));
    o.material.stiffness = 1e5 * gsl_pow_3(s->L);
    o.material.young = 2e6 * gsl_pow_2(s->L);
    o.material.restitution = 0.7;
    o.material.friction = 0.3;
    o.material.rolling = s->rolling ? 0.1 : 0.0;
    for (int k = 0; k < 3; k++)
        o.periodic[k] = s->periodic >> k & 1;
    pull[0] = (struct attraction){.law = &electrostatic,
                                  .range = range,
                                  .strength = 1.0,
                                  .charge = charge};
    pull[1] = (struct attraction){.law = &van_der_waals,
                                  .range = range,
                                  .strength = weight * s->L * 1e-3,
                                  .closest = 0.005 * s->L};
    pull[2] = (struct attraction){
        .law = &capillary, .range = range, .strength = weight / s->L};
    o.attractions = pull;
    o.n_attractions = s->cohesion ? 3 : 0;
    return o;
}

/* --- comparing ------------------------------------------------------------ */

/* Of the largest of its kind: the sums are of a few terms in another order,
 * 1e-15 each, in a handful of steps that amplify it little. A lane too many or
 * an image too far is of the size of the whole. */
static const double rounding = 1e-10;

static void assert_close(const double got[3], const double want[3],
                         double scale)
{
    for (int k = 0; k < 3; k++)
        ck_assert_double_eq_tol(got[k], want[k], rounding * scale);
}

/* Largest component of a member of all bodies. */
static double largest(const struct plain *p, size_t member)
{
    double most = 1e-300;

    for (int i = 0; i < p->n; i++) {
        const double *const a =
            (const double *)(const void *)((const char *)&p->body[i] + member);
        for (int k = 0; k < 3; k++)
            most = fmax(most, fabs(a[k]));
    }
    return most;
}

static void compare_bodies(const struct particles *ps, const struct plain *p)
{
    const double F = largest(p, offsetof(struct plain_body, F)) +
                     largest(p, offsetof(struct plain_body, pull));
    const double v = largest(p, offsetof(struct plain_body, v));
    const double w = largest(p, offsetof(struct plain_body, w));

    for (int i = 0; i < ps->n; i++) {
        const struct plain_body *const b = &p->body[ps->id[i]];
        double x[3] = {ps->x[i], ps->y[i], ps->z[i]}, all[3];
        vector_along(b->F, 1.0, b->pull, all);
        for (int k = 0; k < 3; k++) {
            const double L = p->o->hi[k] - p->o->lo[k];
            if (p->o->periodic[k]) x[k] += L * rint((b->x[k] - x[k]) / L);
        }
        assert_close((double[3]){ps->cfx[i], ps->cfy[i], ps->cfz[i]}, all, F);
        assert_close((double[3]){ps->vx[i], ps->vy[i], ps->vz[i]}, b->v, v);
        assert_close((double[3]){ps->wx[i], ps->wy[i], ps->wz[i]}, b->w, w);
        assert_close(x, b->x, p->o->hi[0]);
    }
}

static void compare_budget(const struct energy *got, const struct energy *want)
{
    const double g[] = {got->kinetic,   got->normal,   got->tangential,
                        got->damped_n,  got->damped_t, got->slid,
                        got->released,  got->rolled,   got->work,
                        got->attracted, got->brought};
    const double w[] = {want->kinetic,   want->normal,   want->tangential,
                        want->damped_n,  want->damped_t, want->slid,
                        want->released,  want->rolled,   want->work,
                        want->attracted, want->brought};

    for (size_t k = 0; k < sizeof g / sizeof *g; k++)
        ck_assert_double_eq_tol(
            g[k], w[k], 100.0 * rounding * fabs(w[k]) + 1e-14 * want->brought);
}

static void compare_run(const struct scene *s, const struct dem_options *o,
                        const struct plain *p, struct particles *ps)
{
    struct dem *const dem = dem_create(ps, o);
    struct dem_report r;

    ck_assert_ptr_nonnull(dem);
    if (s->budget) dem_keep_energy(dem);
    ck_assert_int_eq(dem_run(dem, STEPS, &r), 0);
    ck_assert_int_eq(r.contacts, p->contacts);
    ck_assert_double_eq_tol(r.max_overlap, p->deepest, rounding);
    ck_assert_double_eq_tol(r.translation + r.rotation, p->e.kinetic,
                            rounding * p->e.kinetic);
    compare_bodies(ps, p);
    if (s->budget) compare_budget(dem_energy(dem), &p->e);
    dem_free(dem);
}

/* The same scene both ways, with so many threads; gives the contacts. */
static int compare(const struct scene *s, int threads)
{
    struct attraction pull[3];
    double charge;
    const struct dem_options o = options_of(s, pull, &charge);
    struct plain p = {.contacts = 0};

    for (int t = 1; t <= threads; t++) {
        struct particles *const ps =
            swarm(s->n, s->room, s->L, (uint64_t)s->n + 5);
        if (t == 1) {
            p = plain_of(ps, &o);
            run_plain(&p, STEPS);
        }
        omp_set_num_threads(t);
        compare_run(s, &o, &p, ps);
        particles_free(ps);
    }
    free(p.body);
    return p.contacts;
}

/* Boxes periodic in no direction, in x, y, z, in two of them and in all three;
 * smaller and larger than 2 m, and of 2 m; fewer contacts than the loop has
 * lanes and more, a sphere alone, and odd numbers of them; in one strip, or
 * those few in the strips of as many as there is room for. */
START_TEST(the_contact_loop_is_the_sum_over_all_pairs_in_any_box)
{
    static const double sides[] = {0.01, 0.9, 2.0, 7.0};
    static const int counts[] = {1, 7, 33, 65};
    int contacts = 0;

    for (int size = 0; size < 4; size++)
        for (int k = 0; k < 16; k++) {
            const struct scene s = {.n = counts[(k + size) % 4],
                                    .periodic = _i,
                                    .L = sides[size],
                                    .room = size < 2 ? 0 : 8000,
                                    .law = k & 1,
                                    .cohesion = k >> 1 & 1,
                                    .rolling = k >> 2 & 1,
                                    .budget = k >> 3 & 1};
            contacts += compare(&s, 2);
        }
    ck_assert_int_gt(contacts, 1000);
}
END_TEST

/* So many that there are two strips, of several blocks each: what a block
 * leaves out or does too late, or a strip lays on another, would be missing. */
START_TEST(the_contact_loop_is_the_sum_over_all_pairs_in_blocks_and_strips)
{
    static const int periodic[] = {0, 7};
    const struct scene s = {.n = 2101,
                            .periodic = periodic[_i],
                            .L = 0.9,
                            .law = _i,
                            .rolling = 1,
                            .budget = 1};

    ck_assert_int_gt(compare(&s, 2), 1000);
}
END_TEST

/* Of contacts in order of their owners from `first` on, how many belong to
 * particles before `end`, rounded up to whole lanes if there are so many. */
static int whole_lanes(const struct contacts *c, int first, int n, int end)
{
    int own = 0;

    while (own < n && c->owner[first + own] < end)
        own++;
    return (int)fmin(64.0 * ceil(own / 64.0), n);
}

/* A contact done after its block would come too late for its owner's motion;
 * one done before would be of no harm, but the lanes of the next block would be
 * empty. Walls begin lanes of their own. */
START_TEST(a_block_does_its_own_contacts_and_no_more_than_fill_its_lanes)
{
    const struct scene s = {.n = 1901, .L = 0.9};
    struct attraction pull[3];
    double charge;
    const struct dem_options o = options_of(&s, pull, &charge);
    struct particles *const ps = swarm(s.n, 0, s.L, 3);
    struct dem *const dem = dem_create(ps, &o);
    struct dem_report r;

    ck_assert_int_eq(dem_run(dem, 1, &r), 0);
    const struct strip *const one = &dem->neighbours->strips[0];
    const struct contacts *const c = &one->contacts;
    ck_assert_int_eq(dem->neighbours->count, 1);
    ck_assert_int_ge(one->n_blocks, 3);
    ck_assert_int_gt(c->n_walls, 64);
    for (int k = 0; k < one->n_blocks; k++) {
        const struct block *const b = &one->blocks[k];
        ck_assert_int_eq(b->pairs, whole_lanes(c, 0, c->n_pairs, b->end));
        ck_assert_int_eq(b->walls - c->n_pairs,
                         whole_lanes(c, c->n_pairs, c->n_walls, b->end));
    }
    dem_free(dem);
    particles_free(ps);
}
END_TEST

int main(void)
{
    Suite *const s = suite_create("contact_loop");
    TCase *const t = tcase_create("all pairs");

    suite_add_tcase(s, t);
    tcase_add_loop_test(
        t, the_contact_loop_is_the_sum_over_all_pairs_in_any_box, 0, 8);
    tcase_add_loop_test(
        t, the_contact_loop_is_the_sum_over_all_pairs_in_blocks_and_strips, 0,
        2);
    tcase_add_test(
        t, a_block_does_its_own_contacts_and_no_more_than_fill_its_lanes);
    SRunner *const r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    const int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed != 0;
}
