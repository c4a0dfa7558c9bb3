/* SPDX-License-Identifier: GPL-3.0-or-later */
/* measures.c -- effects that move nothing: they measure, in history.csv or in
 * fields. */
#include "base/alloc.h"
#include "base/number.h"
#include "base/state.h"
#include "coupling/effect.h"
#include "coupling/effects.h"
#include "coupling/effects/forces.h"
#include "coupling/simulation.h"
#include "coupling/transfer.h"

#include <gsl/gsl_math.h>
#include <gsl/gsl_sort_double.h>
#include <limits.h>
#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

/* --- bubbles -------------------------------------------------------------- */

/* Number, size and frequency of the bubbles of a bed, in
 * history.csv.  Chapter "Beds, compared with measurements".
 *
 * A bubble is a set of cells with eps_f above a threshold that are joined by
 * their faces, and of which none is at an outlet: what is open to the space
 * above the bed is part of it. As seen from the front its diameter is that of a
 * circle,
 *
 *     d_b = sqrt(4 V_b / (pi L_z)),                                    (27.1)
 *
 * V_b its volume and L_z the depth of the box. A bubble passes a height when
 * the number of those that have cells there grows. Nothing is computed between
 * two rows of the history. */

struct bubbles {
    double threshold; /* [-] */
    double height;    /* [m] */
    double smallest;  /* [m^3] that counts */
    double depth;     /* [m] L_z */
    int *root;        /* [-] of each cell: the first one of its set, or -1 */
    double *volume;   /* [m^3] of the set, at its first cell */
    char *open;       /* [-] beside it: 1 if the set is at an outlet */
    char *passing;    /* [-] beside it: 1 if it has a cell at the height */
    int at_height;    /* [-] bubbles there in the last row */
    long passed;      /* [-] so far */
};

static void *bubbles_create(struct simulation *sim, const double *parameters)
{
    struct bubbles *const b = owner_create(sizeof *b);
    const int n = sim->mesh->n_cells;

    b->threshold = parameters[0];
    b->height = parameters[1];
    b->depth = sim->mesh->hi[2] - sim->mesh->lo[2];
    b->smallest = M_PI / 4.0 * parameters[2] * parameters[2] * b->depth;
    b->root = owner_ints(b, n);
    b->volume = owner_doubles(b, n);
    b->open = owner_zeroed(b, (size_t)n, 1);
    b->passing = owner_zeroed(b, (size_t)n, 1);
    return b;
}

/* The first cell of the set that a cell is in; the way to it is cut short. */
static int first_of(int *root, int c)
{
    while (root[c] != c) {
        root[c] = root[root[c]];
        c = root[c];
    }
    return c;
}

static void join_cells(struct bubbles *b, const struct simulation *sim)
{
    const struct mesh *const m = sim->mesh;

    for (int c = 0; c < m->n_cells; c++)
        b->root[c] = sim->fluid->eps[c] > b->threshold ? c : -1;
    for (int f = 0; f < m->n_internal; f++) {
        int i = m->owner[f], j = m->neighbour[f];

        if (b->root[i] < 0 || b->root[j] < 0) continue;
        i = first_of(b->root, i);
        j = first_of(b->root, j);
        b->root[i > j ? i : j] = i > j ? j : i;
    }
}

/* 1 if the height is within the cell, or in its lower half for a cell that is
 * no box. */
static int is_at(const struct mesh *m, int c, double height)
{
    if (m->face_centre != NULL)
        return fabs(m->centre[3 * c + 1] - height) < 0.5 * cbrt(m->V[c]);
    const int j = c / m->box.n[0] % m->box.n[1];
    return m->box.edge[1][j] <= height && height < m->box.edge[1][j + 1];
}

/* Measures each set of cells: volume [m^3], whether it is open, passes the
 * height. */
static void measure_sets(struct bubbles *b, const struct simulation *sim)
{
    const struct mesh *const m = sim->mesh;
    const size_t n = (size_t)m->n_cells;

    memset(b->volume, 0, n * sizeof *b->volume);
    memset(b->open, 0, n);
    memset(b->passing, 0, n);
    for (int c = 0; c < m->n_cells; c++) {
        if (b->root[c] < 0) continue;
        const int r = first_of(b->root, c);
        b->volume[r] += m->V[c];
        if (is_at(m, c, b->height)) b->passing[r] = 1;
    }
    for (int p = 0; p < m->n_patches; p++) {
        if (sim->fluid->options.boundaries[p].kind != BOUNDARY_OUTLET) continue;
        for (int f = m->patches[p].first;
             f < m->patches[p].first + m->patches[p].n; f++)
            if (b->root[m->owner[f]] >= 0)
                b->open[first_of(b->root, m->owner[f])] = 1;
    }
}

