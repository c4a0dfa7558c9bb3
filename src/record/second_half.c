/* SPDX-License-Identifier: GPL-3.0-or-later */
/* second_half.c -- means over the second half of a run, for its summary, and
 * what makes such a mean meaningless.  Chapter "Output".
 *
 * The mean over a few bubbles has a large statistical error, and that of a bed
 * whose bubbles stay on one side, or that moves up and down as a whole, does
 * not describe bubbling. The summary therefore has, besides the mean pressure
 * drop and the weight of the bed,
 *
 *   mean_pressure_drop_error   the error of the first by blocks [Pa]
 *   particle_velocity_rms      over particles and time [m/s]
 *   horizontal_velocity_rms    of the bed as a whole: its momentum normal to
 *                              gravity over its mass [m/s]
 *   vertical_velocity_rms      the same along gravity: plane pumping [m/s]
 *   lean, lean_error           how far its centre is off the middle along x (y,
 *                              where x leads upwards), over half the width [-],
 *                              and the error by blocks
 */
#include "record/recorder_part.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "base/vector.h"
#include "record/history.h"
#include "coupling/processes.h"
#include "output/means/means.h"

/* What a row of the history adds: two numbers with errors by blocks, and the
 * mean squares of speeds. */
enum {
    DROP,
    LEAN,
    N_BLOCKED,
    WEIGHT = N_BLOCKED,
    BUOYANT,
    SPEED,
    LEVEL,
    UPRIGHT,
    N
};

/* All rows are kept, for a run that is resumed may get a later end, and its
 * second half is then another one. */
struct second_half {
    const struct simulation *sim;
    double end; /* [s] */
    int rows, capacity;
    double *time;     /* [s] */
    double (*row)[N]; /* [Pa, -, Pa, Pa, m^2/s^2, m^2/s^2, m^2/s^2] */
};

void *second_half_create(const struct simulation *sim, double end)
{
    struct second_half *const h = alloc_zeroed(1, sizeof *h);

    h->sim = sim;
    h->end = end;
    return h;
}

void second_half_free(void *part)
{
    struct second_half *const h = part;

    if (h == NULL) return;
    free(h->time);
    free(h->row);
    free(h);
}

/* Mean squares of the velocities, and the lean, of the whole bed. */
static void put_bed(const struct second_half *h, double row[N])
{
    const struct particles *const ps = h->sim->particles;
    const struct mesh *const m = h->sim->mesh;
    const double *const g = h->sim->gravity;
    double up[3];
    history_up(h->sim, up);
    const int a = vector_axis(up) == 0; /* the axis across */
    const double *const at = a == 0 ? ps->x : ps->y;
    double sum[6] = {0.0}; /* of m, m x, m v^2 and the momentum */

    for (int i = 0; i < ps->n; i++) {
        const double v[3] = {ps->vx[i], ps->vy[i], ps->vz[i]};
        sum[0] += ps->m[i];
        sum[1] += ps->m[i] * at[i];
        sum[2] += ps->m[i] * vector_dot(v, v);
        for (int k = 0; k < 3; k++)
            sum[3 + k] += ps->m[i] * v[k];
    }
    processes_sum(h->sim, 6, sum);
    const double mass = sum[0], *const p = &sum[3];
    if (mass == 0.0) return;
    const double gg = vector_dot(g, g);
    const double along = gg > 0.0 ? vector_dot(p, g) / sqrt(gg) : 0.0;
    row[SPEED] = sum[2] / mass;
    row[UPRIGHT] = along * along / (mass * mass);
    row[LEVEL] = (vector_dot(p, p) - along * along) / (mass * mass);
    row[LEAN] =
        (2.0 * sum[1] / mass - m->lo[a] - m->hi[a]) / (m->hi[a] - m->lo[a]);
}

static void second_half_grow(struct second_half *h, int capacity)
{
    h->time = alloc_grown(h->time, h->rows, capacity, sizeof *h->time);
    h->row = alloc_grown(h->row, h->rows, capacity, sizeof *h->row);
    h->capacity = capacity;
}

