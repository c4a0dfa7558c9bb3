/* SPDX-License-Identifier: GPL-3.0-or-later */
/* No contact is missed, and the history of a contact survives when the lists
 * are rebuilt: tested from outside, through dem_run. */
#include <omp.h>
#include <stdlib.h>

#include "dem/fast/neighbours.h"
#include "dem/reference.h"
#include "facts.h"
#include "spheres.h"

/* --- all pairs -------------------------------------------------------------
 */

/* Touching pairs and walls by a loop over all pairs. */
static int count_touching(const struct particles *ps,
                          const struct dem_options *o)
{
    const double *const x[3] = {ps->x, ps->y, ps->z};
    int n = 0;

    for (int i = 0; i < ps->n; i++) {
        for (int k = 0; k < 3; k++) {
            if (o->periodic[k]) continue;
            n += x[k][i] - o->lo[k] < 0.5 * ps->d[i];
            n += o->hi[k] - x[k][i] < 0.5 * ps->d[i];
        }
        for (int j = 0; j < i; j++) {
            double r2 = 0.0;
            for (int k = 0; k < 3; k++) {
                const double L = o->hi[k] - o->lo[k];
                const double dx = x[k][i] - x[k][j];
                const double near = o->periodic[k] ? dx - L * rint(dx / L) : dx;
                r2 += near * near;
            }
            n += sqrt(r2) < 0.5 * (ps->d[i] + ps->d[j]);
        }
    }
    return n;
}

/* Boxes of several shapes; radii 1 : 4; particles enough for several layers of
 * cells, or so few that there are only two cells or one. */
static const struct hunt {
    int n;           /* n^3 particles */
    double pitch;    /* [m] */
    double half[3];  /* [m] */
    int periodic[3]; /* [-] */
    double skin;     /* [m] 0: as the program chooses */
} hunts[] = {
    {7, 0.028, {0.10, 0.10, 0.10}, {0, 0, 0}, 0.0},
    {7, 0.028, {0.10, 0.10, 0.10}, {1, 1, 1}, 0.0},
    {7, 0.028, {0.10, 0.12, 0.20}, {0, 1, 0}, 1e-4},
    {7, 0.028, {0.20, 0.10, 0.10}, {1, 0, 0}, 0.01},
    {3, 0.026, {0.05, 0.05, 0.05}, {1, 1, 1}, 0.002},
    {3, 0.026, {0.05, 0.05, 0.08}, {0, 0, 1}, 0.0},
};
enum { N_HUNTS = sizeof hunts / sizeof *hunts };

/* A pair that is listed late or never, or twice, changes the count. */
FACT_FOR_EACH(ls_5_15_every_touching_pair_is_found_among_radii_of_1_to_4,
              N_HUNTS)
{
    const struct hunt *const h = &hunts[_i];
    struct particles *const ps =
        spheres_cloud(h->n, 0.006, 3.0, h->pitch, 1.0, 11);
    struct dem_options o = spheres_options(&contact_linear, 5e-5, 0.0);
    struct dem_report r;
    int met = 0;
    long rebuilds = 0;

    for (int k = 0; k < 3; k++) {
        o.lo[k] = -h->half[k];
        o.hi[k] = h->half[k];
        o.periodic[k] = h->periodic[k];
    }
    o.skin = h->skin;
    o.material.stiffness = 1e5;
    struct dem *const dem = dem_create(ps, &o);
    for (int k = 0; k < 300; k++) {
        ck_assert_int_eq(dem_run(dem, 1 + k % 5, &r), 0);
        ck_assert_int_eq(r.contacts, count_touching(ps, &o));
        met += r.contacts;
        rebuilds += r.rebuilds;
    }
    ck_assert_int_gt(met, 10 * h->n); /* there were contacts */
    ck_assert_int_gt(rebuilds, 5);
    dem_free(dem);
    particles_free(ps);
}

/* Two spheres fly apart at 1 m/s each: a list with a skin of 1 mm, for the
 * places where they are, is good for N = skin / (2 v dt) = 50 steps. As it is
 * for those where they will be after 0.6 N, it is good for 1.6 N, and is made
 * anew in the step after that at the latest; as up to a quarter of the skin is
 * spent on margins it may last as long as N. Twice the speed, half the steps.
 */
