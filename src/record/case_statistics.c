/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "record/case_statistics.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "base/number.h"
#include "case/case_steps.h"
#include "base/text.h"
#include "record/history_sums.h"
#include "record/grain_series.h"
#include "record/layers.h"
#include "record/statistics_files.h"

/* What is sampled as one number a row: the last only with a fluid. */
static const char *const names[STATISTICS_SCALARS] = {
    "temperature_axial", "temperature_transverse", "bed_height",
    "bed_height_99",     "pressure_drop",
};
static const char *const columns[1 + STATISTICS_SCALARS] = {
    "time [s]",
    "temperature_axial [m2/s2]",
    "temperature_transverse [m2/s2]",
    "bed_height [m]",
    "bed_height_99 [m]",
    "pressure_drop [Pa]",
};

/* The axis that gravity has most of; the way up, y, without it. */
static int case_statistics_axis_of(const double g[3])
{
    int axis = 1;

    for (int k = 0; k < 3; k++)
        if (fabs(g[k]) > fabs(g[axis])) axis = k;
    return axis;
}

/* A run may be resumed with a later end, so this is no error. */
static int begins_after_end(const struct settings *s)
{
    const struct output_options *const o = &s->output;
    return o->statistics.on && o->statistics.from >= o->end;
}

static void *case_statistics_create(const struct recorder_view *v, int *failed)
{
    const struct output_options *const o = &v->settings->output;

    (void)failed; /* nothing is written before the end */
    if (!o->statistics.on) return NULL;
    struct case_statistics *const self = alloc_zeroed(1, sizeof *self);
    const long rows = case_steps_until_end(v->settings) /
                          case_steps_between_rows(v->settings) +
                      2;

    self->sim = v->sim;
    self->folder = v->folder;
    self->names = names;
    self->columns = columns;
    self->n_scalars = STATISTICS_SCALARS - (v->sim->fluid == NULL);
    self->from = o->statistics.from;
    if (begins_after_end(v->settings) && !settings_quiet(v->settings))
        fprintf(stderr,
                "the statistics begin at %g s, after the end at %g s: they "
                "have no samples, unless the run goes on later\n",
                self->from, o->end);
    self->quiet = settings_quiet(v->settings);
    self->plateau = o->statistics.plateau;
    self->blocks = o->statistics.blocks;
    self->dt = (double)case_steps_between_rows(v->settings) * v->sim->dt;
    self->axis = case_statistics_axis_of(v->sim->gravity);
    self->rows = (int)rows;
    self->first = -1;
    self->series = alloc_doubles((1 + STATISTICS_SCALARS) * self->rows);
    self->room = alloc_doubles(2 * v->sim->particles->capacity);
    if (v->sim->fluid != NULL)
        self->layers = layers_create(v->sim->mesh, self->axis, self->rows);
    if (v->sim->coupling != NULL && o->statistics.lags > 0.0) {
        const double lags = o->statistics.lags / self->dt;
        self->lags = number_clamped(lags, 0, self->rows / 2) + 1;
        /* Of a run that is resumed there are none yet. */
        self->grains =
            grain_series_create(v->sim->particles->capacity, self->rows);
    }
    return self;
}

static void case_statistics_release(void *memory)
{
    struct case_statistics *const self = memory;

    free(self->series);
    free(self->room);
    layers_free(self->layers);
    grain_series_free(self->grains);
    free(self);
}

/* The two components across the axis, with one mean each. */
static double transverse_temperature(const struct case_statistics *self)
{
    const struct particles *const ps = self->sim->particles;
    const double *const v[3] = {ps->vx, ps->vy, ps->vz};

    return 0.5 * (temperature_of(ps->n, v[(self->axis + 1) % 3]) +
                  temperature_of(ps->n, v[(self->axis + 2) % 3]));
}

