/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The lid-driven cavity at Re 100, 400 and 1000: u on the vertical centreline
 * and v on the horizontal one, beside the tables of Ghia, and how far off. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fluid/fluid.h"

static const double Re[3] = {100.0, 400.0, 1000.0};

struct table {
    int n;
    double x[32], value[32][3];
};

static struct table read_table(const char *path)
{
    struct table t = {0};
    FILE *const f = fopen(path, "r");
    char line[1024];

    while (f != NULL && fgets(line, sizeof line, f) != NULL)
        if (t.n < 32 &&
            sscanf(line, "%lf,%lf,%lf,%lf", &t.x[t.n], &t.value[t.n][0],
                   &t.value[t.n][1], &t.value[t.n][2]) == 4)
            t.n++;
    if (f != NULL) fclose(f);
    return t;
}

/* Until nothing changes by more than 1e-6 in a unit of time. */
static void settle(struct fluid *fl, int n)
{
    double *const before = malloc(3 * (size_t)(n * n) * sizeof *before);
    double change = 1.0;

    while (change > 1e-5 && fl->t < 100.0) {
        const double start = fl->t;
        memcpy(before, fl->u, 3 * (size_t)(n * n) * sizeof *before);
        while (fl->t < start + 1.0)
            if (fluid_step(fl) != 0) exit(3);
        change = 0.0;
        for (int i = 0; i < 3 * n * n; i++)
            change = fmax(change, fabs(fl->u[i] - before[i]));
    }
    free(before);
}

static struct fluid *cavity(int n, double re, const struct boundary b[4])
{
    const struct box_spec spec = {
        {1.0, 1.0, 0.1}, {n, n, 1}, {1.0, 1.0, 1.0}, {0, 0, 1}};
    const struct fluid_options o = {.rho = 1.0,
                                    .mu = 1.0 / re,
                                    .dt = 0.8 / n,
                                    .convection =
                                        convection_scheme_named("linear"),
                                    .correctors = 2,
                                    .splitting = 1e-3,
                                    .tolerance = 1e-6,
                                    .boundaries = b};

    return fluid_create(mesh_create_box(&spec), &o);
}

/* Component k at the share s of the centreline along the other direction. */
static double at(const struct fluid *fl, int n, int k, double s)
{
    const double x = s * n - 0.5;
    const int j = (int)floor(x);
    const int across = k == 0 ? 1 : n, along = k == 0 ? n : 1;
    double v[2];

    for (int i = 0; i < 2; i++) {
        const int row = j + i < 0 ? 0 : j + i >= n ? n - 1 : j + i;
        const int c = along * row + across * (n / 2);
        v[i] = 0.5 * (fl->u[3 * c + k] + fl->u[3 * (c - across) + k]);
        if (j + i < 0) v[i] = -v[i];
        if (j + i >= n) v[i] = (k == 0 ? 2.0 : 0.0) - v[i];
    }
    return v[0] + (x - j) * (v[1] - v[0]);
}

/* Root mean square off the table, its ends and the misprint left out. */
static double off(const struct fluid *fl, int n, int k, int r,
                  const struct table *t)
{
    double sum = 0.0;
    int count = 0;

    for (int i = 0; i < t->n; i++) {
        const int misprint = k == 1 && r == 1 && fabs(t->x[i] - 0.9063) < 1e-6;
        if (t->x[i] <= 0.0 || t->x[i] >= 1.0 || misprint) continue;
        sum += pow(at(fl, n, k, t->x[i]) - t->value[i][r], 2.0);
        count++;
    }
    return sqrt(sum / count);
}

int main(int argc, char **argv)
{
    const int n = argc > 1 ? atoi(argv[1]) : 64;
    const struct table t[2] = {read_table("figures/data/ghia-1982-u.csv"),
                               read_table("figures/data/ghia-1982-v.csv")};
    struct boundary b[4] = {{.kind = BOUNDARY_NO_SLIP}};
    struct fluid *fl[3];

    for (int i = 0; i < 4; i++)
        b[i].kind = BOUNDARY_NO_SLIP;
    b[3].wall[0] = 1.0;
    for (int r = 0; r < 3; r++) {
        fl[r] = cavity(n, Re[r], b);
        settle(fl[r], n);
        printf("off_u_%.0f = %.4f\noff_v_%.0f = %.4f\n", Re[r],
               off(fl[r], n, 0, r, &t[0]), Re[r], off(fl[r], n, 1, r, &t[1]));
    }
    puts("# s, u at x = 1/2 for three Re, v at y = 1/2");
    for (int i = 0; i <= 50; i++) {
        printf("%.2f", i / 50.0);
        for (int k = 0; k < 2; k++)
            for (int r = 0; r < 3; r++)
                printf(" %.4f", at(fl[r], n, k, i / 50.0));
        putchar('\n');
    }
    return 0;
}