FACT(ls_5_16_a_list_lasts_as_long_as_the_skin_is_wide)
{
    for (int twice = 0; twice < 2; twice++) {
        struct particles *const ps = particles_create(2);
        struct dem_options o = spheres_options(&contact_linear, 1e-5, 0.1);
        struct dem_report r;
        const double v = twice ? 2.0 : 1.0;

        spheres_throw(ps, spheres_add(ps, 0.0, 0.0, 0.002, 1e-3), v, 0.0, 0.0);
        spheres_throw(ps, spheres_add(ps, 0.0, 0.0, 0.0, 1e-3), -v, 0.0, 0.0);
        o.skin = 1e-3;
        struct dem *const dem = dem_create(ps, &o);
        ck_assert_int_eq(dem_run(dem, 4000, &r), 0);
        ck_assert_int_ge((int)r.rebuilds, 4000 / (twice ? 41 : 81));
        ck_assert_int_le((int)r.rebuilds, (twice ? 2 : 1) * 4000 / 50);
        dem_free(dem);
        particles_free(ps);
    }
}

/* The forces of 30 steps add up in another order, and a few collisions let
 * that grow from 1e-16; one contact overlooked for a step makes 1e-6. */
FACT(ls_5_15_the_skin_changes_nothing_but_the_work)
{
    struct particles *cloud[2];
    long rebuilds[2];

    for (int k = 0; k < 2; k++) {
        struct dem_options o = spheres_options(&contact_hertz, 2e-5, 0.06);
        struct dem_report r;
        cloud[k] = spheres_cloud(6, 0.01, 0.8, 0.0199, 4.0, 3);
        o.skin = k == 0 ? 5e-5 : 0.01;
        o.material.friction = 0.3;
        struct dem *const dem = dem_create(cloud[k], &o);
        ck_assert_int_eq(dem_run(dem, 300, &r), 0);
        rebuilds[k] = r.rebuilds;
        dem_free(dem);
    }
    ck_assert_int_gt(rebuilds[0], 10 * rebuilds[1]);
    for (int id = 0; id < cloud[0]->n; id++) {
        const int i = spheres_place(cloud[0], id);
        const int j = spheres_place(cloud[1], id);
        ck_assert_double_eq_tol(cloud[0]->x[i], cloud[1]->x[j], 1e-10);
        ck_assert_double_eq_tol(cloud[0]->vy[i], cloud[1]->vy[j], 1e-8);
    }
    particles_free(cloud[0]);
    particles_free(cloud[1]);
}

/* --- the history of a contact -----------------------------------------------
 */

/* Two spheres pressed together by P circle round each other, while friction
 * winds up against their unlike spins; the pair crosses cells in all
 * directions, so that now one and now the other comes first. Two more lie in
 * far corners, so that there are cells. */
struct pressed_pair {
    struct particles *ps;
    struct dem *dem;
    int swaps;
    long rebuilds;
};

static struct pressed_pair press(double skin, const int periodic[3],
                                 double rolling)
{
    struct pressed_pair q = {particles_create(4), NULL, 0, 0};
    struct dem_options o = spheres_options(&contact_linear, 2e-6, 0.1);

    o.material.friction = 0.8;
    o.material.restitution = 0.7;
    o.skin = skin;
    for (int k = 0; k < 3; k++)
        o.periodic[k] = periodic[k];
    o.material.rolling = rolling;
    spheres_add(q.ps, 0.0001, 0.0002, 0.0049, 0.01);
    spheres_add(q.ps, 0.0001, 0.0002, -0.0050, 0.01);
    spheres_add(q.ps, 0.09, 0.09, 0.09, 0.01);
    spheres_add(q.ps, -0.09, -0.09, -0.09, 0.01);
    for (int i = 0; i < 2; i++) {
        const double sign = i == 0 ? 1.0 : -1.0;
        spheres_throw(q.ps, i, sign * 2.0, sign * 1.0, 0.2);
        spheres_spin(q.ps, i, 40.0, 20.0, -30.0 * sign);
    }
    q.dem = dem_create(q.ps, &o);
    return q;
}

