/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "record/snapshot.h"

#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "coupling/effects.h"
#include "coupling/processes.h"
#include "output/series.h"
#include "output/vtk.h"

struct field_output {
    const struct mesh *mesh;
    const struct simulation *sim;
    struct series *fluid, *particles; /* NULL where there are none */
    struct vtk_cells *cells;          /* of a mesh that is no box; else NULL */
    double last;                      /* [s] */
};

struct field_output *field_output_create(const struct simulation *sim,
                                         struct folder *folder, int grids)
{
    struct field_output *const p = alloc_zeroed(1, sizeof *p);

    p->sim = sim;
    p->mesh = sim->mesh;
    p->last = -1.0;
    if (sim->fluid != NULL && (p->mesh->shape != NULL || grids))
        p->cells = vtk_cells_create(p->mesh);
    if (sim->fluid != NULL)
        p->fluid = series_in(folder, "fluid",
                             sim->processes != NULL ? "pvtr"
                             : p->cells != NULL     ? "vtu"
                                                    : "vtr");
    if (sim->particles != NULL)
        p->particles = series_in(folder, "particles",
                                 sim->processes != NULL ? "pvtp"
                                 : grids                ? "vtu"
                                                        : "vtp");
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
    free(p);
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
            arrays[n++] = vtk_single(f[k].name, f[k].components, f[k].values);
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
    arrays[1] = vtk_single("velocity", 3, s->u);
    arrays[2] = vtk_single("pressure", 1, s->p);
    if (s->u_s != NULL) arrays[n++] = vtk_single("solid_velocity", 3, s->u_s);
    return add_effects(sim, n, arrays);
}

static int field_output_add_fluid(struct field_output *p,
                                  const struct snapshot *s)
{
    struct processes *const others = p->sim->processes;
    struct vtk_array arrays[FIELD_OUTPUT_ARRAYS];
    const int n = field_output_of_fluid(p->sim, s, arrays);
    struct vtk_file *const writer = series_writer(p->fluid);
    const char *const path = series_begin(p->fluid);

    if (path == NULL) return 1;
    const int failed =
        others != NULL ? others->write(others, path, s)
        : p->cells != NULL
            ? vtk_cells_write(writer, path, p->cells, s->t, n, arrays)
            : vtk_write_box(writer, path, p->mesh, s->t, n, arrays);
    return failed != 0 || series_add(p->fluid, s->t) != 0;
}

int field_output_of_particles(const struct snapshot *s,
                              struct vtk_array arrays[FIELD_OUTPUT_ARRAYS])
{
    const struct vtk_array own[5] = {
        vtk_single("diameter", 1, s->d),
        vtk_vector("velocity", s->v[0], s->v[1], s->v[2]),
        vtk_vector("angular_velocity", s->w[0], s->w[1], s->w[2]),
        {.name = "id", .components = 1, .ints = s->id},
        {.name = "material", .components = 1, .ints = s->material}};

    int n = s->material != NULL ? 5 : 4;
    memcpy(arrays, own, sizeof own);
    for (int i = 0; i < s->n_more; i++)
        arrays[n++] =
            vtk_single(s->more[i]->name, s->more[i]->components, s->value[i]);
    return n;
}

static int field_output_add_particles(struct field_output *p,
                                      const struct snapshot *s)
{
    struct processes *const others = p->sim->processes;
    const double *const x[3] = {s->x[0], s->x[1], s->x[2]};
    struct vtk_array arrays[FIELD_OUTPUT_ARRAYS];
    const int n = field_output_of_particles(s, arrays);

    if (others == NULL)
        return series_add_particles(p->particles, s->n, x, s->t, n, arrays);
    const char *const path = series_begin(p->particles);
    return path == NULL || others->write(others, path, s) != 0 ||
           series_add(p->particles, s->t) != 0;
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
