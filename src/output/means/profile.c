/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/means/means.h"

#include <assert.h>
#include <math.h>
#include <stddef.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "base/number.h"
#include "base/vector.h"
#include "output/table.h"

/* --- probe ---------------------------------------------------------------- */

/* Of the cells of a box along direction k the middle of row i. */
static double probe_middle(const struct box *b, int k, int i)
{
    return 0.5 * (b->edge[k][i] + b->edge[k][i + 1]);
}

/* The row whose middle is below x, or the first, with the weight of the row
 * above it. */
static int probe_row(const struct box *b, int k, double x, double *upper)
{
    int i = 0;

    while (i < b->n[k] - 1 && probe_middle(b, k, i + 1) <= x)
        i++;
    *upper = 0.0;
    if (i < b->n[k] - 1 && x > probe_middle(b, k, i))
        *upper = (x - probe_middle(b, k, i)) /
                 (probe_middle(b, k, i + 1) - probe_middle(b, k, i));
    return i;
}

static struct probe in_box(const struct mesh *m, const double x[3])
{
    const struct box *const b = &m->box;
    const int stride[3] = {1, b->n[0], b->n[0] * b->n[1]};
    struct probe p = {.n = 8, .weighted = 8};
    double upper[3];
    int first = 0;

    for (int k = 0; k < 3; k++)
        first += stride[k] * probe_row(b, k, x[k], &upper[k]);
    for (int corner = 0; corner < 8; corner++) {
        p.cell[corner] = first;
        p.share[corner] = 1.0;
        for (int k = 0; k < 3; k++) {
            const int high = corner >> k & 1;
            p.share[corner] *= high ? upper[k] : 1.0 - upper[k];
            /* without a row above, that weight is 0 */
            if (high && upper[k] > 0.0) p.cell[corner] += stride[k];
        }
    }
    return p;
}

/* The neighbours of cell c and the links to them, at most as many as a probe
 * can hold besides the cell itself. */
static int links_of(const struct mesh *m, int c, int *cell, double (*link)[3])
{
    int n = 0;

    for (int a = m->cell_start[c]; a < m->cell_start[c + 1]; a++) {
        const int f = m->cell_face[a], owns = m->out[a] > 0.0;
        if (f >= m->n_internal || n == PROBE_CELLS - 1) break;
        cell[n] = owns ? m->neighbour[f] : m->owner[f];
        for (int k = 0; k < 3; k++)
            link[n][k] = m->out[a] * mesh_d(m, f)[k];
        n++;
    }
    return n;
}

/* The least-squares gradient g satisfies A g = sum of d (f_n - f_c) / d^2. With
 * y from A y = o, where o leads from the centre to the point, the weight of
 * neighbour n is therefore y . d / d^2, and that of the cell is 1 minus the sum
 * of these. */
static struct probe in_mesh(const struct mesh *m, const double x[3])
{
    struct probe p = {.n = 0};
    double link[PROBE_CELLS - 1][3], A[6] = {0.0}, o[3], y[3];
    const int c = mesh_cell_and_offset(m, x, o);

    if (c < 0) return p;
    const int n = links_of(m, c, &p.cell[1], link);
    for (int i = 0; i < n; i++) {
        const double *const d = link[i], w = 1.0 / vector_dot(d, d);
        const double dd[6] = {d[0] * d[0], d[0] * d[1], d[0] * d[2],
                              d[1] * d[1], d[1] * d[2], d[2] * d[2]};
        for (int j = 0; j < 6; j++)
            A[j] += w * dd[j];
    }
    vector_solve(A, o, y);
    p.n = n + 1;
    p.weighted = 1;
    p.cell[0] = c;
    p.share[0] = 1.0;
    for (int i = 0; i < n; i++) {
        p.share[1 + i] = vector_dot(y, link[i]) / vector_dot(link[i], link[i]);
        p.share[0] -= p.share[1 + i];
    }
    return p;
}

struct probe probe_at(const struct mesh *m, const double x[3])
{
    return m->face_centre == NULL ? in_box(m, x) : in_mesh(m, x);
}

/* The value of a field before the division by the sum of the weights, which is
 * added to *whole. */