/* `bursts` of 20 steps, P = 8 N along the line of centres of each. */
static void whirl(struct pressed_pair *q, int bursts, double period)
{
    struct particles *const ps = q->ps;

    for (int k = 0; k < bursts; k++) {
        const int i = spheres_place(ps, 0), j = spheres_place(ps, 1);
        double d[3] = {ps->x[j] - ps->x[i], ps->y[j] - ps->y[i],
                       ps->z[j] - ps->z[i]};
        struct dem_report r;
        for (int a = 0; a < 3 && period > 0.0; a++)
            d[a] -= period * rint(d[a] / period);
        const double per = 8.0 / sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        ps->ex[i] = d[0] * per, ps->ex[j] = -ps->ex[i];
        ps->ey[i] = d[1] * per, ps->ey[j] = -ps->ey[i];
        ps->ez[i] = d[2] * per, ps->ez[j] = -ps->ez[i];
        ck_assert_int_eq(dem_run(q->dem, 20, &r), 0);
        q->rebuilds += r.rebuilds;
        q->swaps += (spheres_place(ps, 0) < spheres_place(ps, 1)) != (i < j);
    }
}

static void release(struct pressed_pair *q)
{
    dem_free(q->dem);
    particles_free(q->ps);
}

/* Without a rebuild the spring never moves. Rounding alone differs; a spring
 * lost, or kept with the wrong sign when the owner changes, shows in the third
 * digit of the spin. */
static void survive(int open, double rolling)
{
    const int periodic[3] = {open, open, open};
    const double period = open ? 0.2 : 0.0;
    struct pressed_pair calm = press(0.085, periodic, rolling);
    struct pressed_pair busy = press(2e-6, periodic, rolling);

    whirl(&calm, 500, period);
    whirl(&busy, 500, period);
    ck_assert_int_eq(calm.rebuilds, 1);
    ck_assert_int_gt(busy.rebuilds, 1000);
    ck_assert_int_gt(busy.swaps, 2);
    for (int id = 0; id < 2; id++) {
        const int i = spheres_place(calm.ps, id);
        const int j = spheres_place(busy.ps, id);
        ck_assert_double_eq_tol(calm.ps->x[i], busy.ps->x[j], 1e-12);
        ck_assert_double_eq_tol(calm.ps->z[i], busy.ps->z[j], 1e-12);
        ck_assert_double_eq_tol(calm.ps->wx[i], busy.ps->wx[j], 1e-7);
        ck_assert_double_eq_tol(calm.ps->wz[i], busy.ps->wz[j], 1e-7);
    }
    release(&calm);
    release(&busy);
}

FACT_FOR_EACH(ls_4_8_the_spring_survives_rebuilds_and_a_change_of_owner, 2)
{
    survive(_i, 0.0);
}

FACT_FOR_EACH(the_spring_of_rolling_survives_them_too, 2)
{
    survive(_i, 0.2);
}

/* The same over a wall: a sphere is pressed on the floor, spun and dragged. */
FACT(ls_4_8_the_spring_of_a_wall_survives_rebuilds)
{
    double x[2], w[2];
    long rebuilds[2];

    for (int k = 0; k < 2; k++) {
        struct particles *const ps = particles_create(1);
        struct dem_options o = spheres_options(&contact_hertz, 2e-6, 0.05);
        struct dem_report r;
        o.material.friction = 0.5;
        o.skin = k == 0 ? 1e-6 : 0.2;
        spheres_add(ps, -0.04, -0.045, 0.0, 0.01);
        spheres_throw(ps, 0, 1.0, 0.0, 0.0);
        spheres_spin(ps, 0, 0.0, 0.0, -150.0);
        ps->ey[0] = -0.5;
        struct dem *const dem = dem_create(ps, &o);
        ck_assert_int_eq(dem_run(dem, 5000, &r), 0);
        x[k] = ps->x[0];
        w[k] = ps->wz[0];
        rebuilds[k] = r.rebuilds;
        dem_free(dem);
        particles_free(ps);
    }
    ck_assert_int_gt(rebuilds[0], 2500);
    ck_assert_int_eq(rebuilds[1], 1);
    ck_assert_double_eq_tol(x[0], x[1], 1e-13);
    ck_assert_double_eq_tol(w[0], w[1], 1e-8);
}

/* --- sorting
 * ------------------------------------------------------------------ */