static int bubbles_row(void *memory, const struct simulation *sim,
                       double *values)
{
    struct bubbles *const b = memory;
    double all = 0.0, largest = 0.0;
    int count = 0, at_height = 0;

    join_cells(b, sim);
    measure_sets(b, sim);
    for (int c = 0; c < sim->mesh->n_cells; c++) {
        if (b->root[c] != c || b->open[c] || b->volume[c] < b->smallest)
            continue;
        count++;
        at_height += b->passing[c];
        all += b->volume[c];
        largest = fmax(largest, b->volume[c]);
    }
    if (at_height > b->at_height) b->passed += at_height - b->at_height;
    b->at_height = at_height;
    values[0] = count;
    values[1] = all;
    values[2] = sqrt(4.0 * largest / (M_PI * b->depth)); /* (27.1) */
    values[3] = (double)b->passed;
    return 4;
}

static void bubbles_state(void *memory, struct state *s)
{
    struct bubbles *const b = memory;

    state_whole(s, "at_height", "-", &b->at_height);
    state_long(s, "passed", "-", &b->passed);
}

static const char *const bubbles_names[] = {"bubbles [-]", "bubble_volume [m3]",
                                            "largest_bubble [m]",
                                            "bubbles_passed [-]", NULL};

static const struct effect_columns bubbles_columns = {bubbles_names,
                                                      bubbles_row};

static const struct key bubbles_keys[] = {
    {"effects.bubbles", KEY_GROUP, "", "", KEY_OPTIONAL,
     "number and size of bubbles, and how many pass a height, as columns of "
     "history.csv",
     "", "fluid particles averaging exchange"},
    {"effects.bubbles.threshold", KEY_REAL, "-", "> 0, < 1", "0.8",
     "eps_f above which a cell belongs to a bubble", "", ""},
    {"effects.bubbles.height", KEY_REAL, "m", ">= 0", NULL,
     "y at which passing bubbles are counted", "", ""},
    {"effects.bubbles.smallest", KEY_REAL, "m", ">= 0", "0.0",
     "smallest diameter of a bubble that is counted", "", ""},
    KEY_END};

const struct effect bubbles_effect = {
    .name = "bubbles",
    .what = "bubbles of a bed, counted and measured",
    .equations = "",
    .function = "bubbles_row",
    .keys = {bubbles_keys},
    .create = bubbles_create,
    .columns = &bubbles_columns,
    .state = bubbles_state,
};

/* --- mixing --------------------------------------------------------------- */

/* How far the particles have mixed, in history.csv.
 * Chapter "Beds, compared with measurements".
 *
 * At the beginning half of the particles are marked: those farther along a
 * direction than the median. The box is divided into samples; sample k has n_k
 * particles, of which the share p_k is marked. Of all N particles in K samples
 * it is p. With the variances [Lacey54]
 *
 *     S^2   = sum_k n_k (p_k - p)^2 / N,
 *     S_0^2 = p (1 - p),   S_R^2 = p (1 - p) (K - 1) / (N - 1),
 *
 *     M = (S_0^2 - S^2) / (S_0^2 - S_R^2)                              (27.2)
 *
 * is 0 where each sample has particles of one kind, and 1 on average where
 * their places are random. [Lacey54] has samples of one size n, and 1 / n for
 * (K - 1) / (N - 1), which is what random places give for samples of any size.
 * Where all particles are of one kind, or each is alone in its sample, there is
 * nothing to mix, and M is written as 0. */

struct mixing {
    int labels;         /* [-] particles with an id below have one */
    int *marked;        /* [-] by id */
    int n[3];           /* [-] samples along x, y, z */
    double *all, *some; /* [-] particles of each sample, and marked ones */
};

static double mixing_along(const struct particles *ps, int i, const double e[3])
{
    return ps->x[i] * e[0] + ps->y[i] * e[1] + ps->z[i] * e[2];
}

