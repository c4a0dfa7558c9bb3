/* SPDX-License-Identifier: GPL-3.0-or-later */
/* statistics.c -- output.statistics: means and correlations of a bed.
 * Chapter "Agitation".
 *
 * From the time `from` on each row of history.csv is a sample. Written into
 * DIR/statistics/ at the end:
 *
 *   series.csv       granular temperature along gravity and across it, heights,
 *                    and with a fluid the pressure drop, all from the start
 *   profile.csv      fluid fraction against height, with its error
 *   correlation.csv  R of the grains' drag coefficients, its running integral
 *   density.csv      their density, and that of one over its mean
 *   summary.json     mean, standard error by blocks, deviation, skewness, and
 *                    integral time of each
 */
#include "record/recorder_part.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "base/number.h"
#include "base/statistics.h"
#include "base/vector.h"
#include "coupling/coupling.h"
#include "coupling/drag.h"
#include "output/table.h"
#include "record/history.h"

enum { BINS = 60, SCALARS = 5 };

/* What is sampled as one number a row: the last only with a fluid. */
static const struct {
    const char *name, *unit;
} scalars[SCALARS] = {{"temperature_axial", "m2/s2"},
                      {"temperature_transverse", "m2/s2"},
                      {"bed_height", "m"},
                      {"bed_height_99", "m"},
                      {"pressure_drop", "Pa"}};

/* The drag coefficients of all grains, in time. */
struct grain_series {
    int capacity;        /* [-] of grains */
    int n, rows, n_rows; /* [-] grains, room, samples so far */
    int changed;         /* [-] 1: grains came or went after the first sample,
                            and there are no more */
    double *Cd;          /* [-] rows of each grain, by its id: n * rows */
    double *Re, *eps;    /* [-] the same at the last sample, n each */
};

/* The fluid fraction of horizontal layers of cells, in time. */
struct layers {
    int n;            /* [-] layers */
    int rows, n_rows; /* [-] room, samples so far */
    int *layer;       /* [-] of each cell */
    double *height;   /* [m] of the middle of each */
    double *volume;   /* [m^3] of its cells */
    double *eps;      /* [-] rows * n */
    int cells;
    const double *V; /* [m^3] of the cells, borrowed */
};

struct statistics {
    const struct simulation *sim; /* borrowed */
    struct folder *folder;        /* borrowed */
    int n_scalars;         /* [-] of scalars: the last only with a fluid */
    double from, plateau;  /* [s] */
    int blocks, lags;      /* [-] */
    int quiet;             /* [-] 1: nothing is said on stderr */
    double dt;             /* [s] between two samples */
    int axis;              /* 0, 1, 2: along gravity */
    double sign;           /* [-] 1: it leads upwards; else -1 */
    int rows, n, first;    /* [-] room, rows so far, first one that counts */
    double *series;        /* rows of time and scalars */
    double *room;          /* 2 a particle */
    struct layers *layers; /* NULL without fluid */
    struct grain_series *grains; /* NULL unless asked for */
};

/* --- the grains ----------------------------------------------------------- */

/* It belongs to the owner (base/alloc.h). */
static struct grain_series *grain_series_create(void *owner, int capacity,
                                                int rows)
{
    struct grain_series *const g = owner_zeroed(owner, 1, sizeof *g);

    g->capacity = capacity;
    g->rows = rows;
    g->Cd = owner_doubles(owner, capacity * rows);
    g->Re = owner_doubles(owner, capacity);
    g->eps = owner_doubles(owner, capacity);
    return g;
}

/* 1 if the particles are 0 .. n - 1, n of them. */
static int are_the_first(const struct particles *ps, int n)
{
    int highest = -1;

    for (int i = 0; i < ps->n; i++)
        highest = ps->id[i] > highest ? ps->id[i] : highest;
    return ps->n == n && highest == n - 1;
}

/* C_d [EW18 26] of the whole force, the drag over eps, with the coefficient
 * that the fluid is charged with, and Re_p [EW18 27]. The grains are those of
 * the first sample, with the numbers 0, 1, ...: when one has been inserted or
 * removed there are no more samples. */
static void grain_series_add(struct grain_series *g,
                             const struct simulation *sim)
{
    const struct fluid_options *const o = &sim->fluid->options;
    const struct particles *const ps = sim->particles;
    const struct coupling *const cp = sim->coupling;

    if (g->n_rows == 0) g->n = ps->n;
    g->changed = g->changed || !are_the_first(ps, g->n);
    if (g->changed || ps->n == 0) return;
    for (int i = 0; i < ps->n; i++) {
        const int id = ps->id[i];
        const double *const u = &cp->u_f[3 * i], eps = cp->eps[i];
        const double d = particles_grain(ps, i), N = particles_grains(ps, i);
        const double w =
            gsl_hypot3(u[0] - ps->vx[i], u[1] - ps->vy[i], u[2] - ps->vz[i]);
        g->eps[id] = eps;
        g->Re[id] = coefficient_reynolds(eps, o->rho, o->mu, d, w);
        g->Cd[(long)id * g->rows + g->n_rows] =
            w > 0.0 ? coefficient_of_force(cp->rate[i] / N * w / eps, o->rho, d,
                                           eps, w)
                    : 0.0;
    }
    g->n_rows++;
}

