/* SPDX-License-Identifier: GPL-3.0-or-later */
/* surface_table.c -- forces and torques on the surfaces: DIR/surfaces.csv.
 *
 * It has a row with each row of history.csv: of each surface the force and the
 * torque, as means since the row before, and the work that it has done so far.
 */
#include "record/recorder_part.h"

#include <stdio.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "dem/surfaces/dem_surface.h"
#include "output/table.h"

enum { EACH = 7, NAME = 128 }; /* columns a surface; length of one's name */

struct surface_table {
    const struct simulation *sim;
    struct table *table;
    struct dem_surface *before; /* as they were in the row before */
    double t;                   /* [s] of that row; negative: there is none */
    double *row;
};

static struct table *surface_table_create_table(const struct simulation *sim,
                                                struct folder *folder)
{
    static const char *const what[EACH] = {
        "force_x [N]",    "force_y [N]",    "force_z [N]", "torque_x [N m]",
        "torque_y [N m]", "torque_z [N m]", "work [J]"};
    const int n = 1 + EACH * sim->n_surfaces;
    char(*const text)[NAME] = alloc_zeroed((size_t)n, sizeof *text);
    const char **const name = alloc_zeroed((size_t)n, sizeof *name);

    for (int c = 0; c < n; c++) {
        name[c] = text[c];
        if (c == 0)
            snprintf(text[c], NAME, "time [s]");
        else
            snprintf(text[c], NAME, "%s_%s", sim->surface_names[(c - 1) / EACH],
                     what[(c - 1) % EACH]);
    }
    struct table *const made = folder_table(folder, "surfaces.csv", n, name);
    free(text);
    free(name);
    return made;
}

static void surface_table_release(void *part)
{
    struct surface_table *const t = part;

    table_free(t->table);
    free(t->before);
    free(t->row);
    free(t);
}

static void *surface_table_create(const struct recorder_view *v, int *failed)
{
    if (v->sim->n_surfaces == 0) return NULL;
    struct surface_table *const t = alloc_zeroed(1, sizeof *t);

    t->sim = v->sim;
    t->t = -1.0;
    t->before = alloc_zeroed((size_t)v->sim->n_surfaces, sizeof *t->before);
    t->row = alloc_doubles(1 + EACH * v->sim->n_surfaces);
    t->table = surface_table_create_table(v->sim, v->folder);
    if (t->table != NULL) return t;
    *failed = 1;
    surface_table_release(t);
    return NULL;
}

/* The rows so far, and the sums at the last of them. */
static void surface_table_visit(void *part, struct state *s)
{
    struct surface_table *const t = part;
    struct dem_surface *const all = t->before;
    const int n = t->sim->n_surfaces;

    state_begin(s, "surface_table");
    table_state(t->table, s);
    state_real(s, "t", "s", &t->t);
    state_reals_of(s, "impulse", "N s", all->impulse, sizeof *all, n, 3);
    state_reals_of(s, "angular", "N m s", all->angular, sizeof *all, n, 3);
    state_end(s);
}

static int surface_table_add_row(void *part)
{
    struct surface_table *const t = part;
    const double passed = t->t >= 0.0 ? t->sim->t - t->t : 0.0;
    const double per = passed > 0.0 ? 1.0 / passed : 0.0;

    t->row[0] = t->t = t->sim->t;
    for (int s = 0; s < t->sim->n_surfaces; s++) {
        const struct dem_surface now = dem_surface(t->sim->dem, s);
        const struct dem_surface *const old = &t->before[s];
        double *const row = &t->row[1 + EACH * s];
        for (int k = 0; k < 3; k++) {
            row[k] = per * (now.impulse[k] - old->impulse[k]);
            row[3 + k] = per * (now.angular[k] - old->angular[k]);
        }
        row[6] = now.work;
        t->before[s] = now;
    }
    return table_add(t->table, t->row);
}

const struct recorder_part surface_table_part = {.create = surface_table_create,
                                                 .free = surface_table_release,
                                                 .row = surface_table_add_row,
                                                 .last_row =
                                                     surface_table_add_row,
                                                 .state = surface_table_visit};
