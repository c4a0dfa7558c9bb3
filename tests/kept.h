/* kept.h -- a state in memory, for tests of what a visit saves and loads. */
#ifndef TESTS_KEPT_H
#define TESTS_KEPT_H

#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/state.h"

enum { KEPT_MOST = 4096 };

struct kept {
    struct state state;
    int n;
    struct {
        char *path;
        void *bytes;
        size_t size;
    } array[KEPT_MOST];
};

static inline int kept_visit(void *store, const struct state_array *a)
{
    struct kept *const k = store;
    const size_t one = a->type == STATE_REAL    ? sizeof(double)
                       : a->type == STATE_WHOLE ? sizeof(int)
                                                : sizeof(long);
    const size_t size = one * (size_t)a->rows * (size_t)a->width;

    for (int i = 0; i < k->n; i++) {
        if (strcmp(k->array[i].path, a->path) != 0) continue;
        if (!k->state.loading || k->array[i].size != size) return 1;
        memcpy(a->values, k->array[i].bytes, size);
        return 0;
    }
    if (k->state.loading || k->n == KEPT_MOST) return 1;
    k->array[k->n].path = strdup(a->path);
    k->array[k->n].size = size;
    k->array[k->n].bytes = memcpy(alloc_zeroed(size, 1), a->values, size);
    k->n++;
    return 0;
}

/* An empty one, to save to. */
static inline struct kept *kept_create(void)
{
    struct kept *const k = alloc_zeroed(1, sizeof *k);

    k->state.visit = kept_visit;
    k->state.store = k;
    return k;
}

/* The same, to be loaded from. */
static inline struct state *kept_load(struct kept *k)
{
    k->state.loading = 1;
    return &k->state;
}

static inline void kept_free(struct kept *k)
{
    for (int i = 0; i < k->n; i++) {
        free(k->array[i].path);
        free(k->array[i].bytes);
    }
    free(k);
}

#endif