int second_half_add(void *part)
{
    struct second_half *const h = part;

    if (h->sim->fluid == NULL) return 0;
    if (h->rows == h->capacity) second_half_grow(h, 2 * h->rows + 16);
    double *const row = h->row[h->rows];
    for (int k = 0; k < N; k++)
        row[k] = 0.0;
    h->time[h->rows++] = h->sim->t;
    row[DROP] = history_pressure_drop(h->sim);
    if (h->sim->particles == NULL) return 0;
    row[WEIGHT] = history_bed_weight(h->sim);
    row[BUOYANT] = history_buoyant_weight(h->sim);
    put_bed(h, row);
    return 0;
}

/* The first row of the second half. */
static int first(const struct second_half *h)
{
    int k = h->rows;

    while (k > 0 && h->time[k - 1] >= 0.5 * h->end)
        k--;
    return k;
}

static double second_half_mean(const struct second_half *h, int column)
{
    double sum = 0.0;

    for (int k = first(h); k < h->rows; k++)
        sum += h->row[k][column];
    return sum / (double)(h->rows - first(h));
}

/* The errors of the means by blocks. */
static void find_errors(const struct second_half *h, double error[N_BLOCKED])
{
    static const double once[N_BLOCKED] = {1.0, 1.0};
    struct mean_blocks *const blocks = mean_blocks_create(N_BLOCKED);

    for (int k = first(h); k < h->rows; k++)
        mean_blocks_add(blocks, h->row[k], once);
    for (int q = 0; q < N_BLOCKED; q++)
        error[q] = mean_blocks_error(blocks, q);
    owner_free(blocks);
}

/* --- as a part of the recorder -------------------------------------------- */

static void second_half_visit(void *part, struct state *s)
{
    struct second_half *const h = part;

    state_begin(s, "second_half");
    state_count(s, "rows", &h->rows, INT_MAX);
    if (s->loading && !s->failed) {
        const int rows = h->rows;
        h->rows = 0;
        second_half_grow(h, rows + 16);
        h->rows = rows;
    }
    state_reals(s, "time", "s", h->time, h->rows, 1);
    state_reals(s, "row", "Pa - Pa m2/s2", h->rows > 0 ? h->row[0] : NULL,
                h->rows, N);
    state_end(s);
}

static void *second_half_of(const struct recorder_view *v, int *failed)
{
    (void)failed;
    return second_half_create(v->sim, v->of->output->end);
}

static void second_half_summarize(const void *part, struct summary *to)
{
    const struct second_half *const h = part;
    double error[N_BLOCKED];

    if (first(h) == h->rows) return;
    find_errors(h, error);
    summary_begin(to, "second_half");
    summary_number(to, "mean_pressure_drop", second_half_mean(h, DROP));
    if (h->sim->particles != NULL) {
        summary_number(to, "bed_weight", second_half_mean(h, WEIGHT));
        summary_number(to, "buoyant_weight", second_half_mean(h, BUOYANT));
    }
    summary_number(to, "mean_pressure_drop_error", error[DROP]);
    if (h->sim->particles != NULL) {
        summary_number(to, "particle_velocity_rms",
                       sqrt(second_half_mean(h, SPEED)));
        summary_number(to, "horizontal_velocity_rms",
                       sqrt(second_half_mean(h, LEVEL)));
        summary_number(to, "vertical_velocity_rms",
                       sqrt(second_half_mean(h, UPRIGHT)));
        summary_number(to, "lean", second_half_mean(h, LEAN));
        summary_number(to, "lean_error", error[LEAN]);
    }
    summary_end(to);
}

static void second_half_print(const void *part)
{
    const struct second_half *const h = part;

    if (first(h) == h->rows || h->sim->particles == NULL) return;
    printf("pressure drop %.1f Pa (mean of the second half), buoyant weight of "
           "the bed %.1f Pa%s\n",
           second_half_mean(h, DROP), second_half_mean(h, BUOYANT),
           h->sim->mesh->shape != NULL ? " over the mean section" : "");
}

const struct recorder_part recorder_second_half = {.create = second_half_of,
                                                   .free = second_half_free,
                                                   .row = second_half_add,
                                                   .summarize =
                                                       second_half_summarize,
                                                   .print = second_half_print,
                                                   .state = second_half_visit};
