/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "mesh/poly/poly.h"
#include "averaging/poly/facets.h"

#include <gsl/gsl_math.h>
#include <stdio.h>
#include <string.h>

#include "averaging/more/overlap.h"
#include "base/alloc.h"
#include "cloud.h"
#include "facts.h"

static const double ball = 4.0 / 3.0 * M_PI;

/* A regular tetrahedron in the cube from -1 to 1: edges of sqrt 8, the faces
 * 1 / sqrt 3 from the middle. */
static const double regular[4][3] = {
    {1.0, 1.0, 1.0}, {1.0, -1.0, -1.0}, {-1.0, 1.0, -1.0}, {-1.0, -1.0, 1.0}};

/* A mesh of one cell. */
static struct mesh *tetrahedron(const double p[4][3])
{
    static const int corner[4][3] = {
        {0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
    struct poly_raw r = {.n_cells = 1, .n_points = 4, .n_faces = 4};

    r.point = alloc_doubles(12);
    memcpy(r.point, p, 12 * sizeof(double));
    r.start = alloc_ints(5);
    r.corner = alloc_ints(12);
    memcpy(r.corner, corner, sizeof corner);
    for (int f = 0; f < 4; f++)
        r.start[f + 1] = 3 * f + 3;
    r.owner = alloc_ints(4);
    r.n_parts = 1;
    r.part = alloc_zeroed(1, sizeof *r.part);
    r.part[0] = (struct poly_part){.name = "all", .type = "patch", .n = 4};
    struct mesh *const m = poly_build(&r, "a tetrahedron");
    poly_raw_release(&r);
    ck_assert_ptr_nonnull(m);
    return m;
}

static struct mesh *lattice(int n, const double shear[3])
{
    const struct box_spec spec = {
        {n, n, n}, {n, n, n}, {1.0, 1.0, 1.0}, {0, 0, 0}};
    return mesh_create_sheared(&spec, shear);
}

/* Moves every point inside by up to so much: faces are bent. */
static void shake(struct mesh *m, double most, uint64_t seed)
{
    for (int i = 0; i < m->shape->n_points; i++) {
        double *const x = &m->shape->point[3 * i];
        int inside = 1;
        for (int k = 0; k < 3; k++)
            inside &= x[k] > m->lo[k] && x[k] < m->hi[k];
        for (int k = 0; k < 3; k++)
            x[k] += inside * most * (2.0 * cloud_random(&seed) - 1.0);
    }
}

/* The closed values: with the corner's solid angle arccos(23/27), with the
 * angle arccos(1/3) between two faces, half a ball, a ball less four caps that
 * touch each other, all of the ball, all of the tetrahedron. */
FACT(a_ball_on_and_in_a_tetrahedron)
{
    struct mesh *const m = tetrahedron(regular);
    struct facets *const f = facets_create(m);
    const double h = 1.0 / sqrt(3.0), o[3] = {0.0, 0.0, 0.0};
    const double edge[3] = {1.0, 0.0, 0.0};
    const double face[3] = {1.0 / 3.0, 1.0 / 3.0, -1.0 / 3.0};
    const double cap = M_PI / 3.0 * gsl_pow_2(1.0 - h) * (2.0 + h);

    ck_assert_double_eq_tol(facets_in_sphere(f, 0, regular[0], 1.5),
                            gsl_pow_3(1.5) / 3.0 * acos(23.0 / 27.0), 1e-14);
    ck_assert_double_eq_tol(facets_in_sphere(f, 0, edge, 0.8),
                            gsl_pow_3(0.8) * 2.0 / 3.0 * acos(1.0 / 3.0),
                            1e-14);
    ck_assert_double_eq_tol(facets_in_sphere(f, 0, face, 0.3),
                            ball / 2.0 * gsl_pow_3(0.3), 1e-15);
    ck_assert_double_eq_tol(facets_in_sphere(f, 0, o, 1.0), ball - 4.0 * cap,
                            1e-14);
    ck_assert_double_eq_tol(facets_in_sphere(f, 0, o, h), ball * gsl_pow_3(h),
                            1e-14);
    ck_assert_double_eq_tol(facets_in_sphere(f, 0, o, sqrt(3.0)), 8.0 / 3.0,
                            1e-14);
    ck_assert_double_eq_tol(facets_in_sphere(f, 0, o, 1.4),
                            facets_in_sphere(f, 0, o, 1.4 + 1e-12), 1e-10);
    owner_free(f);
    mesh_free(m);
}

/* A cube of edge 2 R around a corner of it: of three numbers up to R, half
 * satisfy the triangle inequality, by the symmetry of the three faces. */
FACT(a_cube_on_and_in_a_tetrahedron)
{
    struct mesh *const m = tetrahedron(regular);
    struct facets *const f = facets_create(m);
    const double middle[3] = {0.0, 0.0, 0.0};

    ck_assert_double_eq_tol(facets_overlap(f, FACETS_CUBE, 0, regular[0], 0.5),
                            0.0625, 1e-15);
    ck_assert_double_eq_tol(facets_overlap(f, FACETS_CUBE, 0, middle, 1.0),
                            8.0 / 3.0, 1e-14);
    ck_assert_double_eq_tol(facets_overlap(f, FACETS_CUBE, 0, middle, 0.2),
                            0.064, 1e-15);
    owner_free(f);
    mesh_free(m);
}

/* Where tetrahedron p is above (x, y): from z[0] to z[1]. */
static void column(const struct facets *f, double x, double y, double z[2])
{
    z[0] = -INFINITY;
    z[1] = INFINITY;
    for (int j = 0; j < 4; j++) {
        const double *const n = &f->normal[3 * j];
        const double *const a = &f->point[3 * f->corner[f->start[j]]];
        const double at = a[2] + (n[0] * (a[0] - x) + n[1] * (a[1] - y)) / n[2];
        if (n[2] > 0.0)
            z[1] = fmin(z[1], at);
        else
            z[0] = fmax(z[0], at);
    }
}

/* Any tetrahedron, anywhere, against a sum over 1000 x 1000 columns: as exact
 * as that is. */
FACT_FOR_EACH(the_flux_is_the_volume, 8)
{
    enum { N = 1000 };
    double p[4][3], sum = 0.0;

    cloud_numbers((uint64_t)(40 + _i), 12, p[0]);
    double u[3][3];
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            u[i][k] = p[i + 1][k] - p[0][k];
    const double six = u[0][0] * (u[1][1] * u[2][2] - u[1][2] * u[2][1]) -
                       u[0][1] * (u[1][0] * u[2][2] - u[1][2] * u[2][0]) +
                       u[0][2] * (u[1][0] * u[2][1] - u[1][1] * u[2][0]);
    if (six > 0.0) { /* the faces of `tetrahedron` are for the other kind */
        double q[3];
        memcpy(q, p[1], sizeof q);
        memcpy(p[1], p[2], sizeof q);
        memcpy(p[2], q, sizeof q);
    }
    struct mesh *const m = tetrahedron((const double(*)[3])p);
    struct facets *const f = facets_create(m);
    const double R = 0.3 + 0.1 * _i, o[3] = {0.1, -0.05 * _i, 0.2};

    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            const double x = R * (2.0 * (i + 0.5) / N - 1.0);
            const double y = R * (2.0 * (j + 0.5) / N - 1.0);
            const double half2 = R * R - x * x - y * y;
            double z[2];
            if (half2 <= 0.0) continue;
            column(f, o[0] + x, o[1] + y, z);
            sum += fmax(0.0, fmin(z[1], o[2] + sqrt(half2)) -
                                 fmax(z[0], o[2] - sqrt(half2)));
        }
    ck_assert_double_eq_tol(facets_in_sphere(f, 0, o, R),
                            sum * 4.0 * R * R / N / N, 2e-5);
    ck_assert_double_gt(f->V[0], 0.0);
    owner_free(f);
    mesh_free(m);
}

/* The code for boxes and the code for all cells agree: bodies of a twentieth of
 * a cell up to four, centres on faces and corners among them. */
FACT(a_box_by_its_facets_is_the_box)
{
    struct mesh *const m = lattice(1, (const double[3]){0.0, 0.0, 0.0});
    struct facets *const f = facets_create(m);
    uint64_t state = 8;

    for (int i = 0; i < 4000; i++) {
        const double R = 0.05 * exp(4.4 * cloud_random(&state));
        double o[3], lo[3], hi[3];
        for (int k = 0; k < 3; k++) {
            o[k] = 3.0 * cloud_random(&state) - 1.0;
            if (cloud_random(&state) < 0.2) o[k] = floor(o[k] + 0.5);
            lo[k] = -o[k];
            hi[k] = 1.0 - o[k];
        }
        const double from[3] = {o[0] - 0.5, o[1] - 0.5, o[2] - 0.5};
        const double tol = 1e-14 * fmax(1.0, R * R * R);
        ck_assert_double_eq_tol(facets_in_sphere(f, 0, o, R),
                                overlap_sphere(R, lo, hi), tol);
        ck_assert_double_eq_tol(facets_overlap(f, FACETS_CUBE, 0, from, R),
                                overlap_cube(R, lo, hi), tol);
    }
    owner_free(f);
    mesh_free(m);
}

/* Bodies wholly inside any mesh: their parts add up to them, and no part is
 * more than the cell or than the part of the cube. Cells with oblique, bent and
 * many faces; bodies much smaller than cells and larger. To 1e-14 but for the
 * dual, whose file has 12 digits: its faces are flat to 1e-12 and count as
 * that. */
static void add_up(struct mesh *m, double least, double most)
{
    struct facets *const f = facets_create(m);
    uint64_t state = 5;

    for (int i = 0; i < 30; i++) {
        const double R = least + (most - least) * i / 29.0;
        double o[3], lo[3], hi[3], sum[2] = {0.0, 0.0};
        for (int k = 0; k < 3; k++) {
            const double width = m->hi[k] - m->lo[k];
            o[k] = m->lo[k] + width * (0.3 + 0.4 * cloud_random(&state));
            lo[k] = o[k] - R;
            hi[k] = o[k] + R;
        }
        for (int c = 0; c < m->n_cells; c++) {
            const double V = facets_in_sphere(f, c, o, R);
            const double in_cube = facets_in_box(f, c, lo, hi);
            ck_assert_double_ge(V, 0.0);
            ck_assert_double_le(V, f->V[c] * (1.0 + 1e-12) + 1e-14 * R * R * R);
            ck_assert_double_le(V, in_cube + 1e-13 * R * R * R);
            sum[0] += V;
            sum[1] += in_cube;
        }
        ck_assert_double_eq_tol(sum[0] / (R * R * R), ball, 5e-12);
        ck_assert_double_eq_tol(sum[1] / (R * R * R), 8.0, 5e-12);
    }
    owner_free(f);
}

FACT_FOR_EACH(the_parts_of_a_ball_in_any_cells_add_up_to_it, 5)
{
    static const char *const files[] = {"box", "shuffled", "dual"};
    struct mesh *m;

    if (_i < 3) {
        char dir[64];
        snprintf(dir, sizeof dir, "tests/data/poly/%s", files[_i]);
        m = poly_read(dir, NULL);
    } else {
        m = lattice(5, (const double[3]){0.0, 0.0, 0.0});
        shake(m, _i == 3 ? 0.1 : 0.3, 3);
    }
    ck_assert_ptr_nonnull(m);
    const double width = m->hi[0] - m->lo[0];
    add_up(m, 0.002 * width, 0.2 * fmin(width, m->hi[2] - m->lo[2]));
    mesh_free(m);
}
