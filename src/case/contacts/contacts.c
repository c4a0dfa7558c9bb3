/* SPDX-License-Identifier: GPL-3.0-or-later */
/* contacts.c -- the contacts as lines between centres, for ParaView:
 * DIR/contacts.pvd. Their force is the elastic normal one, by the law of
 * contact at the present overlap; a line to a wall ends at the wall. Contacts
 * with surfaces are left out. Lines across a periodic end leave the box. */
#include "case/recorder_part.h"

#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/vector.h"
#include "case/field_output.h"
#include "dem/box_domain.h"
#include "dem/link_cells.h"
#include "dem/materials.h"
#include "output/series.h"
#include "output/vtk.h"

struct contacts {
    const struct simulation *sim;
    struct folder *folder; /* borrowed */
    struct series *series;
    struct vtk_writer *writer;
    struct box_domain box;
    struct contact_constants *constants; /* of each pair of materials */
    struct link_cells *cells;
    int n, room;             /* [-] contacts */
    double *x;               /* [m] the two ends of each, 6 */
    double *force, *depth;   /* [N], [m] */
    int *ids, *corner, *end; /* [-] 2, 2 and 1 each; a wall: -1 - w */
};

static void *longer(void *old, int used, int room, size_t size)
{
    void *const made = alloc_zeroed((size_t)room, size);

    if (used > 0) memcpy(made, old, (size_t)used * size);
    free(old);
    return made;
}

static void reserve(struct contacts *c)
{
    if (c->n < c->room) return;
    c->room = 2 * c->room + 1024;
    c->x = longer(c->x, 6 * c->n, 6 * c->room, sizeof *c->x);
    c->force = longer(c->force, c->n, c->room, sizeof *c->force);
    c->depth = longer(c->depth, c->n, c->room, sizeof *c->depth);
    c->ids = longer(c->ids, 2 * c->n, 2 * c->room, sizeof *c->ids);
    c->corner = longer(c->corner, 2 * c->n, 2 * c->room, sizeof *c->corner);
    c->end = longer(c->end, c->n, c->room, sizeof *c->end);
}

/* From x along d, of two materials that overlap by `depth`. */
static void add(struct contacts *c, const double x[3], const double d[3],
                int id, int other, int pair, double depth, double R, double m)
{
    const struct contact_law *const law = dem_created_with(c->sim->dem)->law;

    reserve(c);
    memcpy(&c->x[6 * c->n], x, 3 * sizeof *x);
    vector_along(x, 1.0, d, &c->x[6 * c->n + 3]);
    c->depth[c->n] = depth;
    c->force[c->n] = law->respond(&c->constants[pair], depth, R, m).elastic;
    c->ids[2 * c->n] = id;
    c->ids[2 * c->n + 1] = other;
    c->corner[2 * c->n] = 2 * c->n;
    c->corner[2 * c->n + 1] = 2 * c->n + 1;
    c->end[c->n] = 2 * c->n + 2;
    c->n++;
}

static int material_of(const struct particles *ps, int i)
{
    return ps->material != NULL ? ps->material[i] : 0;
}

static void add_pair(struct contacts *c, int i, int j, const double x[3])
{
    const struct particles *const ps = c->sim->particles;
    const double y[3] = {ps->x[j], ps->y[j], ps->z[j]};
    const double R[2] = {0.5 * ps->d[i], 0.5 * ps->d[j]};
    double d[3];

    for (int k = 0; k < 3; k++)
        d[k] = box_domain_nearest(&c->box, k, y[k] - x[k]);
    const double depth = R[0] + R[1] - vector_length(d);
    if (depth <= 0.0) return;
    add(c, x, d, ps->id[i], ps->id[j],
        material_of(ps, i) * materials_count(c->sim->materials) +
            material_of(ps, j),
        depth, R[0] * R[1] / (R[0] + R[1]),
        ps->m[i] * ps->m[j] / (ps->m[i] + ps->m[j]));
}

