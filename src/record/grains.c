/* SPDX-License-Identifier: GPL-3.0-or-later */
/* grains.c -- what a case may have written of the particles besides place,
 * velocity, spin and size: further arrays of particles.pvd, and their contacts
 * as lines between centres, contacts.pvd. */
#include "record/recorder_part.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/vector.h"
#include "dem/box_domain.h"
#include "dem/materials.h"
#include "dem/surfaces/surfaces.h"
#include "dem/surfaces/surface_contacts.h"
#include "output/series.h"

/* The contacts of a moment, found anew. */
struct contact_list {
    const struct simulation *sim; /* borrowed */
    struct box_domain box;
    struct contact_constants *constants; /* of each pair of materials */
    struct link_cells *cells;
    struct rows *rows; /* the particles once more, where there are surfaces;
                            else this is NULL */
    struct pose *pose; /* of each surface */
    struct near_faces near;
    struct surface_contact_points points;
    int n, room;             /* [-] contacts */
    double *x;               /* [m] the two ends of each, 6 */
    double *force, *depth;   /* [N] elastic, [m] */
    int *ids, *corner, *end; /* [-] 2, 2 and 1 each */
    int *index;              /* [-] of both particles, 2 each; or below 0 */
};

static void contact_list_reserve(struct contact_list *c)
{
    if (c->n < c->room) return;
    const int n = c->n, room = c->room = 2 * c->room + 1024;
    c->x = alloc_grown(c->x, 6 * n, 6 * room, sizeof *c->x);
    c->force = alloc_grown(c->force, n, room, sizeof *c->force);
    c->depth = alloc_grown(c->depth, n, room, sizeof *c->depth);
    c->ids = alloc_grown(c->ids, 2 * n, 2 * room, sizeof *c->ids);
    c->corner = alloc_grown(c->corner, 2 * n, 2 * room, sizeof *c->corner);
    c->end = alloc_grown(c->end, n, room, sizeof *c->end);
    c->index = alloc_grown(c->index, 2 * n, 2 * room, sizeof *c->index);
}

/* Of particle i with another, or with a wall that has a number below 0. */
struct meeting {
    int i, j;           /* [-] */
    int pair;           /* [-] of materials */
    double d[3];        /* [m] from the centre to the other, or to the wall */
    double depth, R, m; /* [m], R* [m], m* [kg] */
};

static void contact_list_add(struct contact_list *c, const struct meeting *a)
{
    const struct particles *const ps = c->sim->particles;
    const double x[3] = {ps->x[a->i], ps->y[a->i], ps->z[a->i]};
    const struct contact_law *const law = dem_created_with(c->sim->dem)->law;

    contact_list_reserve(c);
    memcpy(&c->x[6 * c->n], x, sizeof x);
    vector_along(x, 1.0, a->d, &c->x[6 * c->n + 3]);
    c->depth[c->n] = a->depth;
    c->force[c->n] =
        law->respond(&c->constants[a->pair], a->depth, a->R, a->m).elastic;
    c->index[2 * c->n] = a->i;
    c->index[2 * c->n + 1] = a->j;
    c->ids[2 * c->n] = ps->id[a->i];
    c->ids[2 * c->n + 1] = a->j < 0 ? a->j : ps->id[a->j];
    c->corner[2 * c->n] = 2 * c->n;
    c->corner[2 * c->n + 1] = 2 * c->n + 1;
    c->end[c->n] = 2 * c->n + 2;
    c->n++;
}

static int material_of(const struct particles *ps, int i)
{
    return ps->material != NULL ? ps->material[i] : 0;
}

static int contact_list_pair_of(const struct contact_list *c, int a, int b)
{
    return a * materials_count(c->sim->materials) + b;
}

