/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The grid finds all pairs, at walls, across periodic ends and between chunks;
 * and tangential displacements stay with their pairs in any order of the
 * particles. */
#include <omp.h>
#include <stdlib.h>
#include <string.h>

#include "dem/fast/neighbours.h"
#include "facts.h"
#include "spheres.h"

static struct dem_options box(const char *law, double x, double y, double z,
                              int px, int py, int pz)
{
    struct dem_options o = spheres_options(contact_law_named(law), 2e-5, 1.0);

    o.material.stiffness = 500.0;
    o.material.young = 1e6;
    for (int k = 0; k < 3; k++)
        o.lo[k] = 0.0;
    o.hi[0] = x, o.hi[1] = y, o.hi[2] = z;
    o.periodic[0] = px, o.periodic[1] = py, o.periodic[2] = pz;
    return o;
}

/* n spheres of d (1 - spread) ... d (1 + spread) on a lattice from one corner
 * of the box on, thrown and spinning at up to v in each direction. */
static struct particles *cloud(const struct dem_options *o, int n, double d,
                               double spread, double v, uint64_t seed)
{
    struct particles *const ps = particles_create(n);
    const double a = 1.05 * d * (1.0 + spread);
    int m[3];

    for (int k = 0; k < 3; k++)
        m[k] = (int)((o->hi[k] - o->lo[k]) / a);
    for (int i = 0; i < n; i++) {
        const int site[3] = {i % m[0], i / m[0] % m[1], i / m[0] / m[1]};
        double r[7];
        for (int k = 0; k < 7; k++)
            r[k] = spheres_random(&seed);
        spheres_add(ps, o->lo[0] + (site[0] + 0.5) * a,
                    o->lo[1] + (site[1] + 0.5) * a,
                    o->lo[2] + (site[2] + 0.5) * a, d * (1.0 + spread * r[6]));
        spheres_throw(ps, i, v * r[0], v * r[1], v * r[2]);
        spheres_spin(ps, i, v / d * r[3], v / d * r[4], v / d * r[5]);
    }
    return ps;
}

static void add_force(double F[3], double delta, const double n[3], double k)
{
    if (delta <= 0.0) return;
    for (int a = 0; a < 3; a++)
        F[a] += k * delta * n[a];
}

/* The sum of k delta n over all pairs and walls: law "linear", e = 1, no
 * friction. */
static void force_on(const struct particles *ps, const struct dem_options *o,
                     int i, double F[3])
{
    const double x[3] = {ps->x[i], ps->y[i], ps->z[i]};
    const double k = o->material.stiffness, R = 0.5 * ps->d[i];

    F[0] = F[1] = F[2] = 0.0;
    for (int j = 0; j < ps->n; j++) {
        double n[3] = {x[0] - ps->x[j], x[1] - ps->y[j], x[2] - ps->z[j]};
        for (int a = 0; a < 3; a++) {
            const double L = o->hi[a] - o->lo[a];
            if (o->periodic[a]) n[a] -= L * rint(n[a] / L);
        }
        const double r = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        for (int a = 0; a < 3; a++)
            n[a] /= r;
        if (j != i) add_force(F, R + 0.5 * ps->d[j] - r, n, k);
    }
    for (int a = 0; a < 3; a++) {
        double n[3] = {0.0, 0.0, 0.0};
        if (o->periodic[a]) continue;
        n[a] = 1.0;
        add_force(F, R - (x[a] - o->lo[a]), n, k);
        n[a] = -1.0;
        add_force(F, R - (o->hi[a] - x[a]), n, k);
    }
}

/* Forces of up to 0.1 N: a contact that is missed shows unless it is shallower
 * than 2e-15 m. */