static void add_walls(struct contacts *c, int i, const double x[3])
{
    const struct particles *const ps = c->sim->particles;
    const struct materials *const all = c->sim->materials;
    const double R = 0.5 * ps->d[i];

    for (int w = 0; w < 6; w++) {
        const double gap = box_domain_gap(&c->box, w, x);
        double d[3] = {0.0, 0.0, 0.0};
        if (c->box.periodic[w / 2] || gap >= R) continue;
        d[w / 2] = w % 2 ? gap : -gap;
        add(c, x, d, ps->id[i], -1 - w,
            material_of(ps, i) * materials_count(all) +
                (all != NULL ? all->wall : 0),
            R - gap, R, ps->m[i]);
    }
}

/* A particle is compared with those that were put into the cells before it. */
static void find(struct contacts *c)
{
    const struct particles *const ps = c->sim->particles;
    double widest = 0.0;
    int near[LINK_CELLS_AROUND];

    c->n = 0;
    for (int i = 0; i < ps->n; i++)
        widest = ps->d[i] > widest ? ps->d[i] : widest;
    link_cells_clear(c->cells, widest > 0.0 ? widest : 1.0);
    for (int i = 0; i < ps->n; i++) {
        const double x[3] = {ps->x[i], ps->y[i], ps->z[i]};
        const int n = link_cells_around(c->cells, x, near);
        for (int k = 0; k < n; k++)
            for (int j = c->cells->head[near[k]]; j >= 0; j = c->cells->next[j])
                add_pair(c, i, j, x);
        add_walls(c, i, x);
        link_cells_add(c->cells, i, x);
    }
}

static int add_fields(void *part, double t)
{
    struct contacts *const c = part;

    find(c);
    const struct vtk_polygons lines = {2 * c->n, c->n, c->x, c->corner, c->end};
    const struct vtk_array arrays[] = {
        {.name = "force", .components = 1, .values = c->force, .single = 1},
        {.name = "overlap", .components = 1, .values = c->depth, .single = 1},
        {.name = "ids", .components = 2, .ints = c->ids}};
    const char *const path = series_next(c->series);
    return folder_list(c->folder, path) != 0 ||
           vtk_write_lines(c->writer, path, &lines, t, 3, arrays) != 0 ||
           series_add(c->series, t) != 0;
}

static void release(void *part)
{
    struct contacts *const c = part;

    series_free(c->series);
    vtk_writer_free(c->writer);
    link_cells_free(c->cells);
    free(c->constants);
    free(c->x);
    free(c->force);
    free(c->depth);
    free(c->ids);
    free(c->corner);
    free(c->end);
    free(c);
}

static void *create(const struct settings *s, const struct simulation *sim,
                    struct folder *folder, int *failed)
{
    if (sim->dem == NULL || !settings_bool(s, "output.contacts")) return NULL;
    struct contacts *const c = alloc_zeroed(1, sizeof *c);
    const struct dem_options *const o = dem_created_with(sim->dem);
    const int n = materials_count(sim->materials);

    c->sim = sim;
    c->folder = folder;
    c->writer = vtk_writer_create();
    c->box = box_domain_of(o->lo, o->hi, o->periodic);
    c->constants = alloc_zeroed((size_t)n * (size_t)n, sizeof *c->constants);
    materials_table(o->law, &o->material, o->materials, c->constants);
    c->cells = link_cells_create(sim->particles->capacity, &c->box);
    reserve(c);
    c->series = field_output_series(folder, "contacts", "vtp");
    if (c->series != NULL) return c;
    *failed = 1;
    release(c);
    return NULL;
}

static void visit(void *part, struct state *s)
{
    series_state(((struct contacts *)part)->series, s);
}

static const struct key keys[] = {
    {"output.contacts", KEY_BOOL, "", "", "false",
     "contacts.pvd: a line for each contact of particles with each other and "
     "the box, with its elastic force, at the times of the pictures",
     "", "particles"},
    KEY_END};

const struct recorder_part contacts_part = {
    .keys = keys,
    .create = create,
    .free = release,
    .fields = add_fields,
    .state = visit,
};
