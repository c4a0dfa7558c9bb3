/* SPDX-License-Identifier: GPL-3.0-or-later */
/* bubbles.c -- number, size and frequency of the bubbles of a bed, in
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
 * two rows of the history.
 */
#include <gsl/gsl_math.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/state.h"
#include "coupling/effect.h"
#include "coupling/effect_columns.h"
#include "coupling/simulation.h"

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
    struct bubbles *const b = alloc_zeroed(1, sizeof *b);
    const int n = sim->mesh->n_cells;

    b->threshold = parameters[0];
    b->height = parameters[1];
    b->depth = sim->mesh->hi[2] - sim->mesh->lo[2];
    b->smallest = M_PI / 4.0 * parameters[2] * parameters[2] * b->depth;
    b->root = alloc_ints(n);
    b->volume = alloc_doubles(n);
    b->open = alloc_zeroed((size_t)n, 1);
    b->passing = alloc_zeroed((size_t)n, 1);
    return b;
}

static void bubbles_free(void *memory)
{
    struct bubbles *const b = memory;

    if (b == NULL) return;
    free(b->root);
    free(b->volume);
    free(b->open);
    free(b->passing);
    free(b);
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

static const char *const names[] = {"bubbles [-]", "bubble_volume [m3]",
                                    "largest_bubble [m]", "bubbles_passed [-]",
                                    NULL};

static const struct effect_columns columns = {names, bubbles_row};

static const struct key keys[] = {
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
    {0}};

extern const struct effect bubbles_effect;
const struct effect bubbles_effect = {
    .name = "bubbles",
    .what = "bubbles of a bed, counted and measured",
    .equations = "",
    .function = "bubbles_row",
    .keys = {keys},
    .create = bubbles_create,
    .columns = &columns,
    .state = bubbles_state,
    .free = bubbles_free,
};
