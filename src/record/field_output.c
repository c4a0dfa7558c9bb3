/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "record/field_output.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "coupling/effects.h"
#include "coupling/processes.h"
#include "output/poly/vtk_cells.h"
#include "output/vtk.h"

struct field_output {
    const struct mesh *mesh;
    const struct simulation *sim;
    struct folder *folder;            /* borrowed */
    struct series *fluid, *particles; /* NULL where there are none */
    struct vtk_file *writer;
    struct vtk_cells *cells; /* of a mesh that is no box; else NULL */
    double last;             /* [s] */
};

struct series *field_output_series(struct folder *f, const char *name,
                                   const char *suffix)
{
    char pvd[32];

    snprintf(pvd, sizeof pvd, "%s.pvd", name);
    char *const path = folder_file(f, pvd);
    struct series *const made =
        path == NULL || folder_make(f, name) != 0
            ? NULL
            : series_create(folder_name(f), name, suffix);
    free(path);
    return made;
}

struct field_output *field_output_create(const struct simulation *sim,
                                         struct folder *folder)
{
    struct field_output *const p = alloc_zeroed(1, sizeof *p);

    p->sim = sim;
    p->folder = folder;
    p->mesh = sim->mesh;
    p->writer = vtk_file_create();
    p->last = -1.0;
    if (sim->fluid != NULL && p->mesh->shape != NULL)
        p->cells = vtk_cells_create(p->mesh);
    if (sim->fluid != NULL)
        p->fluid = field_output_series(folder, "fluid",
                                       sim->processes != NULL ? "pvtr"
                                       : p->cells != NULL     ? "vtu"
                                                              : "vtr");
    if (sim->particles != NULL)
        p->particles = field_output_series(
            folder, "particles", sim->processes != NULL ? "pvtp" : "vtp");
    if ((sim->fluid == NULL || p->fluid != NULL) &&
        (sim->particles == NULL || p->particles != NULL))
        return p;
    field_output_free(p);
    return NULL;
}

void field_output_free(struct field_output *p)
{
    if (p == NULL) return;
    series_free(p->fluid);
    series_free(p->particles);
    vtk_cells_free(p->cells);
    vtk_file_free(p->writer);
    free(p);
}

/* The path of the next file of a series, which is then listed in the folder;
 * NULL after a message. */
static const char *next_of(struct field_output *p, struct series *s)
{
    const char *const path = series_next(s);
    return folder_list(p->folder, path) == 0 ? path : NULL;
}

/* The fields of the effects, after the n that are there. */
static int add_effects(const struct simulation *sim, int n,
                       struct vtk_array *arrays)
{
    for (int i = 0; i < sim->n_effects; i++) {
        const struct effect *const e = sim->effects[i].effect;
        struct effect_field f[EFFECT_FIELDS];
        const int more =
            e->fields == NULL ? 0 : e->fields(sim->effects[i].memory, f);
        for (int k = 0; k < more && n < FIELD_OUTPUT_ARRAYS; k++)
            arrays[n++] = (struct vtk_array){.name = f[k].name,
                                             .components = f[k].components,
                                             .values = f[k].values,
                                             .single = 1};
    }
    return n;
}

int field_output_of_fluid(const struct simulation *sim,
                          const struct snapshot *s,
                          struct vtk_array arrays[FIELD_OUTPUT_ARRAYS])
{
    int n = 3;

    arrays[0] = (struct vtk_array){
        .name = "void_fraction", .components = 1, .values = s->eps};
    arrays[1] = (struct vtk_array){
        .name = "velocity", .components = 3, .values = s->u, .single = 1};
    arrays[2] = (struct vtk_array){
        .name = "pressure", .components = 1, .values = s->p, .single = 1};
    if (s->u_s != NULL)
        arrays[n++] = (struct vtk_array){.name = "solid_velocity",
                                         .components = 3,
                                         .values = s->u_s,
                                         .single = 1};
    return add_effects(sim, n, arrays);
}

static int field_output_add_fluid(struct field_output *p,
                                  const struct snapshot *s)
{
    struct processes *const others = p->sim->processes;
    struct vtk_array arrays[FIELD_OUTPUT_ARRAYS];
    const int n = field_output_of_fluid(p->sim, s, arrays);
    const char *const path = next_of(p, p->fluid);

    if (path == NULL) return 1;
    const int failed =
        others != NULL ? others->write(others, path, s)
        : p->cells != NULL
            ? vtk_cells_write(p->writer, path, p->cells, s->t, n, arrays)
            : vtk_write_box(p->writer, path, p->mesh, s->t, n, arrays);
    return failed != 0 || series_add(p->fluid, s->t) != 0;
}

int field_output_of_particles(const struct snapshot *s,
                              struct vtk_array arrays[FIELD_OUTPUT_ARRAYS])
{
    const struct vtk_array own[5] = {
        {.name = "diameter", .components = 1, .values = s->d, .single = 1},
        {.name = "velocity",
         .components = 3,
         .split = {s->v[0], s->v[1], s->v[2]},
         .single = 1},
        {.name = "angular_velocity",
         .components = 3,
         .split = {s->w[0], s->w[1], s->w[2]},
         .single = 1},
        {.name = "id", .components = 1, .ints = s->id},
        {.name = "material", .components = 1, .ints = s->material}};

    int n = s->material != NULL ? 5 : 4;
    memcpy(arrays, own, sizeof own);
    for (int i = 0; i < s->n_more; i++)
        arrays[n++] = (struct vtk_array){.name = s->more[i]->name,
                                         .components = s->more[i]->components,
                                         .values = s->value[i],
                                         .single = 1};
    return n;
}

static int field_output_add_particles(struct field_output *p,
                                      const struct snapshot *s)
{
    struct processes *const others = p->sim->processes;
    const double *const x[3] = {s->x[0], s->x[1], s->x[2]};
    struct vtk_array arrays[FIELD_OUTPUT_ARRAYS];
    const int n = field_output_of_particles(s, arrays);
    const char *const path = next_of(p, p->particles);

    if (path == NULL) return 1;
    const int failed =
        others != NULL
            ? others->write(others, path, s)
            : vtk_write_particles(p->writer, path, s->n, x, s->t, n, arrays);
    return failed != 0 || series_add(p->particles, s->t) != 0;
}

int field_output_add(struct field_output *p, const struct snapshot *s)
{
    if (p->fluid != NULL && field_output_add_fluid(p, s) != 0) return 1;
    if (p->particles != NULL && field_output_add_particles(p, s) != 0) return 1;
    p->last = s->t;
    return 0;
}

void field_output_state(struct field_output *p, struct state *s)
{
    struct series *const all[] = {p->fluid, p->particles};

    state_begin(s, "field_output");
    for (int i = 0; i < 2; i++)
        if (all[i] != NULL) series_state(all[i], s);
    state_real(s, "last", "s", &p->last);
    state_end(s);
}

double field_output_last(const struct field_output *p)
{
    return p->last;
}