static void mixing_mark(struct mixing *self, const struct particles *ps,
                        const double e[3])
{
    double *const s = alloc_doubles(ps->n);

    for (int i = 0; i < ps->n; i++)
        s[i] = mixing_along(ps, i, e);
    gsl_sort(s, 1, (size_t)ps->n);
    const double median = ps->n > 0 ? s[ps->n / 2] : 0.0;
    for (int i = 0; i < ps->n; i++)
        self->marked[ps->id[i]] = mixing_along(ps, i, e) >= median;
    free(s);
}

static void *mixing_create(struct simulation *sim, const double *parameters)
{
    struct mixing *const self = owner_create(sizeof *self);
    const struct mesh *const m = sim->mesh;
    int samples = 1;

    self->labels = sim->particles->next_id;
    self->marked = owner_ints(self, self->labels);
    mixing_mark(self, sim->particles, &parameters[1]);
    for (int k = 0; k < 3; k++) {
        const double n = (m->hi[k] - m->lo[k]) / parameters[0];
        self->n[k] = number_clamped(n + 0.5, 1, 1000);
        samples *= self->n[k];
    }
    self->all = owner_doubles(self, samples);
    self->some = owner_doubles(self, samples);
    return self;
}

/* The sample that a point of the box is in. */
static int sample_at(const struct mixing *self, const struct mesh *m,
                     const double x[3])
{
    int at[3];

    for (int k = 0; k < 3; k++) {
        const double part = (x[k] - m->lo[k]) / (m->hi[k] - m->lo[k]);
        at[k] = number_clamped(part * self->n[k], 0, self->n[k] - 1);
    }
    return at[0] + self->n[0] * (at[1] + self->n[1] * at[2]);
}

/* Counts all and the marked spheres of each sample. */
static void mixing_count(struct mixing *self, const struct simulation *sim)
{
    const struct particles *const ps = sim->particles;
    const size_t samples =
        (size_t)self->n[0] * (size_t)self->n[1] * (size_t)self->n[2];

    memset(self->all, 0, samples * sizeof *self->all);
    memset(self->some, 0, samples * sizeof *self->some);
    for (int i = 0; i < ps->n; i++) {
        if (ps->id[i] >= self->labels) continue; /* came later */
        const double x[3] = {ps->x[i], ps->y[i], ps->z[i]};
        const int k = sample_at(self, sim->mesh, x);
        self->all[k] += 1.0;
        self->some[k] += self->marked[ps->id[i]];
    }
}

/* (27.2) */
static int mixing_row(void *memory, const struct simulation *sim,
                      double *values)
{
    struct mixing *const self = memory;
    const int samples = self->n[0] * self->n[1] * self->n[2];
    double N = 0.0, K = 0.0, marked = 0.0, S2 = 0.0;

    mixing_count(self, sim);
    for (int k = 0; k < samples; k++) {
        N += self->all[k];
        K += self->all[k] > 0.0;
        marked += self->some[k];
    }
    const double p = N > 0.0 ? marked / N : 0.0;
    for (int k = 0; k < samples; k++) {
        if (self->all[k] == 0.0) continue;
        const double off = self->some[k] / self->all[k] - p;
        S2 += self->all[k] * off * off / N;
    }
    const double S2_0 = p * (1.0 - p);
    const double range = S2_0 * (1.0 - (K - 1.0) / fmax(1.0, N - 1.0));
    values[0] = range > 0.0 ? (S2_0 - S2) / range : 0.0;
    return 1;
}

/* Of a run that goes on the marks are those of its beginning. */
static void mixing_state(void *memory, struct state *s)
{
    struct mixing *const self = memory;

    state_count(s, "labels", &self->labels, INT_MAX);
    if (s->loading && !s->failed) self->marked = owner_ints(self, self->labels);
    state_wholes(s, "marked", "-", self->marked, self->labels, 1);
}

static const char *const mixing_names[] = {"mixing [-]", NULL};

static const struct effect_columns mixing_columns = {mixing_names, mixing_row};

static const struct key mixing_keys[] = {
    {"effects.mixing", KEY_GROUP, "", "", KEY_OPTIONAL,
     "Lacey's mixing index of two halves of the particles, as a column of "
     "history.csv",
     "Lacey54", "particles"},
    {"effects.mixing.sample", KEY_REAL, "m", "> 0", NULL,
     "width of the samples, about; they divide the box evenly", "Lacey54", "",
     KEY_AT(effects_options, mixing_sample)},
    {"effects.mixing.direction", KEY_VECTOR, "-", "", "[0.0, 1.0, 0.0]",
     "the half that is farther along it at the beginning is marked", "", ""},
    KEY_END};

