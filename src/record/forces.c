/* SPDX-License-Identifier: GPL-3.0-or-later */
/* forces.c -- forces and torques of the fluid on patches, and of the grains on
 * surfaces: DIR/forces.csv.
 *
 * A row with each row of history.csv. The coefficients of a body are
 *
 *   C = F / (1/2 rho U^2 A),   C_m = M / (1/2 rho U^2 A L)
 *
 * with the reference values U, A and L of the case; F and M are the parts of
 * force and torque along the directions of drag, lift and moment.
 */
#include "record/recorder_part.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/vector.h"
#include "dem/surfaces/surfaces.h"
#include "fluid/systems.h"
#include "mesh/measures.h"
#include "output/table.h"

enum { EACH = 15, SURFACE_LOADS_EACH = 6 };

/* 1 if the word is one of those of a text. */
static int has_word(const char *text, const char *word)
{
    const size_t length = strlen(word);

    if (strcmp(text, word) == 0) return 1; /* it may have blanks itself */
    for (const char *at = text; *(at += strspn(at, " ")) != '\0';
         at += strcspn(at, " "))
        if (strcspn(at, " ") == length && strncmp(at, word, length) == 0)
            return 1;
    return 0;
}

/* --- grains on surfaces --------------------------------------------------- */

/* What the grains do to some surfaces. Chapter "Averaged flow".
 *
 * Force and torque are means since the row before, the torque about the point
 * of the body: that about the centre of a surface's motion, and the arm from
 * the point to where that centre was in the middle of the time, times the
 * force. */
struct surface_loads {
    const struct simulation *sim;
    const double *centre; /* [m] */
    int n;
    int *number;                /* [-] of each surface */
    struct dem_surface *before; /* as it was in the row before */
    double t;                   /* [s] of that row; negative: there is none */
};

static const char *const surface_loads_columns[SURFACE_LOADS_EACH] = {
    "contact_x [N]",          "contact_y [N]",
    "contact_z [N]",          "contact_torque_x [N m]",
    "contact_torque_y [N m]", "contact_torque_z [N m]"};

/* Those whose names stand in `names`, with blanks between; NULL if that is.
 * `centre` [m] is borrowed. */
