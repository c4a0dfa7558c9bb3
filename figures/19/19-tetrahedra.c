/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The pressure drop of a pipe of tetrahedra over the exact one; or the errors
 * and orders of the flow of (19.3) on tetrahedra, up to 6 MOST^3 of them, as it
 * is, on tetrahedra that are not shaken, or with the fluid at rest.
 *
 *   sh figures/run.sh figures/19/19-tetrahedra.c -- pipe SLOPES|later|made
 * SCHEME MOST|even MOST|rest
 */
#include <gsl/gsl_math.h>
#include <math.h>
#include <stdio.h>

#include "manufactured.h"
#include "pipe.h"

/* The exact drop at the time `end` over 32 mu U / d^2: a polygon of 4 n sides,
 * taken for a circle of its area, in which the flow begins with the profile of
 * the circle around it and keeps its volume. Rings, implicit in time. */
enum { RINGS = 200 };

static void rings_solve(double R, double dt, const double *right, double *u)
{
    const double dr = R / RINGS, nu = pipe_mu;
    double diag[RINGS], d[RINGS];

    for (int i = 0; i < RINGS; i++) {
        const double in = 2.0 * M_PI * i * nu * dt; /* of the face inward */
        const double out =
            2.0 * M_PI * (i + 1) * nu * dt * (i + 1 < RINGS ? 1.0 : 2.0);
        const double share = i > 0 ? in / diag[i - 1] : 0.0;
        diag[i] = 2.0 * M_PI * (i + 0.5) * dr * dr + in + out - share * in;
        d[i] = right[i] + (i > 0 ? share * d[i - 1] : 0.0);
    }
    for (int i = RINGS - 1; i >= 0; i--) {
        const double out = 2.0 * M_PI * (i + 1) * nu * dt;
        u[i] = (d[i] + (i + 1 < RINGS ? out * u[i + 1] : 0.0)) / diag[i];
    }
}

static double exact_drop(int n, double end)
{
    const double sides = 4.0 * n, dt = 2e-3;
    const double R =
        0.5 * sqrt(0.5 * sides * sin(2.0 * M_PI / sides) / M_PI); /* [m] */
    const double dr = R / RINGS;
    double area[RINGS], u[RINGS], right[RINGS], driven[RINGS];
    double flow = 0.0, unit = 0.0, slope = 0.0;

    for (int i = 0; i < RINGS; i++) {
        const double x[2] = {(i + 0.5) * dr, 0.0};
        area[i] = 2.0 * M_PI * x[0] * dr;
        u[i] = pipe_velocity(x);
        flow += area[i] * u[i];
        right[i] = dt * area[i];
    }
    rings_solve(R, dt, right, driven);
    for (int i = 0; i < RINGS; i++)
        unit += area[i] * driven[i];
    for (double t = 0.0; t < end - 0.5 * dt; t += dt) {
        double now = 0.0;
        for (int i = 0; i < RINGS; i++)
            right[i] = area[i] * u[i];
        rings_solve(R, dt, right, u);
        for (int i = 0; i < RINGS; i++)
            now += area[i] * u[i];
        slope = (flow - now) / unit;
        for (int i = 0; i < RINGS; i++)
            u[i] += slope * driven[i];
    }
    return slope / (32.0 * pipe_mu * flow / (M_PI * R * R));
}

static void pipe(const char *slopes, const char *scheme)
{
    static const int blocks[] = {6, 8, 12};

    printf("%s", scheme);
    for (int k = 0; k < 3; k++) {
        printf(" %.3f", pipe_of_tetrahedra(blocks[k], scheme, slopes, 0.6));
        fflush(stdout);
    }
    putchar('\n');
}

/* On the coarsest mesh, as time goes on. */
static void later(const char *scheme)
{
    printf("%s", scheme);
    for (int k = 4; k <= 8; k++)
        printf(" %.3f", pipe_of_tetrahedra(6, scheme, "by-mesh", 0.15 * k));
    putchar('\n');
}

static void made(const char *scheme, int most, double shake, double K,
                 int still)
{
    struct manufactured_error last = {0};

    for (int n = 4; n <= most; n *= 2) {
        const struct manufactured a = {.kind = MANUFACTURED_BOX,
                                       .n = n,
                                       .shake = shake,
                                       .convection = scheme,
                                       .time = "bdf2",
                                       .steady = 1,
                                       .still = still,
                                       .K = K,
                                       .dt = 0.32 / n,
                                       .end = 0.32};
        const struct manufactured_error e = manufactured_run(&a);
        printf("%s %d  %.2e", still ? "rest" : scheme, 6 * n * n * n, e.u);
        if (n > 4) printf(" %.2f", log2(last.u / e.u));
        printf("  %.2e", e.p);
        if (n > 4) printf(" %.2f", log2(last.p / e.p));
        putchar('\n');
        fflush(stdout);
        last = e;
    }
}

/* Errors of the flow, root mean squares: of u in the cells at walls and in
 * those of the inner eighth of the box; of p there, and of the mean of p over
 * the six cells of each of its blocks. */
struct parts {
    double u_wall, u_inner, p_inner, p_blocks;
};

