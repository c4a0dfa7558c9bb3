/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "averaging/more/stored_weights.h"

#include <stdlib.h>

#include "base/alloc.h"

struct stored_weights stored_weights_of(int capacity)
{
    return (struct stored_weights){.start = alloc_ints(capacity + 1)};
}

void stored_weights_release(struct stored_weights *k)
{
    free(k->start);
    free(k->index_offset);
    free(k->w);
}

/* Makes room for n more weights after the first `used`. */
static void stored_weights_make_room(struct stored_weights *k, int used, int n)
{
    if (used + n <= k->capacity) return;
    k->capacity = 2 * (used + n);
    k->index_offset =
        alloc_grown(k->index_offset, used, k->capacity, sizeof(int));
    k->w = alloc_grown(k->w, used, k->capacity, sizeof(double));
}

/* Appends the weights that are not 0 after the first `used`, and returns how
 * many there are then. */
static int stored_weights_append(struct stored_weights *k, int used, int n,
                                 const int *index_offset, const double *w)
{
    stored_weights_make_room(k, used, n);
    for (int e = 0; e < n; e++) {
        if (w[e] == 0.0) continue;
        k->index_offset[used] = index_offset[e];
        k->w[used++] = w[e];
    }
    return used;
}

void stored_weights_fill(struct stored_weights *k,
                         const struct cell_of_particle *h,
                         const struct weights *weights,
                         const struct weights_rule *rule)
{
    double *const w = alloc_doubles(weights_stencil(weights)->largest);
    int used = 0;

    k->unsupported = 0;
    for (int c = 0; c < h->mesh->n_cells; c++) {
        const struct neighbourhood near = weights_around(weights, c);
        for (int a = h->start[c]; a < h->start[c + 1]; a++) {
            int n = near.n;
            if (!rule->weigh(rule->state, h->particle[a], &near, w)) {
                w[0] = n = 1;
                k->unsupported++;
            }
            k->start[a] = used;
            used = stored_weights_append(k, used, n, near.index_offset, w);
        }
    }
    k->start[h->n] = used;
    free(w);
}

struct weight_list stored_weights_list(const struct stored_weights *k, int a)
{
    const int first = k->start[a];
    return (struct weight_list){k->start[a + 1] - first,
                                &k->index_offset[first], &k->w[first]};
}
