/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The lid-driven cavity, a square or a cube, on meshes of n cells a side, each
 * begun with the flow of the one before: u on the vertical centreline and v on
 * the horizontal one, how far they are off the published tables, and the order
 * in which they converge.
 *
 *   sh figures/run.sh figures/19/19-cavity.c -- square|cube RE [SCHEME] N...
 *
 * The flow in the cube is symmetric about z = 1/2: half of it is computed. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fluid/fluid.h"

enum { MOST = 128, POINTS = 17, FINE = 51 };

/* What is on a centreline: n + 2 values of u and v, those of the walls too. */
struct profile {
    int n;
    double value[2][MOST + 2];
};

struct table {
    double s[2][POINTS], value[2][POINTS];
};

/* Cells are numbered x first. */
static int cell(int n, int i, int j, int k)
{
    return i + n * (j + n * k);
}

static struct fluid *cavity(int cube, int n, double re, const char *scheme,
                            const struct boundary b[6])
{
    const struct box_spec spec = {{1.0, 1.0, 0.5},
                                  {n, n, cube ? n / 2 : 1},
                                  {1.0, 1.0, 1.0},
                                  {0, 0, !cube}};
    const struct fluid_options o = {.rho = 1.0,
                                    .mu = 1.0 / re,
                                    .dt = 1.0 / n,
                                    .convection =
                                        convection_scheme_named(scheme),
                                    .correctors = 2,
                                    .piso_tolerance = 1e-3,
                                    .tolerance = 1e-5,
                                    .boundaries = b};

    return fluid_create(mesh_create_box(&spec), &o);
}

/* u of the coarse mesh at the centres of the fine one, linear between, and the
 * volume through the faces. */
static void prolong(const struct fluid *from, struct fluid *to)
{
    const struct mesh *const m = to->mesh;
    const int *const n = from->mesh->box.n;

    for (int c = 0; c < m->n_cells; c++) {
        int at[3];
        double share[3];
        for (int k = 0; k < 3; k++) {
            const double x = m->centre[3 * c + k] * n[0] - 0.5;
            at[k] = n[k] == 1 ? 0 : (int)fmax(0.0, fmin(floor(x), n[k] - 2));
            share[k] = n[k] == 1 ? 0.0 : fmax(0.0, fmin(x - at[k], 1.0));
        }
        for (int corner = 0; corner < (n[2] == 1 ? 4 : 8); corner++) {
            const int a = corner & 1, b = corner >> 1 & 1, d = corner >> 2;
            const double w = (a ? share[0] : 1.0 - share[0]) *
                             (b ? share[1] : 1.0 - share[1]) *
                             (d ? share[2] : 1.0 - share[2]);
            const int donor = cell(n[0], at[0] + a, at[1] + b, at[2] + d);
            for (int k = 0; k < 3; k++)
                to->u[3 * c + k] += w * from->u[3 * donor + k];
        }
    }
    for (int f = 0; f < m->n_internal; f++)
        for (int k = 0; k < 3; k++)
            to->phi[f] +=
                mesh_S(m, f)[k] * (0.5 * to->u[3 * m->owner[f] + k] +
                                   0.5 * to->u[3 * m->neighbour[f] + k]);
}

/* Until nothing changes by more than 5e-5 in a unit of time. */
static void settle(struct fluid *fl)
{
    const size_t n = 3 * (size_t)fl->mesh->n_cells;
    double *const before = malloc(n * sizeof *before);
    double change = 1.0;

    while (change > 5e-5 && fl->t < 100.0) {
        const double start = fl->t;
        memcpy(before, fl->u, n * sizeof *before);
        while (fl->t < start + 1.0 - 1e-9)
            if (fluid_step(fl) != 0) exit(3);
        change = 0.0;
        for (size_t i = 0; i < n; i++)
            change = fmax(change, fabs(fl->u[i] - before[i]));
    }
    free(before);
}

/* Component k on the centreline along `way`, beside its cell i: cubic between
 * the cells across, even about the plane of symmetry. */
static double on_line(const struct fluid *fl, int k, int way, int i)
{
    static const double weight[4] = {-1.0 / 16, 9.0 / 16, 9.0 / 16, -1.0 / 16};
    const int n = fl->mesh->box.n[0], deep = fl->mesh->box.n[2];
    double sum = 0.0;

    for (int a = 0; a < 4; a++) {
        const int across = n / 2 - 2 + a;
        const int x = way == 0 ? i : across, y = way == 0 ? across : i;
        const double near = fl->u[3 * cell(n, x, y, deep - 1) + k];
        const double next =
            deep == 1 ? near : fl->u[3 * cell(n, x, y, deep - 2) + k];
        sum += weight[a] * (9.0 * near - next) / 8.0;
    }
    return sum;
}

static struct profile centrelines(const struct fluid *fl)
{
    struct profile p = {fl->mesh->box.n[0], {{0.0}}};

    for (int k = 0; k < 2; k++)
        for (int i = 0; i < p.n; i++)
            p.value[k][i + 1] = on_line(fl, k, 1 - k, i);
    p.value[0][p.n + 1] = 1.0; /* the lid */
    return p;
}

/* Where value i of n + 2 is. */
static double place(int n, int i)
{
    return i == 0 ? 0.0 : i > n ? 1.0 : (i - 0.5) / n;
}