static void contact_list_add_pair(struct contact_list *c, int i, int j,
                                  const double x[3])
{
    const struct particles *const ps = c->sim->particles;
    const double y[3] = {ps->x[j], ps->y[j], ps->z[j]};
    const double R[2] = {0.5 * ps->d[i], 0.5 * ps->d[j]};
    struct meeting a = {
        i,
        j,
        contact_list_pair_of(c, material_of(ps, i), material_of(ps, j)),
        {0.0},
        0.0,
        R[0] * R[1] / (R[0] + R[1]),
        ps->m[i] * ps->m[j] / (ps->m[i] + ps->m[j])};

    for (int k = 0; k < 3; k++)
        a.d[k] = box_domain_nearest(&c->box, k, y[k] - x[k]);
    a.depth = R[0] + R[1] - vector_length(a.d);
    if (a.depth > 0.0) contact_list_add(c, &a);
}

/* With something flat of this material, at `gap` from the centre. */
static void contact_list_add_flat(struct contact_list *c, int i, int number,
                                  int material, const double d[3], double gap)
{
    const struct particles *const ps = c->sim->particles;
    const double R = 0.5 * ps->d[i];
    const struct meeting a = {
        i,
        number,
        contact_list_pair_of(c, material_of(ps, i), material),
        {d[0], d[1], d[2]},
        R - gap,
        R,
        ps->m[i]};

    if (gap < R) contact_list_add(c, &a);
}

static void contact_list_add_walls(struct contact_list *c, int i,
                                   const double x[3])
{
    const struct materials *const all = c->sim->materials;

    for (int w = 0; w < 6; w++) {
        const double gap = box_domain_gap(&c->box, w, x);
        double d[3] = {0.0, 0.0, 0.0};
        d[w / 2] = w % 2 ? gap : -gap;
        if (!c->box.periodic[w / 2])
            contact_list_add_flat(c, i, -1 - w, all != NULL ? all->wall : 0, d,
                                  gap);
    }
}

/* The particles as the search for the faces near them wants them. */
static void contact_list_fill_rows(struct contact_list *c)
{
    const struct particles *const ps = c->sim->particles;
    struct rows *const rows = c->rows;

    rows->n = ps->n;
    for (int i = 0; i < ps->n; i++) {
        const double x[4] = {ps->x[i], ps->y[i], ps->z[i], 0.5 * ps->d[i]};
        memcpy(&rows->place[i], x, sizeof x);
        memcpy(rows->listed[i], rows->place[i].x, sizeof rows->listed[i]);
    }
}

/* They are found anew, where the surfaces are now: before the first step, too.
 */
static void contact_list_add_surfaces(struct contact_list *c)
{
    const struct dem_options *const o = dem_created_with(c->sim->dem);
    const struct surface_scene scene = {o->surfaces, o->n_surfaces, &c->box};
    const struct chunk all = {.end = c->sim->particles->n};

    if (o->n_surfaces == 0) return;
    contact_list_fill_rows(c);
    for (int k = 0; k < scene.n; k++)
        c->pose[k] = dem_surface(c->sim->dem, k).pose;
    near_faces_find(&c->near, &scene, c->pose, &all, c->rows, 0.0);
    surface_contact_points_find(&c->points, &c->near, &scene, c->pose, c->rows);
    for (int q = 0; q < c->points.n; q++) {
        const struct surface_contact_point *const at = &c->points.list[q];
        double d[3] = {0.0, 0.0, 0.0};
        vector_along(d, -at->r, at->n, d);
        contact_list_add_flat(c, at->owner, -7 - at->surface,
                              scene.surface[at->surface].material, d, at->r);
    }
}

/* All contacts of particles with each other, the box and surfaces. The force is
 * the elastic normal one, by the law of contact at the present overlap. ids: of
 * the particle, and of the other or -1 - w of wall w, -7 - s of surface s. A
 * line to a wall or surface ends where it is touched; one across a periodic end
 * leaves the box.
 * A particle is compared with those that were put into the cells before it. */