static void grain_series_state(struct grain_series *g, struct state *s)
{
    state_count(s, "grain_rows", &g->n_rows, g->rows);
    state_count(s, "grains", &g->n, g->capacity);
    state_whole(s, "changed", "-", &g->changed);
    if (g->n_rows > 0)
        state_reals_of(s, "C_d", "-", g->Cd, (size_t)g->rows * sizeof *g->Cd,
                       g->n, g->n_rows);
    state_reals(s, "Re_p", "-", g->Re, g->n, 1);
    state_reals(s, "eps_f", "-", g->eps, g->n, 1);
}

/* --- the layers ----------------------------------------------------------- */

static int layer_of(const struct mesh *m, int axis, int n, double x)
{
    if (m->face_centre == NULL) { /* a box, whose edges are known */
        int k = 0;
        while (k < n - 1 && x > m->box.edge[axis][k + 1])
            k++;
        return k;
    }
    const double length = m->hi[axis] - m->lo[axis];
    return number_clamped((x - m->lo[axis]) / length * n, 0, n - 1);
}

/* Cells whose centres have the same coordinate along an axis are a layer; in a
 * mesh without layers, as many equal slices as the box has cells on an edge. */
static struct layers *layers_create(void *owner, const struct mesh *m, int axis,
                                    int rows)
{
    struct layers *const l = owner_zeroed(owner, 1, sizeof *l);

    l->n = m->face_centre == NULL ? m->box.n[axis]
                                  : number_clamped(cbrt(m->n_cells), 1, 1000);
    l->rows = rows;
    l->cells = m->n_cells;
    l->V = m->V;
    l->layer = owner_ints(owner, m->n_cells);
    l->height = owner_doubles(owner, l->n);
    l->volume = owner_doubles(owner, l->n);
    l->eps = owner_doubles(owner, l->n * rows);
    for (int c = 0; c < m->n_cells; c++) {
        const double x = m->centre[3 * c + axis];
        const int k = l->layer[c] = layer_of(m, axis, l->n, x);
        l->volume[k] += m->V[c];
        l->height[k] += m->V[c] * x;
    }
    for (int k = 0; k < l->n; k++)
        if (l->volume[k] > 0.0) l->height[k] /= l->volume[k];
    return l;
}

static void layers_add(struct layers *l, const double *eps)
{
    double *const row = &l->eps[l->n * l->n_rows++];

    for (int c = 0; c < l->cells; c++)
        row[l->layer[c]] += eps[c] * l->V[c] / l->volume[l->layer[c]];
}

static void layers_state(struct layers *l, struct state *s)
{
    state_count(s, "layer_rows", &l->n_rows, l->rows);
    state_reals(s, "layer_eps", "-", l->eps, l->n_rows, l->n);
}

/* --- the files ------------------------------------------------------------ */

static int write_table(const struct statistics *self, const char *name,
                       int n_columns, const char *const *columns, int rows,
                       const double *values)
{
    char *const path = folder_file(self->folder, name);
    const int failed =
        path == NULL || table_write(path, n_columns, columns, rows, values);

    free(path);
    return failed;
}

static int write_series(const struct statistics *self)
{
    struct table_head head = {0};

    table_head_add(&head, "time [s]");
    for (int k = 0; k < self->n_scalars; k++)
        table_head_add(&head, "%s [%s]", scalars[k].name, scalars[k].unit);
    const int failed =
        write_table(self, "statistics/series.csv", head.n,
                    (const char *const *)head.name, self->n, self->series);
    table_head_clear(&head);
    return failed;
}

static int write_profile(const struct statistics *self)
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
static double correlate(const struct statistics *self, int lags, double *rows)
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

static int write_density(const struct statistics *self, int n, const double *x)
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

static int write_grains(const struct statistics *self, struct summary *f)
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

static void write_scalar(const struct statistics *self, struct summary *f,
                         int k)
{
    const int stride = 1 + self->n_scalars, n = self->n - self->first;
    double *const x = alloc_doubles(n);

    for (int i = 0; i < n; i++)
        x[i] = self->series[stride * (self->first + i) + 1 + k];
    summary_begin(f, scalars[k].name);
    summary_number(f, "mean", moments_mean(n, x));
    summary_number(f, "error", moments_block_error(n, x, self->blocks));
    summary_number(f, "deviation", moments_deviation(n, x));
    summary_end(f);
    free(x);
}