/* One row of series.csv. */
static void sample_scalars(struct case_statistics *self, double *row)
{
    const struct simulation *const sim = self->sim;
    const struct particles *const ps = sim->particles;
    const double *const v[3] = {ps->vx, ps->vy, ps->vz};
    const double *const x[3] = {ps->x, ps->y, ps->z};
    const int a = self->axis;
    const double up = sim->gravity[a] > 0.0 ? -1.0 : 1.0;
    const double floor = up > 0.0 ? sim->mesh->lo[a] : -sim->mesh->hi[a];

    for (int i = 0; i < ps->n; i++)
        self->room[i] = up * x[a][i];
    row[0] = sim->t;
    row[1] = temperature_of(ps->n, v[a]);
    row[2] = transverse_temperature(self);
    row[3] = temperature_bed_height(ps->n, self->room, floor);
    row[4] = temperature_percentile(ps->n, self->room, 0.99,
                                    self->room + ps->capacity) -
             floor;
    if (sim->fluid != NULL) row[5] = history_pressure_drop(sim);
}

static int case_statistics_add(void *memory)
{
    struct case_statistics *const self = memory;
    const int stride = 1 + self->n_scalars;

    if (self->n >= self->rows) return 0; /* the last state, once more */
    sample_scalars(self, &self->series[stride * self->n++]);
    if (self->sim->t < self->from - 0.5 * self->dt) return 0;
    if (self->first < 0) self->first = self->n - 1;
    if (self->layers != NULL) layers_add(self->layers, self->sim->fluid->eps);
    if (self->grains != NULL) grain_series_add(self->grains, self->sim);
    return 0;
}

static void case_statistics_visit(void *memory, struct state *s)
{
    struct case_statistics *const self = memory;

    state_begin(s, "statistics");
    state_count(s, "rows", &self->n, self->rows);
    state_indices(s, "first", &self->first, 1, -1, self->n - 1);
    state_reals(s, "series", "s m2/s2 m2/s2 m m Pa", self->series, self->n,
                1 + self->n_scalars);
    if (self->layers != NULL) layers_state(self->layers, s);
    if (self->grains != NULL) grain_series_state(self->grains, s);
    state_end(s);
}

static int case_statistics_finish(void *memory)
{
    return statistics_files_write(memory);
}

const struct key case_statistics_keys[] = {
    {"output.statistics", KEY_GROUP, "", "", KEY_OPTIONAL,
     "means, errors, correlations of a bed, in the folder statistics",
     "EW18 23-31", "particles", .given = KEY_AT(output_options, statistics.on)},
    {"output.statistics.from", KEY_REAL, "s", ">= 0", "0.0",
     "time of the first sample; each row of history.csv is one", "EW18 23", "",
     .at = KEY_AT(output_options, statistics.from)},
    {"output.statistics.blocks", KEY_INT, "-", ">= 2, <= 1000", "8",
     "blocks for the standard errors; each should be longer than the "
     "correlation time",
     "", "", .at = KEY_AT(output_options, statistics.blocks)},
    {"output.statistics.lags", KEY_REAL, "s", "> 0", KEY_OPTIONAL,
     "longest time of the correlation of the grains' drag coefficients, whose "
     "series are then kept as long as no grain is inserted or removed; left "
     "out: none",
     "EW18 28", "exchange", .at = KEY_AT(output_options, statistics.lags)},
    {"output.statistics.plateau", KEY_REAL, "s", ">= 0", "0.0",
     "integral times are means over ends beyond this", "EW18 31", "",
     .at = KEY_AT(output_options, statistics.plateau)},
    KEY_END};

void case_statistics_print(const struct settings *s)
{
    if (begins_after_end(s))
        text_line("statistics", s->output.statistics.from, "s",
                  "they begin after the end: there are no samples");
}

const struct recorder_part case_statistics_output = {
    .create = case_statistics_create,
    .free = case_statistics_release,
    .row = case_statistics_add,
    .finish = case_statistics_finish,
    .state = case_statistics_visit};