FACT(what_belongs_to_a_particle_follows_it_when_particles_are_sorted)
{
    struct particles *const ps = spheres_cloud(6, 0.006, 1.0, 0.012, 3.0, 5);
    struct dem_options o = spheres_options(&contact_linear, 2e-5, 0.04);
    double *const pair = calloc(2 * (size_t)ps->n, sizeof *pair);
    double *const d = calloc((size_t)ps->n, sizeof *d);
    struct dem_report r;
    int moved = 0;

    o.skin = 5e-4;
    for (int i = 0; i < ps->n; i++) {
        d[i] = ps->d[i];
        pair[2 * i] = i;
        pair[2 * i + 1] = -i;
        ps->ez[i] = 1e-6 * i;
    }
    particles_attach(ps, "pair", "-", pair, 2);
    struct dem *const dem = dem_create(ps, &o);
    ck_assert_int_eq(dem_run(dem, 400, &r), 0);
    ck_assert_int_gt(r.rebuilds, 20);
    for (int i = 0; i < ps->n; i++) {
        const int id = ps->id[i];
        moved += id != i;
        ck_assert_double_eq(ps->d[i], d[id]);
        ck_assert_double_eq(pair[2 * i], id);
        ck_assert_double_eq(pair[2 * i + 1], -id);
        ck_assert_double_eq(ps->ez[i], 1e-6 * id);
    }
    ck_assert_int_gt(moved, 100);
    dem_free(dem);
    particles_free(ps);
    free(pair);
    free(d);
}

/* --- threads
 * ------------------------------------------------------------------ */

/* 4096 spheres: enough to be cut in four. Several runs of a few steps, as in
 * the coupling with a fluid. */
FACT_FOR_EACH(thrown_spheres_have_the_same_bits_with_1_2_and_3_threads, 2)
{
    struct particles *cloud[3];
    long rebuilds = 0;

    for (int k = 0; k < 3; k++) {
        struct dem_options o = spheres_options(
            _i == 0 ? &contact_hertz : &contact_linear, 4e-5, 0.08);
        struct dem_report r;
        omp_set_num_threads(k + 1);
        o.material.friction = 0.3;
        o.material.restitution = 0.9;
        o.periodic[0] = o.periodic[2] = _i;
        o.skin = 5e-4;
        cloud[k] = spheres_cloud(16, 0.006, 0.6, 0.00999, 3.0, 9);
        struct dem *const dem = dem_create(cloud[k], &o);
        for (int run = 0; run < 10; run++) {
            ck_assert_int_eq(dem_run(dem, 6, &r), 0);
            rebuilds += r.rebuilds;
        }
        ck_assert_int_gt(r.contacts, 500);
        dem_free(dem);
    }
    ck_assert_int_gt(rebuilds, 3 * 15);
    for (int k = 1; k < 3; k++) {
        const size_t size = (size_t)cloud[0]->n * sizeof(double);
        ck_assert_mem_eq(cloud[0]->id, cloud[k]->id, size / 2);
        ck_assert_mem_eq(cloud[0]->x, cloud[k]->x, size);
        ck_assert_mem_eq(cloud[0]->vz, cloud[k]->vz, size);
        ck_assert_mem_eq(cloud[0]->wy, cloud[k]->wy, size);
        ck_assert_mem_eq(cloud[0]->cfy, cloud[k]->cfy, size);
    }
    for (int k = 0; k < 3; k++)
        particles_free(cloud[k]);
}

/* In a single chunk the last particles touch the first ones across a period.
 * With few contacts these are computed with those of the first of its blocks,
 * long before the block of the last ones; what that block clears it may not
 * lose. A cube of 10^3 spheres with gaps, of which some were moved into each
 * other: three pairs round the periods, four inside and at the beginning.
 * Tolerance: rounding. */