static double probe_amount(const struct probe *p, const double *values,
                           int components, int component, const double *weight,
                           double *whole)
{
    const int n = weight != NULL ? p->weighted : p->n;
    double amount = 0.0;

    for (int i = 0; i < n; i++) {
        const int c = p->cell[i];
        const double share = n == 1 ? 1.0 : p->share[i];
        const double w = share * (weight != NULL ? weight[c] : 1.0);
        amount += w * values[components * c + component];
        *whole += w;
    }
    return amount;
}

double probe_value(const struct probe *p, const double *values, int components,
                   int component, const double *weight)
{
    double whole = 0.0;
    const double amount =
        probe_amount(p, values, components, component, weight, &whole);

    return whole > 0.0 ? amount / whole : 0.0;
}

/* --- profile -------------------------------------------------------------- */

enum { MOST_POINTS = 20000 }; /* of a line, along it and across */

struct profile {
    struct profile_line line;
    struct profile_field field;
    int n;           /* [-] points on the line */
    double *x;       /* [m] of each point, ascending */
    double ends;     /* [m] sum of the two ends of the line */
    int row[2];      /* [-] rows of cells on both sides of the line */
    double share[2]; /* [-] weight of each */
    int n_deep;      /* [-] cells in the depth */
    double *dz;      /* [-] width of each over the whole depth */
    int step[3]; /* [-] from a cell to the next along, across and in depth */
    struct probe *probe;              /* n times n_deep, of a polyhedral mesh */
    double *sample, *weight, *amount; /* amount: weight times dt */
    struct mean *mean;
    struct mean_blocks *blocks;
};

static void lay_out(struct profile *p, const struct box *b)
{
    const int a = p->line.along, deep = 3 - a - p->line.across;
    const int stride[3] = {1, b->n[0], b->n[0] * b->n[1]};
    const double *const z = b->edge[deep];

    p->step[0] = stride[a];
    p->step[1] = stride[p->line.across];
    p->step[2] = stride[deep];
    p->n = b->n[a];
    p->x = owner_doubles(p, p->n);
    for (int i = 0; i < p->n; i++)
        p->x[i] = probe_middle(b, a, i);
    p->n_deep = b->n[deep];
    p->dz = owner_doubles(p, p->n_deep);
    for (int i = 0; i < p->n_deep; i++)
        p->dz[i] = (z[i + 1] - z[i]) / (z[p->n_deep] - z[0]);
    p->row[0] = probe_row(b, p->line.across, p->line.at, &p->share[1]);
    p->row[1] = p->row[0] + (p->share[1] > 0.0);
    p->share[0] = 1.0 - p->share[1];
}

/* Points half a mean cell apart, from one end of the mesh to the other. */
static double points_along(const struct mesh *m, int k, int *n)
{
    const double L = m->hi[k] - m->lo[k];
    double volume = 0.0;

    for (int c = 0; c < m->n_cells; c++)
        volume += m->V[c];
    *n = number_clamped(ceil(2.0 * L / cbrt(volume / m->n_cells)), 1,
                        MOST_POINTS);
    return L / *n;
}

static void create_probes(struct profile *p, const struct mesh *m)
{
    const int a = p->line.along, deep = 3 - a - p->line.across;
    const double dx = points_along(m, a, &p->n);
    const double dz = points_along(m, deep, &p->n_deep);

    p->x = owner_doubles(p, p->n);
    p->probe =
        owner_zeroed(p, (size_t)p->n * (size_t)p->n_deep, sizeof *p->probe);
    for (int i = 0; i < p->n; i++) {
        double x[3];
        x[a] = p->x[i] = m->lo[a] + (i + 0.5) * dx;
        x[p->line.across] = p->line.at;
        for (int j = 0; j < p->n_deep; j++) {
            x[deep] = m->lo[deep] + (j + 0.5) * dz;
            p->probe[i * p->n_deep + j] = probe_at(m, x);
        }
    }
}

struct profile *profile_create(const struct mesh *m,
                               const struct profile_line *line,
                               const struct profile_field *field)
{
    struct profile *const p = owner_create(sizeof *p);

    assert(line->along != line->across);
    p->line = *line;
    if (m->face_centre == NULL)
        lay_out(p, &m->box);
    else
        create_probes(p, m);
    p->field = *field;
    p->sample = owner_doubles(p, p->n);
    p->weight = owner_doubles(p, p->n);
    p->amount = owner_doubles(p, p->n);
    p->mean = mean_create(p->n);
    p->blocks = mean_blocks_create(p->n);
    p->ends = m->lo[line->along] + m->hi[line->along];
    return p;
}