static int statistics_finish(void *memory)
{
    const struct statistics *const self = memory;

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

/* --- the samples ---------------------------------------------------------- */

static void *statistics_create(const struct recorder_view *v, int *failed)
{
    const struct output_options *const o = v->of->output;

    (void)failed; /* nothing is written before the end */
    if (!o->statistics.on) return NULL;
    struct statistics *const self = owner_create(sizeof *self);
    const long rows = v->of->steps / v->of->row_every + 2;

    self->sim = v->sim;
    self->folder = v->folder;
    self->n_scalars = SCALARS - (v->sim->fluid == NULL);
    self->from = o->statistics.from;
    /* A run may be resumed with a later end, so this is no error. */
    if (o->statistics.from >= o->end && !v->of->quiet)
        fprintf(stderr,
                "the statistics begin at %g s, after the end at %g s: they "
                "have no samples, unless the run goes on later\n",
                self->from, o->end);
    self->quiet = v->of->quiet;
    self->plateau = o->statistics.plateau;
    self->blocks = o->statistics.blocks;
    self->dt = (double)v->of->row_every * v->sim->dt;
    double up[3];
    history_up(v->sim, up);
    self->axis = vector_axis(up);
    self->sign = up[self->axis] > 0.0 ? 1.0 : -1.0;
    self->rows = (int)rows;
    self->first = -1;
    self->series = owner_doubles(self, (1 + SCALARS) * self->rows);
    self->room = owner_doubles(self, 2 * v->sim->particles->capacity);
    if (v->sim->fluid != NULL)
        self->layers =
            layers_create(self, v->sim->mesh, self->axis, self->rows);
    if (v->sim->coupling != NULL && o->statistics.lags > 0.0) {
        const double lags = o->statistics.lags / self->dt;
        self->lags = number_clamped(lags, 0, self->rows / 2) + 1;
        /* Of a run that is resumed there are none yet. */
        self->grains =
            grain_series_create(self, v->sim->particles->capacity, self->rows);
    }
    return self;
}

/* One row of series.csv. */
static void sample_scalars(struct statistics *self, double *row)
{
    const struct simulation *const sim = self->sim;
    const struct particles *const ps = sim->particles;
    const double *const v[3] = {ps->vx, ps->vy, ps->vz};
    const double *const x[3] = {ps->x, ps->y, ps->z};
    const int a = self->axis;
    const double up = self->sign;
    const double floor = up > 0.0 ? sim->mesh->lo[a] : -sim->mesh->hi[a];

    for (int i = 0; i < ps->n; i++)
        self->room[i] = up * x[a][i];
    row[0] = sim->t;
    row[1] = temperature_of(ps->n, v[a]);
    row[2] = 0.5 * (temperature_of(ps->n, v[(a + 1) % 3]) + /* a mean each */
                    temperature_of(ps->n, v[(a + 2) % 3]));
    row[3] = temperature_bed_height(ps->n, self->room, floor);
    row[4] = temperature_percentile(ps->n, self->room, 0.99,
                                    self->room + ps->capacity) -
             floor;
    if (sim->fluid != NULL) row[5] = history_pressure_drop(sim);
}

static int statistics_add(void *memory)
{
    struct statistics *const self = memory;
    const int stride = 1 + self->n_scalars;

    if (self->n >= self->rows) return 0; /* the last state, once more */
    sample_scalars(self, &self->series[stride * self->n++]);
    if (self->sim->t < self->from - 0.5 * self->dt) return 0;
    if (self->first < 0) self->first = self->n - 1;
    if (self->layers != NULL) layers_add(self->layers, self->sim->fluid->eps);
    if (self->grains != NULL) grain_series_add(self->grains, self->sim);
    return 0;
}

static void statistics_visit(void *memory, struct state *s)
{
    struct statistics *const self = memory;

    state_begin(s, "statistics");
    state_count(s, "rows", &self->n, self->rows);
    state_indices(s, "first", &self->first, 1, -1, self->n - 1);
    state_reals(s, "series", "s m2/s2 m2/s2 m m Pa", self->series, self->n,
                1 + self->n_scalars);
    if (self->layers != NULL) layers_state(self->layers, s);
    if (self->grains != NULL) grain_series_state(self->grains, s);
    state_end(s);
}

const struct recorder_part recorder_statistics = {.create = statistics_create,
                                                  .free = owner_free,
                                                  .row = statistics_add,
                                                  .finish = statistics_finish,
                                                  .state = statistics_visit};