FACT(contacts_round_a_period_push_both_spheres_alike)
{
    struct dem_options o = spheres_options(&contact_linear, 1e-5, 6.0);
    struct particles *const ps = particles_create(1000);
    double sum[3] = {0.0, 0.0, 0.0}, gross = 0.0;
    struct dem_report r;

    for (int i = 0; i < 1000; i++) {
        const int at[3] = {i % 10, i / 10 % 10, i / 100};
        double x[3];
        for (int k = 0; k < 3; k++) {
            const int a = at[(k + 1) % 3], c = at[(k + 2) % 3];
            x[k] = 1.2 * at[k] - 5.4;
            if (a == 4 && c == 6 && at[k] % 9 == 0)
                x[k] += at[k] == 0 ? -0.15 : 0.15;
        }
        if (at[0] == 3 && at[1] == at[2] && at[1] < 4) x[0] += 0.3;
        spheres_add(ps, x[0], x[1], x[2], 1.0);
    }
    for (int k = 0; k < 3; k++)
        o.periodic[k] = 1;
    struct dem *const dem = dem_create(ps, &o);
    ck_assert_int_eq(dem_run(dem, 2, &r), 0);
    ck_assert_int_eq(r.contacts, 7);
    for (int i = 0; i < ps->n; i++) {
        const double v[3] = {ps->vx[i], ps->vy[i], ps->vz[i]};
        for (int k = 0; k < 3; k++) {
            sum[k] += v[k];
            gross += fabs(v[k]);
        }
    }
    for (int k = 0; k < 3; k++)
        ck_assert_double_eq_tol(sum[k], 0.0, 1e-12 * gross);
    dem_free(dem);
    particles_free(ps);
}

/* With link cells the pairs are sought in each step, and the springs go from
 * step to step all the same: 216 spheres that collide with friction move alike,
 * up to the order of sums. */
FACT_FOR_EACH(link_cells_move_particles_as_the_list_does, 2)
{
    struct particles *moved[2];
    struct dem_report r[2];

    for (int k = 0; k < 2; k++) {
        struct dem_options o = spheres_options(contact_laws[_i], 1e-5, 0.03);
        o.material.friction = 0.3;
        o.material.restitution = 0.9;
        o.periodic[0] = 1;
        if (k == 1) o.method = &reference_link_cells;
        moved[k] = spheres_cloud(6, 0.005, 0.5, 0.0095, 1.0, 4);
        struct dem *const dem = dem_create(moved[k], &o);
        ck_assert_int_eq(dem_run(dem, 300, &r[k]), 0);
        dem_free(dem);
    }
    ck_assert_int_ge((int)r[1].rebuilds, 300);
    ck_assert_int_lt((int)r[0].rebuilds, 100);
    ck_assert_int_eq(r[0].contacts, r[1].contacts);
    ck_assert_int_gt(r[0].contacts, 10);
    for (int id = 0; id < moved[0]->n; id++) {
        const int i = spheres_place(moved[0], id);
        const int j = spheres_place(moved[1], id);
        ck_assert_double_eq_tol(moved[0]->vx[i], moved[1]->vx[j], 1e-9);
        ck_assert_double_eq_tol(moved[0]->wz[i], moved[1]->wz[j], 1e-6);
    }
    particles_free(moved[0]);
    particles_free(moved[1]);
}

/* Eight chunks, of which the upper four have contacts and the lower ones none.
 * Of 10, 20, 30 and 40 the middles are at 5, 20, 45 and 80 of 100, and the
 * third ends above the half; of 10, 20, 60 and 10 at 5, 20, 60 and 95, and the
 * third begins below it. */
FACT_FOR_EACH(a_chunk_belongs_to_the_thread_of_the_midpoint_of_its_work, 2)
{
    const double lo[3] = {0.0, 0.0, 0.0}, hi[3] = {1.0, 1.0, 1.0};
    const int walls[3] = {0, 0, 0};
    const struct box_domain box = box_domain_of(lo, hi, walls);
    struct particles *const ps = particles_create(8000);
    struct neighbours *const nb = neighbours_create(ps, &box);
    struct chunk_range share[2] = {{0, 0}, {0, 0}};

    static const int contacts[2][4] = {{10, 20, 30, 40}, {10, 20, 60, 10}};
    const int first_of_second = _i == 0 ? 7 : 6;

    ck_assert_int_eq(nb->n_chunks, 8);
    for (int s = 4; s < 8; s++)
        nb->chunks[s].contacts.n_pairs = contacts[_i][s - 4];
#pragma omp parallel num_threads(2)
    share[omp_get_thread_num()] = neighbours_balanced_range(nb);
    ck_assert_int_eq(share[0].first, 0);
    ck_assert_int_eq(share[0].last, first_of_second);
    ck_assert_int_eq(share[1].first, first_of_second);
    ck_assert_int_eq(share[1].last, 8);
    neighbours_free(nb);
    particles_free(ps);
}