/* The cubic through the four values next to s. */
static double at(const struct profile *p, int k, double s)
{
    const int n = p->n, from = (int)floor(s * n - 0.5);
    const int first = from < 0 ? 0 : from > n - 2 ? n - 2 : from;
    double sum = 0.0;

    for (int i = first; i < first + 4; i++) {
        double w = p->value[k][i];
        for (int j = first; j < first + 4; j++)
            if (i != j) w *= (s - place(n, j)) / (place(n, i) - place(n, j));
        sum += w;
    }
    return sum;
}

/* Column `with` of a file, beside column `s`. */
static void read_table(const char *path, int s, int with, double place_at[],
                       double value[])
{
    FILE *const f = fopen(path, "r");
    char line[1024];
    double x[4];
    int i = 0;

    while (f != NULL && i < POINTS && fgets(line, sizeof line, f) != NULL)
        if (sscanf(line, "%lf,%lf,%lf,%lf", &x[0], &x[1], &x[2], &x[3]) == 4) {
            place_at[i] = x[s];
            value[i++] = x[with];
        }
    if (f == NULL || i < POINTS) exit(2);
    fclose(f);
}

/* 0 if nobody has published one. */
static int published(int cube, double re, struct table *t)
{
    const char *const cubes = "figures/data/albensoeder-kuhlmann-2005.csv";
    const int column = re < 200.0 ? 1 : re < 600.0 ? 2 : 3;

    if (cube && re != 1000.0) return 0;
    if (cube) {
        read_table(cubes, 0, 1, t->s[0], t->value[0]);
        read_table(cubes, 2, 3, t->s[1], t->value[1]);
    } else {
        read_table("figures/data/ghia-1982-u.csv", 0, column, t->s[0],
                   t->value[0]);
        read_table("figures/data/ghia-1982-v.csv", 0, column, t->s[1],
                   t->value[1]);
        for (int i = 0; i < POINTS; i++) /* a misprint is left out */
            if (column == 2 && fabs(t->s[1][i] - 0.9063) < 1e-6)
                t->s[1][i] = 0.0;
    }
    return 1;
}

/* Root mean square off the table, its ends left out. */
static double off(const struct profile *p, int k, const struct table *t)
{
    double sum = 0.0;
    int n = 0;

    for (int i = 0; i < POINTS; i++)
        if (t->s[k][i] > 0.0 && t->s[k][i] < 1.0) {
            sum += pow(at(p, k, t->s[k][i]) - t->value[k][i], 2.0);
            n++;
        }
    return sqrt(sum / n);
}

/* Root mean square of what two meshes differ by. */
static double change(const struct profile *a, const struct profile *b, int k)
{
    double sum = 0.0;

    for (int i = 0; i < FINE; i++)
        sum += pow(at(a, k, i / (FINE - 1.0)) - at(b, k, i / (FINE - 1.0)), 2);
    return sqrt(sum / FINE);
}

/* The order q for which what two pairs of meshes differ by, C (h^q - h'^q), has
 * the ratio found. */
static double order(const struct profile p[3], int k)
{
    const double found = change(&p[0], &p[1], k) / change(&p[1], &p[2], k);
    double low = 0.1, high = 6.0;

    for (int i = 0; i < 50; i++) {
        const double q = 0.5 * (low + high);
        const double h[3] = {pow(p[0].n, -q), pow(p[1].n, -q), pow(p[2].n, -q)};
        *((h[0] - h[1]) / (h[1] - h[2]) < found ? &low : &high) = q;
    }
    return low;
}

static void print(const struct profile *p, const struct profile *before)
{
    const double r = pow((double)p->n / before->n, 2.0);

    puts("# s, u and v here, and both as they are extrapolated to h = 0");
    for (int i = 0; i < FINE; i++) {
        const double s = i / (FINE - 1.0);
        const double u = at(p, 0, s), v = at(p, 1, s);
        printf("%.2f %.4f %.4f %.4f %.4f\n", s, u, v,
               u + (u - at(before, 0, s)) / (r - 1.0),
               v + (v - at(before, 1, s)) / (r - 1.0));
    }
}

int main(int argc, char **argv)
{
    const int cube = argc > 1 && strcmp(argv[1], "cube") == 0;
    const double re = argc > 2 ? atof(argv[2]) : 1000.0;
    const int named = argc > 3 && convection_scheme_named(argv[3]) != NULL;
    const char *const scheme = named ? argv[3] : "linear";
    char **const size = argv + 3 + named;
    const int sizes = argc - 3 - named;
    struct boundary b[6];
    struct fluid *last = NULL;
    struct profile p[8];
    struct table t;
    const int known = published(cube, re, &t);

    for (int i = 0; i < 6; i++)
        b[i] = (struct boundary){.kind =
                                     i == 5 ? BOUNDARY_SLIP : BOUNDARY_NO_SLIP};
    b[3].wall[0] = 1.0;
    for (int i = 0; i < sizes; i++) {
        const int n = atoi(size[i]);
        if (n < 8 || n > MOST || n % 2 != 0 || i == 8) return 2;
        struct fluid *const fl = cavity(cube, n, re, scheme, b);
        if (last != NULL) prolong(last, fl);
        settle(fl);
        p[i] = centrelines(fl);
        printf("time_%d = %.0f\n", n, fl->t);
        for (int k = 0; k < 2 && known; k++)
            printf("off_%c_%d = %.4f\n", "uv"[k], n, off(&p[i], k, &t));
        for (int k = 0; k < 2 && i >= 2; k++)
            printf("order_%c_%d = %.2f\n", "uv"[k], n, order(&p[i - 2], k));
        if (i >= 1 && i == sizes - 1) print(&p[i], &p[i - 1]);
        fflush(stdout);
        last = fl;
    }
    return 0;
}
