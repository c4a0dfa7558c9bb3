/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/second_half.h"

#include <math.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "base/vector.h"
#include "case/history_sums.h"
#include "output/block_means.h"

enum { DROP, LEAN, N_BLOCKED };

struct second_half {
    const struct simulation *sim;
    double from; /* [s] */
    long rows;
    double drop, weight;                /* [Pa] sums over the rows */
    double lean;                        /* [-] the same */
    double speed, horizontal, vertical; /* [m^2/s^2] of squares */
    struct block_means *blocks;
};

struct second_half *second_half_create(const struct simulation *sim, double end)
{
    struct second_half *const h = alloc_zeroed(1, sizeof *h);

    h->sim = sim;
    h->from = 0.5 * end;
    h->blocks = block_means_create(N_BLOCKED);
    return h;
}

void second_half_free(struct second_half *h)
{
    if (h == NULL) return;
    block_means_free(h->blocks);
    free(h);
}

/* The bed as a whole; returns how far it leans. */
static double add_bed(struct second_half *h)
{
    const struct particles *const ps = h->sim->particles;
    const struct mesh *const m = h->sim->mesh;
    const double *const g = h->sim->gravity;
    double mass = 0.0, x = 0.0, square = 0.0, p[3] = {0.0, 0.0, 0.0};

    for (int i = 0; i < ps->n; i++) {
        const double v[3] = {ps->vx[i], ps->vy[i], ps->vz[i]};
        mass += ps->m[i];
        x += ps->m[i] * ps->x[i];
        square += ps->m[i] * vector_dot(v, v);
        for (int k = 0; k < 3; k++)
            p[k] += ps->m[i] * v[k];
    }
    if (ps->n == 0) return 0.0;
    const double gg = vector_dot(g, g);
    const double along = gg > 0.0 ? vector_dot(p, g) / sqrt(gg) : 0.0;
    h->speed += square / mass;
    h->vertical += along * along / (mass * mass);
    h->horizontal += (vector_dot(p, p) - along * along) / (mass * mass);
    return (2.0 * x / mass - m->lo[0] - m->hi[0]) / (m->hi[0] - m->lo[0]);
}

void second_half_add(struct second_half *h)
{
    static const double once[N_BLOCKED] = {1.0, 1.0};
    double row[N_BLOCKED] = {0.0, 0.0};

    if (h->sim->fluid == NULL || h->sim->t < h->from) return;
    row[DROP] = history_pressure_drop(h->sim);
    h->drop += row[DROP];
    h->rows++;
    if (h->sim->particles != NULL) {
        h->weight += history_bed_weight(h->sim);
        row[LEAN] = add_bed(h);
        h->lean += row[LEAN];
    }
    block_means_add(h->blocks, row, once);
}

/* Where the end of the case has changed since it was saved, the means begin
 * anew. */
static void begin_anew(struct second_half *h)
{
    struct block_means *const blocks = block_means_create(N_BLOCKED);

    block_means_free(h->blocks);
    *h = (struct second_half){.sim = h->sim, .from = h->from, .blocks = blocks};
}

void second_half_state(struct second_half *h, struct state *s)
{
    double from = h->from;

    state_begin(s, "second_half");
    state_long(s, "rows", "-", &h->rows);
    state_real(s, "drop", "Pa", &h->drop);
    state_real(s, "weight", "Pa", &h->weight);
    state_real(s, "lean", "-", &h->lean);
    state_real(s, "speed", "m2/s2", &h->speed);
    state_real(s, "horizontal", "m2/s2", &h->horizontal);
    state_real(s, "vertical", "m2/s2", &h->vertical);
    block_means_state(h->blocks, s);
    state_real(s, "from", "s", &from);
    state_end(s);
    if (from != h->from) begin_anew(h);
}

int second_half_has_any(const struct second_half *h)
{
    return h->rows > 0;
}

double second_half_pressure_drop(const struct second_half *h)
{
    return h->drop / (double)h->rows;
}

double second_half_weight(const struct second_half *h)
{
    return h->weight / (double)h->rows;
}

void second_half_write(const struct second_half *h, struct summary *to)
{
    const double n = (double)h->rows;

    if (h->rows == 0) return;
    summary_begin(to, "second_half");
    summary_number(to, "mean_pressure_drop", second_half_pressure_drop(h));
    if (h->sim->particles != NULL)
        summary_number(to, "bed_weight", second_half_weight(h));
    summary_number(to, "mean_pressure_drop_error",
                   block_means_error(h->blocks, DROP));
    if (h->sim->particles != NULL) {
        summary_number(to, "particle_velocity_rms", sqrt(h->speed / n));
        summary_number(to, "horizontal_velocity_rms", sqrt(h->horizontal / n));
        summary_number(to, "vertical_velocity_rms", sqrt(h->vertical / n));
        summary_number(to, "lean", h->lean / n);
        summary_number(to, "lean_error", block_means_error(h->blocks, LEAN));
    }
    summary_end(to);
}