static struct surface_loads *surface_loads_create(const struct simulation *sim,
                                                  const char *names,
                                                  const double centre[3])
{
    if (names == NULL) return NULL;
    struct surface_loads *const l = owner_create(sizeof *l);

    l->sim = sim;
    l->centre = centre;
    l->t = -1.0;
    l->number = owner_ints(l, sim->n_surfaces);
    l->before = owner_zeroed(l, (size_t)sim->n_surfaces, sizeof *l->before);
    for (int k = 0; k < sim->n_surfaces; k++)
        if (has_word(names, sim->surface_names[k])) l->number[l->n++] = k;
    return l;
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

static void surface_loads_row(struct surface_loads *l, double *row)
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

static void surface_loads_state(struct surface_loads *l, int number,
                                struct state *s)
{
    struct dem_surface *const all = l->before;

    state_begin_number(s, "surface_loads", number);
    state_real(s, "t", "s", &l->t);
    state_reals_of(s, "impulse", "N s", all->impulse, sizeof *all, l->n, 3);
    state_reals_of(s, "angular", "N m s", all->angular, sizeof *all, l->n, 3);
    state_reals_of(s, "centre", "m", all->pose.centre, sizeof *all, l->n, 3);
    state_end(s);
}

/* A body: some patches that are walls, some surfaces, and its reference
 * values. */
struct body {
    char name[PROFILES_NAME];
    int *on;                          /* [-] 1 for each of its patches; NULL:
                                         none */
    struct surface_loads *surfaces;   /* NULL: none */
    double centre[3];                 /* [m] of the torque */
    double drag[3], lift[3], axis[3]; /* [-] of length 1 */
    double per_force, per_torque;     /* [1/N], [1/(N m)]; 0: no coefficients */
};

struct forces {
    const struct simulation *sim;
    int n, n_columns;
    struct body *body;
    struct table *table;
    double *row;
};

/* --- one body ------------------------------------------------------------- */

struct load {
    double pressure[3], viscous[3], torque[3]; /* [N], [N m] */
    double shear;                              /* [Pa] the largest */
    double y_plus, area;                       /* [-] the largest; [m^2] */
};

static void forces_add_face(struct load *l, const struct fluid *fl, int patch,
                            int j, const double centre[3])
{
    const struct wall_stress w = wall_stress(fl, patch, j);
    double x[3], arm[3], force[3], torque[3];

    mesh_face_middle(fl->mesh, fl->mesh->patches[patch].first + j, x);
    vector_between(x, centre, arm);
    vector_along(w.pressure, 1.0, w.viscous, force);
    vector_cross(arm, force, torque);
    for (int k = 0; k < 3; k++) {
        l->pressure[k] += w.pressure[k];
        l->viscous[k] += w.viscous[k];
        l->torque[k] += torque[k];
    }
    l->shear = fmax(l->shear, vector_length(w.shear));
    l->y_plus = fmax(l->y_plus, w.y_plus);
}

static struct load load_on(const struct body *b, const struct fluid *fl)
{
    struct load l = {.shear = 0.0};

    for (int i = 0; i < fl->mesh->n_patches; i++)
        for (int j = 0; j < fl->mesh->patches[i].n && b->on[i]; j++)
            forces_add_face(&l, fl, i, j, b->centre);
    return l;
}

void recorder_forces_name(const struct output_force *o,
                          char name[PROFILES_NAME])
{
    snprintf(name, PROFILES_NAME, "%s",
             o->name != NULL       ? o->name
             : o->patches != NULL  ? o->patches
             : o->surfaces != NULL ? o->surfaces
                                   : "walls");
}

/* --- what the case says --------------------------------------------------- */

/* All walls, if neither patches nor surfaces are named. */
static void mark_patches(const struct fluid *fl, const char *patches,
                         struct body *b)
{
    b->on = alloc_ints(fl->mesh->n_patches);
    for (int p = 0; p < fl->mesh->n_patches; p++)
        b->on[p] = patches == NULL
                       ? fl->options.boundaries[p].kind == BOUNDARY_NO_SLIP
                       : has_word(patches, fl->mesh->patches[p].name);
}

static void create_body(const struct output_force *o,
                        const struct simulation *sim, struct body *b)
{
    const struct fluid *const fl = sim->fluid;

    recorder_forces_name(o, b->name);
    memcpy(b->centre, o->centre, sizeof b->centre);
    b->surfaces = surface_loads_create(sim, o->surfaces, b->centre);
    if (o->patches == NULL && o->surfaces != NULL) return;
    mark_patches(fl, o->patches, b);
    vector_unit(o->drag, b->drag);
    vector_unit(o->lift, b->lift);
    vector_unit(o->axis, b->axis);
    const double force =
        0.5 * fl->options.rho * o->velocity * o->velocity * o->area;
    b->per_force = force > 0.0 ? 1.0 / force : 0.0;
    b->per_torque = force * o->length > 0.0 ? 1.0 / (force * o->length) : 0.0;
}

/* --- the table ------------------------------------------------------------ */

static const char *const columns[EACH] = {
    "pressure_x [N]",       "pressure_y [N]",        "pressure_z [N]",
    "viscous_x [N]",        "viscous_y [N]",         "viscous_z [N]",
    "torque_x [N m]",       "torque_y [N m]",        "torque_z [N m]",
    "largest_shear [Pa]",   "largest_y_plus [-]",    "drag_coefficient [-]",
    "lift_coefficient [-]", "moment_coefficient [-]"};

static int columns_of_fluid(const struct body *b)
{
    return b->on == NULL         ? 0
           : b->per_torque > 0.0 ? 14
           : b->per_force > 0.0  ? 13
                                 : 11;
}

static int columns_of(const struct body *b)
{
    return columns_of_fluid(b) + (b->surfaces != NULL ? SURFACE_LOADS_EACH : 0);
}

static const char *column_of(const struct body *b, int k)
{
    const int n = columns_of_fluid(b);
    return k < n ? columns[k] : surface_loads_columns[k - n];
}

static void fill_fluid(const struct body *b, const struct fluid *fl,
                       double row[EACH])
{
    const struct load l = load_on(b, fl);
    double force[3];

    memcpy(row, l.pressure, sizeof l.pressure);
    memcpy(row + 3, l.viscous, sizeof l.viscous);
    memcpy(row + 6, l.torque, sizeof l.torque);
    vector_along(l.pressure, 1.0, l.viscous, force);
    row[9] = l.shear;
    row[10] = l.y_plus;
    row[11] = b->per_force * vector_dot(force, b->drag);
    row[12] = b->per_force * vector_dot(force, b->lift);
    row[13] = b->per_torque * vector_dot(l.torque, b->axis);
}

static int forces_add_row(void *memory)
{
    struct forces *const f = memory;
    double *at = f->row;

    *at++ = f->sim->t;
    for (int i = 0; i < f->n; i++) {
        const struct body *const b = &f->body[i];
        const int n = columns_of_fluid(b);
        double row[EACH];
        if (n > 0) fill_fluid(b, f->sim->fluid, row);
        memcpy(at, row, (size_t)n * sizeof *row);
        if (b->surfaces != NULL) surface_loads_row(b->surfaces, at + n);
        at += columns_of(b);
    }
    return table_add(f->table, f->row);
}

static struct table *forces_create_table(const struct forces *f,
                                         struct folder *folder)
{
    struct table_head head = {0};

    table_head_add(&head, "time [s]");
    for (int i = 0; i < f->n; i++)
        for (int k = 0; k < columns_of(&f->body[i]); k++)
            table_head_add(&head, "%s_%s", f->body[i].name,
                           column_of(&f->body[i], k));
    return folder_table(folder, "forces.csv", &head);
}

static void forces_release(void *memory)
{
    struct forces *const f = memory;

    for (int i = 0; i < f->n; i++) {
        free(f->body[i].on);
        owner_free(f->body[i].surfaces);
    }
    table_free(f->table);
    owner_free(f);
}

static void *forces_create(const struct recorder_view *v, int *failed)
{
    if (v->of->output->forces.n == 0) return NULL;
    struct forces *const f = owner_create(sizeof *f);

    f->sim = v->sim;
    f->n = v->of->output->forces.n;
    f->n_columns = 1;
    f->body = owner_zeroed(f, (size_t)f->n, sizeof *f->body);
    for (int i = 0; i < f->n; i++) {
        create_body(&v->of->output->forces.item[i], v->sim, &f->body[i]);
        f->n_columns += columns_of(&f->body[i]);
    }
    f->row = owner_doubles(f, f->n_columns);
    f->table = forces_create_table(f, v->folder);
    *failed = f->table == NULL;
    return f;
}

static void forces_visit(void *part, struct state *s)
{
    struct forces *const f = part;

    state_begin(s, "forces");
    table_state(f->table, s);
    for (int i = 0; i < f->n; i++)
        if (f->body[i].surfaces != NULL)
            surface_loads_state(f->body[i].surfaces, i, s);
    state_end(s);
}

const struct recorder_part recorder_forces = {
    .create = forces_create,
    .row = forces_add_row,
    .last_row = forces_add_row,
    .free = forces_release,
    .state = forces_visit,
};
