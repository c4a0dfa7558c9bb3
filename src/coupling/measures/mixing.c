/* SPDX-License-Identifier: GPL-3.0-or-later */
/* mixing.c -- how far the particles have mixed, in history.csv.
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
 * nothing to mix, and M is written as 0.
 */
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_sort_double.h>

#include "base/alloc.h"
#include "base/number.h"
#include "base/state.h"
#include "coupling/effect_columns.h"
#include "coupling/effects.h"
#include "coupling/simulation.h"

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
    struct mixing *const self = alloc_zeroed(1, sizeof *self);
    const struct mesh *const m = sim->mesh;
    int samples = 1;

    self->labels = sim->particles->next_id;
    self->marked = alloc_ints(self->labels);
    mixing_mark(self, sim->particles, &parameters[1]);
    for (int k = 0; k < 3; k++) {
        const double n = (m->hi[k] - m->lo[k]) / parameters[0];
        self->n[k] = number_clamped(n + 0.5, 1, 1000);
        samples *= self->n[k];
    }
    self->all = alloc_doubles(samples);
    self->some = alloc_doubles(samples);
    return self;
}

static void mixing_free(void *memory)
{
    struct mixing *const self = memory;

    if (self == NULL) return;
    free(self->marked);
    free(self->all);
    free(self->some);
    free(self);
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
    if (s->loading && !s->failed) {
        free(self->marked);
        self->marked = alloc_ints(self->labels);
    }
    state_wholes(s, "marked", "-", self->marked, self->labels, 1);
}

static const char *const names[] = {"mixing [-]", NULL};

static const struct effect_columns columns = {names, mixing_row};

static const struct key keys[] = {
    {"effects.mixing", KEY_GROUP, "", "", KEY_OPTIONAL,
     "Lacey's mixing index of two halves of the particles, as a column of "
     "history.csv",
     "Lacey54", "particles"},
    {"effects.mixing.sample", KEY_REAL, "m", "> 0", NULL,
     "width of the samples, about; they divide the box evenly", "Lacey54", "",
     .at = KEY_AT(effects_options, mixing_sample)},
    {"effects.mixing.direction", KEY_VECTOR, "-", "", "[0.0, 1.0, 0.0]",
     "the half that is farther along it at the beginning is marked", "", ""},
    {0}};

const struct effect mixing_effect = {
    .name = "mixing",
    .what = "mixing index of two halves of the particles",
    .equations = "",
    .function = "mixing_row",
    .keys = {keys},
    .create = mixing_create,
    .columns = &columns,
    .state = mixing_state,
    .free = mixing_free,
};
