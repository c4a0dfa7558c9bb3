/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "record/layers.h"

#include <math.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "base/number.h"

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

struct layers *layers_create(const struct mesh *m, int axis, int rows)
{
    struct layers *const l = alloc_zeroed(1, sizeof *l);

    l->n = m->face_centre == NULL ? m->box.n[axis]
                                  : number_clamped(cbrt(m->n_cells), 1, 1000);
    l->rows = rows;
    l->cells = m->n_cells;
    l->V = m->V;
    l->layer = alloc_ints(m->n_cells);
    l->height = alloc_doubles(l->n);
    l->volume = alloc_doubles(l->n);
    l->eps = alloc_doubles(l->n * rows);
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

void layers_free(struct layers *l)
{
    if (l == NULL) return;
    free(l->layer);
    free(l->height);
    free(l->volume);
    free(l->eps);
    free(l);
}

void layers_add(struct layers *l, const double *eps)
{
    double *const row = &l->eps[l->n * l->n_rows++];

    for (int c = 0; c < l->cells; c++)
        row[l->layer[c]] += eps[c] * l->V[c] / l->volume[l->layer[c]];
}

void layers_state(struct layers *l, struct state *s)
{
    state_count(s, "layer_rows", &l->n_rows, l->rows);
    state_reals(s, "layer_eps", "-", l->eps, l->n_rows, l->n);
}
