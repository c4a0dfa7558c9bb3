/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "record/statistics_files.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "base/statistics/correlation.h"
#include "base/statistics/density.h"
#include "base/statistics/moments.h"
#include "output/summary.h"

enum { BINS = 60 };

static int write_table(const struct case_statistics *self, const char *name,
                       int n_columns, const char *const *columns, int rows,
                       const double *values)
{
    char *const path = folder_file(self->folder, name);
    const int failed =
        path == NULL || table_write(path, n_columns, columns, rows, values);

    free(path);
    return failed;
}

static int write_series(const struct case_statistics *self)
{
    return write_table(self, "statistics/series.csv", 1 + self->n_scalars,
                       self->columns, self->n, self->series);
}

static int write_profile(const struct case_statistics *self)
{
    static const char *const columns[] = {"height [m]", "eps_f [-]",
                                          "error [-]"};
    const struct layers *const l = self->layers;

    if (l == NULL) return 0;
    double *const rows = alloc_doubles(3 * l->n);
    double *const x = alloc_doubles(l->n_rows);
    for (int k = 0; k < l->n; k++) {
        for (int i = 0; i < l->n_rows; i++)
            x[i] = l->eps[l->n * i + k];
        rows[3 * k] = l->height[k];
        rows[3 * k + 1] = moments_mean(l->n_rows, x);
        rows[3 * k + 2] = moments_block_error(l->n_rows, x, self->blocks);
    }
    const int failed =
        write_table(self, "statistics/profile.csv", 3, columns, l->n, rows);
    free(rows);
    free(x);
    return failed;
}

/* R and its integral over all grains into rows of three; the time T [s]. */
static double correlate(const struct case_statistics *self, int lags,
                        double *rows)
{
    const struct grain_series *const g = self->grains;
    double *const c = alloc_doubles(3 * lags), *const R = c + lags,
                  *const I = R + lags;

    for (int i = 0; i < g->n; i++)
        correlation_add(g->n_rows, &g->Cd[(long)i * g->rows], lags, c);
    correlation_normalise(lags, c, R);
    correlation_integral(lags, self->dt, R, I);
    for (int k = 0; k < lags; k++) {
        rows[3 * k] = k * self->dt;
        rows[3 * k + 1] = R[k];
        rows[3 * k + 2] = I[k];
    }
    const double T =
        correlation_time(lags, self->dt, I, self->plateau, INFINITY);
    free(c);
    return T;
}

/* All coefficients side by side; how many. */
static int statistics_files_gather(const struct grain_series *g, double *x)
{
    int n = 0;

    for (int i = 0; i < g->n; i++)
        for (int k = 0; k < g->n_rows; k++)
            x[n++] = g->Cd[(long)i * g->rows + k];
    return n;
}

static int write_density(const struct case_statistics *self, int n,
                         const double *x)
{
    static const char *const columns[] = {"C_d [-]", "density [-]"};
    const double high =
        moments_mean(n, x) + 6.0 * moments_deviation(n, x) + 1e-300;
    double p[BINS], rows[2 * BINS];

    density_of(n, x, 0.0, high, BINS, p);
    for (int i = 0; i < BINS; i++) {
        rows[2 * i] = (i + 0.5) * high / BINS;
        rows[2 * i + 1] = p[i];
    }
    return write_table(self, "statistics/density.csv", 2, columns, BINS, rows);
}

static int write_grains(const struct case_statistics *self, struct summary *f)
{
    static const char *const columns[] = {"tau [s]", "R [-]", "integral [s]"};
    const struct grain_series *const g = self->grains;

    if (g != NULL && g->changed && !self->quiet)
        fprintf(stderr,
                "grains were inserted or removed after %d samples of the drag "
                "coefficients: there are no more\n",
                g->n_rows);
    if (g == NULL || g->n_rows < 2) return 0;
    const int lags = self->lags < g->n_rows ? self->lags : g->n_rows;
    double *const rows = alloc_doubles(3 * lags);
    double *const x = alloc_doubles(g->n * g->n_rows);
    const double T = correlate(self, lags, rows);
    const int n = statistics_files_gather(g, x);

    summary_begin(f, "drag_coefficient");
    summary_count(f, "samples", g->n_rows);
    summary_number(f, "mean", moments_mean(n, x));
    summary_number(f, "deviation", moments_deviation(n, x));
    summary_number(f, "skewness", moments_skewness(n, x));
    summary_number(f, "integral_time", T);
    summary_number(f, "reynolds_number", moments_mean(g->n, g->Re));
    summary_number(f, "eps_f", moments_mean(g->n, g->eps));
    summary_end(f);
    const int failed = write_table(self, "statistics/correlation.csv", 3,
                                   columns, lags, rows) != 0 ||
                       write_density(self, n, x) != 0;
    free(rows);
    free(x);
    return failed;
}

static void write_scalar(const struct case_statistics *self, struct summary *f,
                         int k)
{
    const int stride = 1 + self->n_scalars, n = self->n - self->first;
    double *const x = alloc_doubles(n);

    for (int i = 0; i < n; i++)
        x[i] = self->series[stride * (self->first + i) + 1 + k];
    summary_begin(f, self->names[k]);
    summary_number(f, "mean", moments_mean(n, x));
    summary_number(f, "error", moments_block_error(n, x, self->blocks));
    summary_number(f, "deviation", moments_deviation(n, x));
    summary_end(f);
    free(x);
}

int statistics_files_write(const struct case_statistics *self)
{
    if (folder_make(self->folder, "statistics") != 0 ||
        write_series(self) != 0 || write_profile(self) != 0)
        return 1;
    char *const path = folder_file(self->folder, "statistics/summary.json");
    struct summary *const f = path != NULL ? summary_create(path) : NULL;
    free(path);
    summary_number(f, "from", self->from);
    summary_count(f, "samples", self->first < 0 ? 0 : self->n - self->first);
    summary_count(f, "blocks", self->blocks);
    for (int k = 0; k < self->n_scalars && self->first >= 0; k++)
        write_scalar(self, f, k);
    const int failed = write_grains(self, f);
    return summary_commit(f) != 0 || failed;
}
