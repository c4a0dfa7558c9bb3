/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The linear solvers alone, on boxes of cells with one open end.
 *
 *     sh figures/run.sh figures/07/07-solvers.c -- PART
 */
#include "base/alloc.h"
#include "linear/solvers.h"
#include "linear/chebyshev.h"
#include "linear/multigrid/multigrid.h"
#include "linear_case.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/* n x n x n cells of unit size and their links, in the order of the mesh. */
struct box {
    int n, cells, n_links;
    int *owner, *neighbour;
    double *strength, *link, *V; /* [m], [m], [m^3] */
};

static struct box box_create(int n, const double h[3])
{
    struct box b = {.n = n, .cells = n * n * n};
    const int step[3] = {1, n, n * n};

    b.owner = alloc_ints(3 * b.cells);
    b.neighbour = alloc_ints(3 * b.cells);
    b.strength = alloc_doubles(3 * b.cells);
    b.link = alloc_doubles(9 * b.cells);
    b.V = alloc_doubles(b.cells);
    for (int c = 0; c < b.cells; c++) {
        const int q[3] = {c % n, c / n % n, c / (n * n)};

        b.V[c] = h[0] * h[1] * h[2];
        for (int k = 0; k < 3; k++) {
            if (q[k] == n - 1) continue;
            b.owner[b.n_links] = c;
            b.neighbour[b.n_links] = c + step[k];
            b.strength[b.n_links] = b.V[c] / (h[k] * h[k]);
            b.link[3 * b.n_links++ + k] = h[k];
        }
    }
    return b;
}

static void box_free(struct box *b)
{
    free(b->owner);
    free(b->neighbour);
    free(b->strength);
    free(b->link);
    free(b->V);
}

/* Conductivity: blocks of four cells a side, each 1 or as given, at random. */
static double *blocks(const struct box *b, double jump)
{
    double *const k = alloc_doubles(b->cells);

    for (int c = 0; c < b->cells; c++) {
        const int q[3] = {c % b->n, c / b->n % b->n, c / (b->n * b->n)};
        unsigned seed = 0;

        for (int d = 0; d < 3; d++) {
            seed = (seed + (unsigned)(q[d] / 4) + 1) * 2654435761u;
            seed ^= seed >> 15;
        }
        k[c] = noise(&seed) > 0.0 ? jump : 1.0;
    }
    return k;
}

/* Pressure with an outlet on the side z = 0 and walls elsewhere. */
static struct csr *pressure(const struct box *b, const double *k,
                            const double h[3])
{
    struct csr *const A =
        csr_create(b->cells, b->n_links, b->owner, b->neighbour);

    for (int l = 0; l < b->n_links; l++) {
        const int i = b->owner[l], j = b->neighbour[l];
        const double g = 2.0 * k[i] * k[j] / (k[i] + k[j]) * b->strength[l];

        A->a[A->upper[l]] = A->a[A->lower[l]] = -g;
        A->diag[i] += g;
        A->diag[j] += g;
    }
    for (int c = 0; c < b->n * b->n; c++)
        A->diag[c] += 2.0 * k[c] * h[0] * h[1] / h[2];
    return A;
}

/* A system, and both ways to solve it. */
struct system {
    struct box box;
    struct csr *A;
    struct preconditioned by_multigrid, by_diagonal;
    struct cg_work *work;
    double *b, *x;
};

static struct system system_create(int n, double jump, const double h[3])
{
    struct system s = {.box = box_create(n, h)};
    const struct box *const box = &s.box;
    double *const k = blocks(box, jump);
    unsigned seed = 1;

    s.A = pressure(box, k, h);
    s.by_multigrid.kind = &multigrid_preconditioned;
    s.by_multigrid.matrix =
        multigrid_create(box->cells, box->n_links, box->owner, box->neighbour,
                         box->strength, box->link, box->V);
    s.by_diagonal = (struct preconditioned){&preconditioned_jacobi, s.A};
    set_from(s.by_multigrid, s.A);
    s.work = cg_work_create(box->cells);
    s.b = alloc_doubles(box->cells);
    s.x = alloc_doubles(box->cells);
    for (int c = 0; c < box->cells; c++)
        s.b[c] = noise(&seed);
    free(k);
    return s;
}

static void system_free(struct system *s)
{
    box_free(&s->box);
    owner_free(s->A);
    owner_free(s->by_multigrid.matrix);
    owner_free(s->work);
    free(s->b);
    free(s->x);
}

/* From zero; the processor time of it, if asked for [s]. */
static struct solve_report solve(struct system *s, int multigrid,
                                 double tolerance, int most, double *seconds)
{
    const clock_t start = clock();

    memset(s->x, 0, (size_t)s->box.cells * sizeof *s->x);

    const struct solve_report r =
        cg_solve(multigrid ? s->by_multigrid : s->by_diagonal, s->b, s->x,
                 tolerance, 0.0, most, s->work);

    if (seconds != NULL) *seconds = (double)(clock() - start) / CLOCKS_PER_SEC;
    return r;
}

static const double cubes[3] = {1.0, 1.0, 1.0};