const struct effect mixing_effect = {
    .name = "mixing",
    .what = "mixing index of two halves of the particles",
    .equations = "",
    .function = "mixing_row",
    .keys = {mixing_keys},
    .create = mixing_create,
    .columns = &mixing_columns,
    .state = mixing_state,
};

/* --- energy budget -------------------------------------------------------- */

/* The energy budget of the particles, in history.csv.
 *
 * A case without it runs contact loops that are compiled without its code; with
 * it they take half as long again. The motion of the particles has the same
 * bits with and without it. */

static void *energy_budget_create(struct simulation *sim,
                                  const double *parameters)
{
    (void)parameters;
    dem_start_energy_budget(sim->dem);
    return NULL;
}

static const struct key energy_budget_keys[] = {
    {"effects.energy_budget", KEY_GROUP, "", "", KEY_OPTIONAL,
     "energy of the particles, and its loss by each mechanism, in history.csv",
     "LS 4.16", "particles",
     .divided = "it is kept in the contact loop, which is LAMMPS'"},
    KEY_END};

const struct effect energy_budget_effect = {
    .name = "energy_budget",
    .what = "energy budget of the particles",
    .equations = "LS 4.16",
    .function = "neighbours_energy",
    .keys = {energy_budget_keys},
    .create = energy_budget_create,
};

/* --- time average --------------------------------------------------------- */

double time_average_weight(double dt, double b_t)
{
    return 1.0 / (1.0 + dt / b_t);
}

/* An implicit step [SX15 13] of the mean in which a value of age t weighs
 * exp(-t / b_t) / b_t [SX15 11]. */
void time_average_update(double alpha, int n, const double *now, double *mean)
{
    for (int i = 0; i < n; i++)
        mean[i] = (1.0 - alpha) * now[i] + alpha * mean[i];
}

static void *time_average_create(struct simulation *sim,
                                 const double *parameters)
{
    struct time_average *const self = owner_create(sizeof *self);
    const int n = sim->mesh->n_cells;

    self->alpha = time_average_weight(sim->dt, parameters[0]);
    self->n = n;
    self->eps = owner_doubles(self, n);
    self->eps_us = owner_doubles(self, 3 * n);
    return self;
}

/* The mean starts from the first field, not from zero. */
static void time_average_after_step(void *memory, struct simulation *sim)
{
    struct time_average *const self = memory;
    const struct fluid *const fl = sim->fluid;
    const int n = sim->mesh->n_cells;
    const double alpha = sim->steps == 1 ? 0.0 : self->alpha;

    transfer_solids_velocity(sim);
    time_average_update(alpha, n, fl->eps, self->eps);
    time_average_update(alpha, 3 * n, fl->eps_us, self->eps_us);
}

static void time_average_state(void *memory, struct state *s)
{
    struct time_average *const self = memory;

    state_reals(s, "eps", "-", self->eps, self->n, 1);
    state_reals(s, "eps_us", "m/s", self->eps_us, self->n, 3);
}

static int time_average_fields(const void *memory, struct effect_field *f)
{
    const struct time_average *const self = memory;

    f[0] = (struct effect_field){"mean_void_fraction", 1, self->eps};
    f[1] = (struct effect_field){"mean_solid_flux", 3, self->eps_us};
    return 2;
}

static const struct key time_average_keys[] = {
    {"effects.time_average", KEY_GROUP, "", "", KEY_OPTIONAL,
     "exponential moving averages of eps_f and eps_s u_s, written with the "
     "fluid",
     "SX15 11-14", "fluid particles averaging exchange",
     KEY_GIVEN(effects_options, time_average)},
    {"effects.time_average.time", KEY_REAL, "s", "> 0", NULL,
     "bandwidth b_t of the average in time", "SX15 11", ""},
    KEY_END};

const struct effect time_average_effect = {
    .name = "time_average",
    .what = "exponential moving averages of the averaged fields",
    .equations = "SX15 11-14",
    .function = "time_average_update",
    .keys = {time_average_keys},
    .create = time_average_create,
    .after_step = time_average_after_step,
    .fields = time_average_fields,
    .state = time_average_state,
};
