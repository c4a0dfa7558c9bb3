/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "distributed/ranks/arrays.h"

#include <assert.h>
#include <stdio.h>
#include <string.h>

static int list(void *store, const struct state_array *array)
{
    struct arrays *const a = store;

    assert(a->n < ARRAYS_MOST);
    snprintf(a->name[a->n], ARRAYS_NAME, "%s", strrchr(array->path, '/') + 1);
    a->at[a->n++] = *array;
    return 0;
}

int arrays_named(const char *name, const char *words)
{
    const size_t n = strlen(name);

    for (const char *w = words; (w = strstr(w, name)) != NULL; w++)
        if ((w == words || w[-1] == ' ') && (w[n] == ' ' || w[n] == '\0'))
            return 1;
    return 0;
}

/* As if there were one: arrays of no rows are passed over. */
void arrays_of_particles(struct particles *ps, struct arrays *a)
{
    struct state s = {.visit = list, .store = a};
    const int n = ps->n;

    a->n = 0;
    ps->n = 1;
    particles_state(ps, &s);
    ps->n = n;
}

void arrays_of_fluid(struct fluid *fl, struct arrays *a)
{
    struct state s = {.visit = list, .store = a};

    a->n = 0;
    fluid_state(fl, &s);
}