/* Iterations to 1e-8 for cubes of 10 to 100 cells a side. */
static void scale(void)
{
    static const int sides[] = {10, 16, 22, 32, 46, 68, 100};

    double last = 0.0, worth = 0.0; /* [s], [-] plain iterations */
    int iterations = 0;

    printf("# cells, iterations by diagonal, by multigrid; us a cell\n");
    for (int s = 0; s < 7; s++) {
        struct system y = system_create(sides[s], 1.0, cubes);
        double plain, multi;
        const int slow = solve(&y, 0, 1e-8, 5000, &plain).iterations;
        const int fast = solve(&y, 1, 1e-8, 5000, &multi).iterations;
        const double cells = y.box.cells;

        printf("%7d %5d %3d", y.box.cells, slow, fast);
        printf("  %6.2f %5.2f\n", 1e6 * plain / cells, 1e6 * multi / cells);
        worth = multi / (plain / slow);
        last = multi;
        iterations = fast;
        system_free(&y);
    }
    printf("last_seconds = %.2f\nlast_worth = %.0f\n", last, worth);
    printf("last_iterations = %d\n", iterations);
}

/* Iterations alone: the same on every machine. */
static void few(void)
{
    static const int sides[] = {8, 16, 32};

    printf("# cells, iterations by diagonal, by multigrid\n");
    for (int s = 0; s < 3; s++) {
        struct system y = system_create(sides[s], 1.0, cubes);

        printf("%6d %4d %3d\n", y.box.cells,
               solve(&y, 0, 1e-8, 5000, NULL).iterations,
               solve(&y, 1, 1e-8, 5000, NULL).iterations);
        system_free(&y);
    }
}

/* Residual after each iteration, in a cube of 32 cells a side. */
static void history(void)
{
    struct system y = system_create(32, 1.0, cubes);
    double plain = 1.0;

    printf("# iteration, residual by diagonal, by multigrid\n");
    for (int it = 0; it <= 400 && plain > 1e-10; it += it < 20 ? 1 : 8) {
        plain = solve(&y, 0, 1e-10, it, NULL).after;
        printf("%3d %.3e", it, plain);
        if (it <= 13) printf(" %.3e", solve(&y, 1, 1e-10, it, NULL).after);
        printf("\n");
    }
    system_free(&y);
}

/* What a tolerance costs, in a cube of 46 cells a side. */
static void accuracy(void)
{
    struct system y = system_create(46, 1.0, cubes);
    double ratio = 0.0;

    printf("# tolerance, iterations by diagonal, by multigrid; ms\n");
    for (int digits = 1; digits <= 12; digits++) {
        const double tolerance = pow(10.0, -digits);
        double plain, multi;
        const int slow = solve(&y, 0, tolerance, 5000, &plain).iterations;
        const int fast = solve(&y, 1, tolerance, 5000, &multi).iterations;

        printf("1e-%02d %4d %3d  %6.1f %5.1f\n", digits, slow, fast,
               1e3 * plain, 1e3 * multi);
        ratio = (multi / fast) / (plain / slow);
    }
    printf("iteration_ratio = %.1f\n", ratio);
    system_free(&y);
}

static void hard_one(const char *name, double jump, const double h[3])
{
    struct system y = system_create(32, jump, h);

    printf("%-28s %5d %4d\n", name, solve(&y, 0, 1e-8, 20000, NULL).iterations,
           solve(&y, 1, 1e-8, 20000, NULL).iterations);
    system_free(&y);
}

static void flat(void)
{
    static const double h[3] = {1.0, 0.1, 1.0};

    hard_one("flat cells", 1.0, h);
}

/* What makes a system harder, in a cube of 32 cells a side. */
static void hard(void)
{
    printf("# iterations by diagonal, by multigrid\n");
    hard_one("cubes", 1.0, cubes);
    flat();
    hard_one("blocks of 1 and 10", 10.0, cubes);
    hard_one("blocks of 1 and 1000", 1000.0, cubes);
    hard_one("blocks of 1 and 1000000", 1e6, cubes);
}

/* The levels that multigrid makes of 32 x 32 x 32 cells. */
static void levels(void)
{
    struct system y = system_create(32, 1.0, cubes);

    for (int k = 0; k < multigrid_levels(y.by_multigrid.matrix); k++)
        printf("level %d: %5d cells\n", k,
               multigrid_unknowns(y.by_multigrid.matrix, k));
    system_free(&y);
}

/* Products with K that the exponential takes for some z = lambda T. */
static void series(void)
{
    struct box b = box_create(8, cubes);
    struct csr *const K = csr_create(b.cells, b.n_links, b.owner, b.neighbour);
    double most = 0.0;

    for (int l = 0; l < b.n_links; l++) {
        K->a[K->upper[l]] = K->a[K->lower[l]] = -1.0;
        K->diag[b.owner[l]] += 1.0;
        K->diag[b.neighbour[l]] += 1.0;
    }
    for (int c = 0; c < b.cells; c++)
        most = fmax(most, K->diag[c]);
    printf("# z, products to 1e-6, to 1e-12\n");
    for (double z = 3.0; z < 1e4; z *= 10.0) {
        const double T = z / (2.0 * most);
        struct chebyshev *const s = chebyshev_create(K, b.V, T, 1e-6, 1);
        struct chebyshev *const t = chebyshev_create(K, b.V, T, 1e-12, 1);

        printf("%5.0f %3d %3d\n", z, chebyshev_products(s),
               chebyshev_products(t));
        owner_free(s);
        owner_free(t);
    }
    owner_free(K);
    box_free(&b);
}

int main(int argc, char **argv)
{
    static const struct {
        const char *name;
        void (*print)(void);
    } parts[] = {{"few", few},           {"history", history},
                 {"accuracy", accuracy}, {"hard", hard},
                 {"flat", flat},         {"levels", levels},
                 {"series", series},     {"scale", scale}};

    for (int k = 0; k < 8; k++)
        if (argc > 1 && strcmp(argv[1], parts[k].name) == 0) parts[k].print();
    return 0;
}