void profile_free(struct profile *p)
{
    if (p == NULL) return;
    owner_free(p->mean);
    owner_free(p->blocks);
    owner_free(p);
}

/* The same with probes; the weight is 0 where all of them are outside. */
static double seen(const struct profile *p, int i, double *weight)
{
    const struct profile_field *const f = &p->field;
    double amount = 0.0;

    for (int j = 0; j < p->n_deep; j++)
        amount += probe_amount(&p->probe[i * p->n_deep + j], f->values,
                               f->components, f->component, f->weight, weight);
    *weight = fmax(*weight, 0.0);
    amount = *weight > 0.0 ? amount / *weight : 0.0;
    *weight /= p->n_deep;
    return amount;
}

/* The sample at point i of the line, and its weight. Where a scheme of
 * diffusion overshoots there are fewer grains than none, and their velocity has
 * no weight. */
static double profile_sampled(const struct profile *p, int i, double *weight)
{
    const struct profile_field *const f = &p->field;
    double amount = 0.0;

    *weight = 0.0;
    if (p->probe != NULL) return seen(p, i, weight);
    for (int r = 0; r < 2; r++)
        for (int k = 0; k < p->n_deep; k++) {
            const int c =
                i * p->step[0] + p->row[r] * p->step[1] + k * p->step[2];
            const double w =
                p->share[r] * p->dz[k] * (f->weight ? f->weight[c] : 1.0);

            amount += w * f->values[f->components * c + f->component];
            *weight += w;
        }
    *weight = fmax(*weight, 0.0);
    return *weight > 0.0 ? amount / *weight : 0.0;
}

void profile_add(struct profile *p, double time, double dt)
{
    if (time + 1e-9 * fabs(time) < p->line.from) /* a rounded sum of steps */
        return;
    for (int i = 0; i < p->n; i++) {
        p->sample[i] = profile_sampled(p, i, &p->weight[i]);
        p->amount[i] = dt * p->weight[i];
    }
    mean_add(p->mean, dt, p->sample, p->weight);
    mean_blocks_add(p->blocks, p->sample, p->amount);
}

/* The mean at a place, linear between the points of the line. */
static double mean_at(const struct profile *p, double x)
{
    const double *const y = p->mean->value;
    int i = 0;

    while (i < p->n - 1 && p->x[i + 1] < x)
        i++;
    if (i == p->n - 1 || x <= p->x[i]) return y[i];
    return y[i] + (x - p->x[i]) / (p->x[i + 1] - p->x[i]) * (y[i + 1] - y[i]);
}

double profile_mirror_error(const struct profile *p)
{
    const struct profile_field *const is = &p->field;
    const int turns = is->components == 3 && is->component == p->line.along;
    double sum = 0.0;

    for (int i = 0; i < p->n; i++) {
        const double image = mean_at(p, p->ends - p->x[i]);
        const double half =
            0.5 * (p->mean->value[i] - (turns ? -image : image));
        sum += half * half;
    }
    return sqrt(sum / p->n);
}

double profile_block_error(const struct profile *p)
{
    double sum = 0.0;

    for (int i = 0; i < p->n; i++) {
        const double error = mean_blocks_error(p->blocks, i);
        sum += error * error;
    }
    return sqrt(sum / p->n);
}

void profile_state(struct profile *p, struct state *s)
{
    mean_state(p->mean, s);
    mean_blocks_state(p->blocks, s);
}

int profile_write(const struct profile *p, const char *path)
{
    const char *const name = p->field.name, *const unit = p->field.unit;
    double(*const row)[4] = alloc_zeroed((size_t)p->n, sizeof *row);
    struct table_head head = {0};

    table_head_add(&head, "%c [m]", "xyz"[p->line.along]);
    table_head_add(&head, "%s_mean [%s]", name, unit);
    table_head_add(&head, "%s_std [%s]", name, unit);
    table_head_add(&head, "%s_error [%s]", name, unit);
    for (int i = 0; i < p->n; i++) {
        row[i][0] = p->x[i];
        row[i][1] = p->mean->value[i];
        row[i][2] = mean_spread(p->mean, i);
        row[i][3] = mean_blocks_error(p->blocks, i);
    }
    const int failed =
        table_write(path, head.n, (const char *const *)head.name, p->n, row[0]);
    table_head_clear(&head);
    free(row);
    return failed;
}