static void contact_list_find(struct contact_list *c)
{
    const struct particles *const ps = c->sim->particles;
    double widest = 0.0;
    int near[LINK_CELLS_AROUND];

    c->n = 0;
    for (int i = 0; i < ps->n; i++)
        widest = ps->d[i] > widest ? ps->d[i] : widest;
    link_cells_clear(c->cells, widest);
    for (int i = 0; i < ps->n; i++) {
        const double x[3] = {ps->x[i], ps->y[i], ps->z[i]};
        const int n = link_cells_around(c->cells, x, near);
        for (int k = 0; k < n; k++)
            for (int j = c->cells->head[near[k]]; j >= 0; j = c->cells->next[j])
                contact_list_add_pair(c, i, j, x);
        contact_list_add_walls(c, i, x);
        link_cells_add(c->cells, i, x);
    }
    contact_list_add_surfaces(c);
}

static struct contact_list *contact_list_create(const struct simulation *sim)
{
    struct contact_list *const c = owner_create(sizeof *c);
    const struct dem_options *const o = dem_created_with(sim->dem);
    const int n = materials_count(sim->materials);

    c->sim = sim;
    c->box = box_domain_of(o->lo, o->hi, o->periodic);
    c->constants = owner_zeroed(c, (size_t)n * (size_t)n, sizeof *c->constants);
    materials_table(o->law, &o->material, o->materials, c->constants);
    c->cells = link_cells_create(sim->particles->capacity, &c->box);
    if (o->n_surfaces > 0) {
        c->rows = rows_create(sim->particles->capacity, &c->box);
        c->pose = owner_zeroed(c, (size_t)o->n_surfaces, sizeof *c->pose);
    }
    contact_list_reserve(c);
    return c;
}

static void contact_list_free(struct contact_list *c)
{
    if (c == NULL) return;
    owner_free(c->cells);
    if (c->rows != NULL) {
        owner_free(c->rows);
        near_faces_release(&c->near);
        free(c->points.list);
    }
    free(c->x);
    free(c->force);
    free(c->depth);
    free(c->ids);
    free(c->corner);
    free(c->end);
    free(c->index);
    owner_free(c);
}

/* --- for ParaView: lines between centres, DIR/contacts.pvd ---------------- */

struct contacts {
    struct series *series;
    struct contact_list *found;
};

static int contacts_add_fields(void *part, double t)
{
    struct contacts *const own = part;
    const struct contact_list *const c = own->found;

    contact_list_find(own->found);
    const struct vtk_polygons lines = {2 * c->n,  c->n,   c->x,
                                       c->corner, c->end, .lines = 1};
    const struct vtk_array arrays[] = {
        vtk_single("force", 1, c->force),
        vtk_single("overlap", 1, c->depth),
        {.name = "ids", .components = 2, .ints = c->ids}};
    return series_add_polygons(own->series, &lines, t, 3, arrays);
}

static void contacts_release(void *part)
{
    struct contacts *const c = part;

    series_free(c->series);
    contact_list_free(c->found);
    free(c);
}

static void *contacts_create(const struct recorder_view *v, int *failed)
{
    if (v->sim->dem == NULL || !v->of->output->contacts) return NULL;
    struct contacts *const c = alloc_zeroed(1, sizeof *c);

    c->found = contact_list_create(v->sim);
    c->series = recorder_series(v, "contacts");
    *failed = c->series == NULL;
    return c;
}

static void contacts_visit(void *part, struct state *s)
{
    series_state(((struct contacts *)part)->series, s);
}

const struct recorder_part recorder_contacts = {
    .create = contacts_create,
    .free = contacts_release,
    .fields = contacts_add_fields,
    .state = contacts_visit,
};

/* --- further arrays ------------------------------------------------------- */

static void take_mass(void *memory, const struct simulation *sim, double *to)
{
    (void)memory;
    memcpy(to, sim->particles->m, (size_t)sim->particles->n * sizeof *to);
}

static void take_material(void *memory, const struct simulation *sim,
                          double *to)
{
    const struct particles *const ps = sim->particles;

    (void)memory;
    for (int i = 0; i < ps->n; i++)
        to[i] = ps->material != NULL ? ps->material[i] : 0;
}

/* The external force of the last sub-step less the weight, with the present
 * velocity in the implicit part of the drag. */