static void compare_forces(struct dem_options o, int n, double spread)
{
    struct particles *const ps = cloud(&o, n, 1e-3, spread, 0.5, 5);
    struct dem *const dem = dem_create(ps, &o);
    struct dem_report r;
    int rebuilds = 0, contacts = 0;

    for (int look = 0; look < 6; look++) {
        ck_assert_int_eq(dem_run(dem, 100, &r), 0);
        rebuilds += (int)r.rebuilds;
        contacts += r.contacts;
        for (int i = 0; i < ps->n; i++) {
            double F[3];
            force_on(ps, &o, i, F);
            ck_assert_double_eq_tol(ps->cfx[i], F[0], 1e-12);
            ck_assert_double_eq_tol(ps->cfy[i], F[1], 1e-12);
            ck_assert_double_eq_tol(ps->cfz[i], F[2], 1e-12);
        }
    }
    ck_assert_int_gt(rebuilds, 5);
    ck_assert_int_gt(contacts, 50);
    dem_free(dem);
    particles_free(ps);
}

FACT(ls_5_15_list_finds_all_pairs_between_walls)
{
    compare_forces(box("linear", 8e-3, 20e-3, 8e-3, 0, 0, 0), 300, 0.3);
}

/* y is the slowest direction, and so short in z that there are two cells. */
FACT(ls_5_15_list_finds_all_pairs_across_periodic_ends)
{
    compare_forces(box("linear", 8e-3, 20e-3, 4e-3, 1, 1, 1), 250, 0.2);
    compare_forces(box("linear", 8e-3, 20e-3, 6e-3, 0, 1, 0), 300, 0.2);
    compare_forces(box("linear", 8e-3, 20e-3, 6e-3, 1, 0, 1), 300, 0.2);
}

/* Several chunks (2100 particles: two), also around the periodic end. */
FACT(ls_5_15_list_finds_all_pairs_between_chunks)
{
    compare_forces(box("linear", 15e-3, 20e-3, 15e-3, 0, 0, 0), 2100, 0.1);
    compare_forces(box("linear", 15e-3, 20e-3, 15e-3, 0, 1, 0), 2100, 0.1);
}

/* Pairs with a gap of at most `skin` where they will be after `ahead`. */
static int near_pairs(const struct particles *ps, const struct dem_options *o,
                      double skin, double ahead)
{
    const double *const x[] = {ps->x, ps->y, ps->z};
    const double *const v[] = {ps->vx, ps->vy, ps->vz};
    int n = 0;

    for (int i = 0; i < ps->n; i++)
        for (int j = 0; j < i; j++) {
            double r2 = 0.0;
            for (int k = 0; k < 3; k++) {
                const double L = o->hi[k] - o->lo[k];
                const double dx =
                    x[k][i] - x[k][j] + ahead * (v[k][i] - v[k][j]);
                const double near = o->periodic[k] ? dx - L * rint(dx / L) : dx;
                r2 += near * near;
            }
            n += sqrt(r2) - 0.5 * (ps->d[i] + ps->d[j]) <= skin;
        }
    return n;
}

/* The list has the pairs that all comparisons find where the particles will be,
 * the fastest 0.3 skins from where it is: other pairs than those of now. */
FACT_FOR_EACH(ls_5_15_the_list_is_for_the_places_a_little_later, 2)
{
    const struct dem_options o = box("linear", 8e-3, 20e-3, 8e-3, _i, _i, _i);
    struct particles *const ps = cloud(&o, 600, 1e-3, 0.0, 1.0, 5);
    const struct box_domain b = box_domain_of(o.lo, o.hi, o.periodic);
    struct neighbours *const nb = neighbours_create(ps, &b);
    int found = 0;

    nb->skin = 0.999e-3; /* cells hardly wider than d + skin */
    neighbours_begin_run(nb, 1);
    neighbours_load(nb);
    ck_assert_double_gt(neighbours_refresh(nb, 1e-6, 0.0), 0.0);
    for (int s = 0; s < nb->n_chunks; s++)
        found += nb->chunks[s].pairs.n;
    ck_assert_int_eq(found, near_pairs(ps, &o, nb->skin, nb->ahead));
    ck_assert_int_ne(found, near_pairs(ps, &o, nb->skin, 0.0));
    neighbours_free(nb);
    particles_free(ps);
}

