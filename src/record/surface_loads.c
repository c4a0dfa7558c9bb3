/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "record/surface_loads.h"

#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/vector.h"
#include "dem/surfaces/dem_surface.h"

struct surface_loads {
    const struct simulation *sim;
    const double *centre; /* [m] */
    int n;
    int *number;                /* [-] of each surface */
    struct dem_surface *before; /* as it was in the row before */
    double t;                   /* [s] of that row; negative: there is none */
};

const char *const surface_loads_columns[SURFACE_LOADS_EACH] = {
    "contact_x [N]",          "contact_y [N]",
    "contact_z [N]",          "contact_torque_x [N m]",
    "contact_torque_y [N m]", "contact_torque_z [N m]"};

int surface_loads_has_word(const char *text, const char *word)
{
    const size_t length = strlen(word);

    if (strcmp(text, word) == 0) return 1; /* it may have blanks itself */
    for (const char *at = text; *(at += strspn(at, " ")) != '\0';
         at += strcspn(at, " "))
        if (strcspn(at, " ") == length && strncmp(at, word, length) == 0)
            return 1;
    return 0;
}

struct surface_loads *surface_loads_create(const struct simulation *sim,
                                           const char *names,
                                           const double centre[3])
{
    if (names == NULL) return NULL;
    struct surface_loads *const l = alloc_zeroed(1, sizeof *l);

    l->sim = sim;
    l->centre = centre;
    l->t = -1.0;
    l->number = alloc_ints(sim->n_surfaces);
    l->before = alloc_zeroed((size_t)sim->n_surfaces, sizeof *l->before);
    for (int k = 0; k < sim->n_surfaces; k++)
        if (surface_loads_has_word(names, sim->surface_names[k]))
            l->number[l->n++] = k;
    return l;
}

void surface_loads_free(struct surface_loads *l)
{
    if (l == NULL) return;
    free(l->number);
    free(l->before);
    free(l);
}

/* Adds impulse [N s] and angular impulse [N m s] between two moments. */
static void add_between(const struct dem_surface *a,
                        const struct dem_surface *b, const double centre[3],
                        double *sum)
{
    double impulse[3], angular[3], from[3], to[3], arm[3], turned[3];

    vector_between(b->impulse, a->impulse, impulse);
    vector_between(b->angular, a->angular, angular);
    vector_between(a->pose.centre, centre, from);
    vector_between(b->pose.centre, centre, to);
    for (int k = 0; k < 3; k++)
        arm[k] = 0.5 * (from[k] + to[k]);
    vector_cross(arm, impulse, turned);
    for (int k = 0; k < 3; k++) {
        sum[k] += impulse[k];
        sum[3 + k] += angular[k] + turned[k];
    }
}

void surface_loads_row(struct surface_loads *l, double *row)
{
    const double passed = l->t >= 0.0 ? l->sim->t - l->t : 0.0;

    memset(row, 0, SURFACE_LOADS_EACH * sizeof *row);
    for (int k = 0; k < l->n; k++) {
        const struct dem_surface now = dem_surface(l->sim->dem, l->number[k]);
        if (passed > 0.0) add_between(&l->before[k], &now, l->centre, row);
        l->before[k] = now;
    }
    for (int k = 0; k < SURFACE_LOADS_EACH && passed > 0.0; k++)
        row[k] /= passed;
    l->t = l->sim->t;
}

void surface_loads_state(struct surface_loads *l, int number, struct state *s)
{
    struct dem_surface *const all = l->before;

    state_begin_number(s, "surface_loads", number);
    state_real(s, "t", "s", &l->t);
    state_reals_of(s, "impulse", "N s", all->impulse, sizeof *all, l->n, 3);
    state_reals_of(s, "angular", "N m s", all->angular, sizeof *all, l->n, 3);
    state_reals_of(s, "centre", "m", all->pose.centre, sizeof *all, l->n, 3);
    state_end(s);
}