static int is_inner(const double x[3])
{
    return fabs(x[0] - 0.5) < 0.25 && fabs(x[1] - 0.5) < 0.25 &&
           fabs(x[2] - 0.5) < 0.25;
}

static int is_at_wall(const struct mesh *m, int c)
{
    return m->cell_face[m->cell_start[c + 1] - 1] >= m->n_internal;
}

/* The mean of what p has too much [Pa]. */
static double level_of(const struct manufactured *a, const struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    double sum = 0.0, V = 0.0;

    for (int c = 0; c < m->n_cells; c++) {
        V += m->V[c];
        sum +=
            m->V[c] * (fl->p[c] - manufactured_p(a, &m->centre[3 * c], fl->t));
    }
    return sum / V;
}

static struct parts parts_of(const struct manufactured *a,
                             const struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    const int n = a->n;
    const double level = level_of(a, fl);
    double *const block = calloc((size_t)(n * n * n), sizeof *block);
    struct parts e = {0.0, 0.0, 0.0, 0.0};
    int at_wall = 0, inner = 0;

    for (int c = 0; c < m->n_cells; c++) {
        const double *const x = &m->centre[3 * c];
        const double p = fl->p[c] - level - manufactured_p(a, x, fl->t);
        double u[3], square = 0.0;
        manufactured_u(a, x, fl->t, u);
        for (int k = 0; k < 3; k++)
            square += pow(fl->u[3 * c + k] - u[k], 2.0);
        if (is_at_wall(m, c)) at_wall++, e.u_wall += square;
        if (!is_inner(x)) continue;
        inner++, e.u_inner += square, e.p_inner += p * p;
        block[(int)(n * x[0]) + n * ((int)(n * x[1]) + n * (int)(n * x[2]))] +=
            p / 6.0;
    }
    for (int i = 0; i < n * n * n; i++)
        e.p_blocks += 6.0 * block[i] * block[i];
    free(block);
    e.u_wall = sqrt(e.u_wall / at_wall), e.u_inner = sqrt(e.u_inner / inner);
    e.p_inner = sqrt(e.p_inner / inner), e.p_blocks = sqrt(e.p_blocks / inner);
    return e;
}

static void print_order(double error, double last, double ratio)
{
    printf("  %.2e", error);
    if (last > 0.0) printf(" %.2f", log(last / error) / log(ratio));
}

/* The cells of a mesh are all of one size, and so are those of a block. */
static void even(int most)
{
    struct parts last = {0.0, 0.0, 0.0, 0.0};

    for (int n = 4; n <= most; n += 4) {
        const struct manufactured a = {.kind = MANUFACTURED_BOX,
                                       .n = n,
                                       .shake = 1e-12,
                                       .convection = "second-upwind",
                                       .time = "bdf2",
                                       .steady = 1,
                                       .dt = 0.32 / n,
                                       .end = 0.32};
        struct manufactured_boundaries b;
        struct fluid *const fl = manufactured_create(&a, &b);
        for (int i = 0; i < n; i++) {
            manufactured_set(&a, fl, fl->t + a.dt);
            if (fluid_step(fl) != 0) exit(3);
        }
        const struct parts e = parts_of(&a, fl);
        const double ratio = n / (n - 4.0);
        printf("%d", 6 * n * n * n);
        print_order(e.u_wall, last.u_wall, ratio);
        print_order(e.u_inner, last.u_inner, ratio);
        print_order(e.p_inner, last.p_inner, ratio);
        print_order(e.p_blocks, last.p_blocks, ratio);
        putchar('\n');
        fflush(stdout);
        last = e;
        struct mesh *const m = (struct mesh *)fl->mesh;
        owner_free(fl);
        mesh_free(m);
    }
}

int main(int argc, char **argv)
{
    if (argc < 2) return 2;
    if (strcmp(argv[1], "even") == 0) {
        puts("# cells; u at walls, order; u inside; p inside; p of six cells");
        even(argc > 2 ? atoi(argv[2]) : 16);
        return 0;
    }
    if (strcmp(argv[1], "rest") == 0) {
        puts("# cells; error of u, order; of p, order");
        made("linear", 8, 0.1, 0.0, 1);
        return 0;
    }
    if (strcmp(argv[1], "later") == 0) {
        puts("# convection; drop on 2592 cells after 0.6, 0.75 ... 1.2 s");
        later("second-upwind");
        later("van-leer");
        return 0;
    }
    if (argc < 3) return 2;
    if (strcmp(argv[1], "pipe") == 0) {
        puts("# convection; drop on 2592, 6144 and 20736 cells");
        printf("exact %.3f %.3f %.3f\n", exact_drop(6, 0.6), exact_drop(8, 0.6),
               exact_drop(12, 0.6));
        pipe(argv[2], "linear");
        pipe(argv[2], "second-upwind");
        pipe(argv[2], "van-leer");
        return 0;
    }
    puts("# convection, cells; error of u, order; of p, order");
    made(argv[2], argc > 3 ? atoi(argv[3]) : 16, argc > 4 ? atof(argv[4]) : 0.1,
         argc > 5 ? atof(argv[5]) : 0.0, 0);
    return 0;
}