static struct particles *thrown(const struct dem_options *o, int n, int threads)
{
    struct particles *const ps = cloud(o, n, 1e-3, 0.1, 1.0, 9);
    struct dem *const dem = dem_create(ps, o);
    struct dem_report r;
    long rebuilds = 0;

    omp_set_num_threads(threads);
    for (int i = 0; i < n; i++)
        ps->ey[i] = -9.81 * ps->m[i];
    for (int k = 0; k < 8; k++) {
        ck_assert_int_eq(dem_run(dem, 25, &r), 0);
        rebuilds += r.rebuilds;
    }
    ck_assert_int_gt((int)rebuilds, 5);
    dem_free(dem);
    return ps;
}

/* 4100 particles are four chunks; the last adds loads to the first. */
FACT(same_bits_for_any_threads_around_a_periodic_end)
{
    struct dem_options o = box("hertz", 20e-3, 25e-3, 20e-3, 0, 1, 0);

    o.material.friction = 0.4;
    o.material.restitution = 0.8;
    struct particles *const one = thrown(&o, 4100, 1);
    struct particles *const many = thrown(&o, 4100, 3);
    const size_t size = (size_t)one->n * sizeof(double);
    ck_assert_mem_eq(one->x, many->x, size);
    ck_assert_mem_eq(one->vy, many->vy, size);
    ck_assert_mem_eq(one->wz, many->wz, size);
    ck_assert_mem_eq(one->cfx, many->cfx, size);
    ck_assert_mem_eq(one->id, many->id, (size_t)one->n * sizeof(int));
    particles_free(many);
    particles_free(one);
}

/* A heap of rough grains goes on alike when it is sorted anew every few steps
 * and when it is not: the springs stay with their pairs, and change sign where
 * owner and partner swap. (With e = 1 now: a start takes the damping force of v
 * now, and not of half a step before.) Losing a spring changes v by 1e-3 m/s
 * here; the order of the sums, by rounding that a heap amplifies. */
FACT(springs_find_their_pairs_in_any_order)
{
    struct dem_options o = box("linear", 6e-3, 8e-3, 6e-3, 0, 0, 0);
    struct particles *const a = cloud(&o, 150, 1e-3, 0.1, 0.1, 4);
    struct particles *const b = cloud(&o, 150, 1e-3, 0.1, 0.1, 4);
    struct dem_report r;
    int order[150];

    o.material.friction = 0.5;
    o.material.restitution = 0.3;
    for (int i = 0; i < 150; i++) {
        a->ey[i] = b->ey[i] = -9.81 * a->m[i];
        order[i] = 149 - i;
    }
    struct dem *const at = dem_create(a, &o), *const bt = dem_create(b, &o);
    dem_run(at, 3000, &r);
    dem_run(bt, 3000, &r);
    ck_assert_int_gt(r.contacts, 200);
    o.material.restitution = 1.0;
    dem_change_material(at, &o.material);
    dem_change_material(bt, &o.material);
    dem_run(at, 5, &r);
    dem_run(bt, 5, &r);
    for (int k = 0; k < 20; k++) {
        int n;
        struct dem_history *const list = dem_histories(bt, &n);
        dem_run(at, 5, &r);
        particles_permute(b, order); /* and all particles change places */
        dem_restore_histories(bt, list, n);
        dem_run(bt, 5, &r);
        free(list);
    }
    for (int id = 0; id < 150; id++) {
        const int i = spheres_place(a, id), j = spheres_place(b, id);
        ck_assert_double_eq_tol(a->vx[i], b->vx[j], 1e-8);
        ck_assert_double_eq_tol(a->vy[i], b->vy[j], 1e-8);
    }
    dem_free(at);
    dem_free(bt);
    particles_free(a);
    particles_free(b);
}