static void take_fluid_force(void *memory, const struct simulation *sim,
                             double *to)
{
    const struct particles *const ps = sim->particles;
    const double *const e[3] = {ps->ex, ps->ey, ps->ez};
    const double *const v[3] = {ps->vx, ps->vy, ps->vz};

    (void)memory;
    for (int i = 0; i < ps->n; i++) {
        const double k_d =
            ps->drag_coefficient != NULL ? ps->drag_coefficient[i] : 0.0;
        for (int k = 0; k < 3; k++)
            to[3 * i + k] =
                sim->steps == 0
                    ? 0.0
                    : e[k][i] - ps->m[i] * sim->gravity[k] - k_d * v[k][i];
    }
}

static void take_contact_force(void *memory, const struct simulation *sim,
                               double *to)
{
    const struct particles *const ps = sim->particles;

    (void)memory;
    for (int i = 0; i < ps->n; i++) {
        to[3 * i] = ps->cfx[i];
        to[3 * i + 1] = ps->cfy[i];
        to[3 * i + 2] = ps->cfz[i];
    }
}

static void take_contact_number(void *memory, const struct simulation *sim,
                                double *to)
{
    struct contact_list *const c = memory;

    contact_list_find(c);
    memset(to, 0, (size_t)sim->particles->n * sizeof *to);
    for (int i = 0; i < 2 * c->n; i++)
        if (c->index[i] >= 0) to[c->index[i]] += 1.0;
}

static void take_grains(void *memory, const struct simulation *sim, double *to)
{
    (void)memory;
    for (int i = 0; i < sim->particles->n; i++)
        to[i] = particles_grains(sim->particles, i);
}

static void take_grain_diameter(void *memory, const struct simulation *sim,
                                double *to)
{
    (void)memory;
    for (int i = 0; i < sim->particles->n; i++)
        to[i] = particles_grain(sim->particles, i);
}

const struct snapshot_field snapshot_fields[] = {
    {"mass", "kg", 1, take_mass},
    {"material", "-", 1, take_material},
    {"fluid_force", "N", 3, take_fluid_force},
    {"contact_force", "N", 3, take_contact_force},
    {"contact_number", "-", 1, take_contact_number},
    {"grains", "-", 1, take_grains},
    {"grain_diameter", "m", 1, take_grain_diameter},
    {NULL, NULL, 0, NULL}};

/* Adds a field to the snapshot, once. */
static void add_field(const struct recorder_view *v, const char *name,
                      struct contact_list **contacts)
{
    const struct particles *const ps = v->sim->particles;
    const struct snapshot_field *f = snapshot_fields;

    while (strcmp(f->name, name) != 0)
        f++;
    if (f->take == take_material && ps->material != NULL)
        return; /* is written anyway */
    for (int i = 0; i < v->snapshot->n_more; i++)
        if (v->snapshot->more[i] == f) return;
    if (f->take == take_contact_number) *contacts = contact_list_create(v->sim);
    snapshot_add(v->snapshot, f, *contacts);
}

/* Adds what the case names to the snapshot, and of parcels what they stand for;
 * the list of contacts is all that is left to be freed. */
static void *particle_fields_create(const struct recorder_view *v, int *failed)
{
    const struct output_options *const o = v->of->output;
    const char *text = o->particles != NULL ? o->particles : "";
    struct contact_list *contacts = NULL;
    char word[SNAPSHOT_WORD];
    int used;

    (void)failed;
    if (v->sim->dem == NULL) return NULL;
    if (o->sorted) snapshot_order_by_id(v->snapshot);
    for (; sscanf(text, " %63[^ ]%n", word, &used) == 1; text += used)
        add_field(v, word, &contacts);
    if (v->sim->particles->across == NULL) return contacts;
    add_field(v, "grains", &contacts);
    add_field(v, "grain_diameter", &contacts);
    return contacts;
}

static void particle_fields_release(void *contacts)
{
    contact_list_free(contacts);
}

const struct recorder_part recorder_particle_fields = {
    .create = particle_fields_create,
    .free = particle_fields_release,
};
