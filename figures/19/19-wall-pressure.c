/* SPDX-License-Identifier: GPL-3.0-or-later */
/* 19-wall-pressure.c -- the order of the pressure in the lid-driven cavity,
 * Re = 100, t = 5: of each two meshes, of which the finer one has twice the
 * cells a side, the difference of u, of p and of p on the floor (root mean
 * square, of the lower three quarters: in the corners of the lid the pressure
 * is infinite), and the order that two differences show; then, of flows made
 * for the equations on 32 x 32 cells, the errors of u, p and p at the walls,
 * and their orders from 16 x 16.
 *
 *   sh figures/run.sh figures/19/19-wall-pressure.c [PATCH]
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "manufactured.h"

enum { FIRST = 16, MESHES = 4, MOST = 128 };

/* The fields of a mesh of n x n cells. */
struct fields {
    int n;
    double u[MOST * MOST], v[MOST * MOST], p[MOST * MOST], floor[MOST];
};

static void step_to(struct fluid *fl, double end)
{
    while (fl->t < end - 1e-9)
        if (fluid_step(fl) != 0) exit(3);
}

/* The pressure less its mean. */
static void take(const struct fluid *fl, int n, struct fields *to)
{
    const struct mesh *const m = fl->mesh;
    const struct patch *const bottom = mesh_patch(m, "bottom");
    const int part = n * (n * 3 / 4);
    double mean = 0.0;

    to->n = n;
    for (int c = 0; c < part; c++)
        mean += fl->p[c] / part;
    for (int c = 0; c < n * n; c++) {
        to->u[c] = fl->u[3 * c], to->v[c] = fl->u[3 * c + 1];
        to->p[c] = fl->p[c] - mean;
    }
    for (int j = 0; j < n; j++)
        to->floor[m->owner[bottom->first + j]] =
            fl->p_face[bottom->first + j] - mean;
}

static void compute(int n, struct fields *to)
{
    const struct box_spec spec = {
        {1.0, 1.0, 1.0}, {n, n, 1}, {1.0, 1.0, 1.0}, {0, 0, 1}};
    const struct boundary b[4] = {{.kind = BOUNDARY_NO_SLIP},
                                  {.kind = BOUNDARY_NO_SLIP},
                                  {.kind = BOUNDARY_NO_SLIP},
                                  {.kind = BOUNDARY_NO_SLIP, .wall = {1.0}}};
    const struct fluid_options o = {.rho = 1.0,
                                    .mu = 0.01,
                                    .dt = 1.0 / n,
                                    .convection =
                                        convection_scheme_named("linear"),
                                    .correctors = 2,
                                    .piso_tolerance = 1e-4,
                                    .tolerance = 1e-9,
                                    .boundaries = b};
    struct mesh *const m = mesh_create_box(&spec);
    struct fluid *const fl = fluid_create(m, &o);

    step_to(fl, 5.0);
    take(fl, n, to);
    owner_free(fl);
    mesh_free(m);
}

/* The mean of the four cells of `fine` in cell c of a mesh half as fine. */
static double mean(const double *fine, int n, int c)
{
    const int at = 2 * (c % n) + 4 * n * (c / n);

    return 0.25 *
           (fine[at] + fine[at + 1] + fine[at + 2 * n] + fine[at + 2 * n + 1]);
}

static void compare(const struct fields *a, const struct fields *b,
                    double off[3])
{
    const int n = a->n, part = n * (n * 3 / 4);
    double u = 0.0, p = 0.0, wall = 0.0;

    for (int c = 0; c < part; c++) {
        u += pow(mean(b->u, n, c) - a->u[c], 2.0) +
             pow(mean(b->v, n, c) - a->v[c], 2.0);
        p += pow(mean(b->p, n, c) - a->p[c], 2.0);
    }
    for (int i = 0; i < n; i++)
        wall += pow(0.5 * (b->floor[2 * i] + b->floor[2 * i + 1]) - a->floor[i],
                    2.0);
    off[0] = sqrt(u / part), off[1] = sqrt(p / part), off[2] = sqrt(wall / n);
}

static struct manufactured_error made(enum manufactured_kind kind, double K,
                                      int n)
{
    const struct manufactured a = {.kind = kind,
                                   .n = n,
                                   .flat = 1,
                                   .shared = K > 0.0,
                                   .time = "bdf2",
                                   .convection = "linear",
                                   .K = K,
                                   .dt = 0.32 / n,
                                   .end = 0.32};

    return manufactured_run(&a);
}

static void print_made(const char *name, enum manufactured_kind kind, double K)
{
    const struct manufactured_error a = made(kind, K, 16),
                                    b = made(kind, K, 32);

    printf("%s  %.2e %.2f  %.2e %.2f  %.2e %.2f\n", name, b.u, log2(a.u / b.u),
           b.p, log2(a.p / b.p), b.p_wall, log2(a.p_wall / b.p_wall));
}

int main(void)
{
    struct fields *const f = calloc(MESHES, sizeof *f);
    double off[MESHES][3];

    puts("# cells, and twice those: u, order; p, order; p on the floor, order");
    for (int i = 0; i < MESHES; i++) {
        compute(FIRST << i, &f[i]);
        if (i == 0) continue;
        compare(&f[i - 1], &f[i], off[i]);
        printf("%3d %3d", f[i - 1].n, f[i].n);
        for (int k = 0; k < 3; k++)
            printf("  %.2e %.2f", off[i][k],
                   i > 1 ? log2(off[i - 1][k] / off[i][k]) : 0.0);
        putchar('\n');
    }
    free(f);
    puts("# flow: u, order; p, order; p at the walls, order");
    print_made("box", MANUFACTURED_BOX, 0.0);
    print_made("box_drag", MANUFACTURED_BOX, 20.0);
    print_made("channel", MANUFACTURED_CHANNEL, 0.0);
    return 0;
}
