/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scene/pictures.h"

#include <stdio.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "effects/effects.h"
#include "output/outline.h"
#include "output/series.h"
#include "output/vtk.h"

struct pictures {
    const struct mesh *mesh;
    const struct time_average *means; /* NULL where that effect is off */
    const struct simulation *sim;
    struct folder *folder;                       /* borrowed */
    struct series *fluid, *particles, *surfaces; /* NULL where there are none */
    struct outline outline;
    struct vtk_writer *writer;
    struct vtk_cells *cells; /* NULL for a box */
    double last;             /* [s] */
};

static const struct time_average *means_of(const struct simulation *sim)
{
    for (int i = 0; i < sim->n_effects; i++)
        if (sim->effects[i].effect == &time_average_effect)
            return sim->effects[i].memory;
    return NULL;
}

/* The collection NAME.pvd and a folder for its files. */
static struct series *create_series(struct folder *f, const char *name,
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

struct pictures *pictures_create(const struct simulation *sim,
                                 struct folder *folder)
{
    struct pictures *const p = alloc_zeroed(1, sizeof *p);

    p->sim = sim;
    p->folder = folder;
    p->mesh = sim->mesh;
    p->means = means_of(sim);
    p->writer = vtk_writer_create();
    p->last = -1.0;
    if (sim->fluid != NULL && p->mesh->shape != NULL)
        p->cells = vtk_cells_create(p->mesh);
    if (sim->fluid != NULL)
        p->fluid =
            create_series(folder, "fluid", p->cells != NULL ? "vtu" : "vtr");
    if (sim->particles != NULL)
        p->particles = create_series(folder, "particles", "vtp");
    if (sim->n_surfaces > 0)
        p->surfaces = create_series(folder, "surfaces", "vtp");
    if ((sim->fluid == NULL || p->fluid != NULL) &&
        (sim->particles == NULL || p->particles != NULL) &&
        (sim->n_surfaces == 0 || p->surfaces != NULL))
        return p;
    pictures_free(p);
    return NULL;
}

void pictures_free(struct pictures *p)
{
    if (p == NULL) return;
    series_free(p->fluid);
    series_free(p->particles);
    series_free(p->surfaces);
    outline_release(&p->outline);
    vtk_cells_free(p->cells);
    vtk_writer_free(p->writer);
    free(p);
}

/* The path of the next file of a series, listed; NULL after a message. */
static const char *next_of(struct pictures *p, struct series *s)
{
    const char *const path = series_next(s);
    return folder_list(p->folder, path) == 0 ? path : NULL;
}

static int add_fluid(struct pictures *p, const struct snapshot *s)
{
    struct vtk_array arrays[8] = {
        {.name = "void_fraction", .components = 1, .values = s->eps},
        {.name = "velocity", .components = 3, .values = s->u, .single = 1},
        {.name = "pressure", .components = 1, .values = s->p, .single = 1}};
    int n = 3;

    if (s->u_s != NULL)
        arrays[n++] = (struct vtk_array){.name = "solid_velocity",
                                         .components = 3,
                                         .values = s->u_s,
                                         .single = 1};
    if (p->means != NULL) {
        arrays[n++] = (struct vtk_array){.name = "mean_void_fraction",
                                         .components = 1,
                                         .values = p->means->eps,
                                         .single = 1};
        arrays[n++] = (struct vtk_array){.name = "mean_solid_flux",
                                         .components = 3,
                                         .values = p->means->eps_us,
                                         .single = 1};
    }
    const char *const path = next_of(p, p->fluid);
    if (path == NULL) return 1;
    const int failed =
        p->cells != NULL
            ? vtk_write_cells(p->writer, path, p->cells, s->t, n, arrays)
            : vtk_write_box(p->writer, path, p->mesh, s->t, n, arrays);
    return failed != 0 || series_add(p->fluid, s->t) != 0;
}

static int add_particles(struct pictures *p, const struct snapshot *s)
{
    const double *const x[3] = {s->x[0], s->x[1], s->x[2]};
    const struct vtk_array arrays[] = {
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

    const char *const path = next_of(p, p->particles);

    return path == NULL ||
           vtk_write_particles(p->writer, path, s->n, x, s->t,
                               s->material != NULL ? 5 : 4, arrays) != 0 ||
           series_add(p->particles, s->t) != 0;
}

static int any_moves(const struct simulation *sim)
{
    int moves = 0;

    for (int k = 0; k < sim->n_surfaces; k++)
        moves |= motion_is_any(&sim->surfaces[k].motion);
    return moves;
}

/* Once, if none of them moves. */
static int add_surfaces(struct pictures *p, double t)
{
    const struct mesh *const m = p->mesh;
    const struct simulation *const sim = p->sim;
    struct outline *const o = &p->outline;

    if (series_count(p->surfaces) > 0 && !any_moves(sim)) return 0;
    outline_draw(o, sim->surfaces, sim->n_surfaces, m->lo, m->hi, t);
    const struct vtk_polygons shape = {o->n_points, o->n_polygons, o->x,
                                       o->corner, o->end};
    const struct vtk_array of = {
        .name = "surface", .components = 1, .ints = o->of};
    const char *const path = next_of(p, p->surfaces);
    return path == NULL ||
           vtk_write_polygons(p->writer, path, &shape, t, 1, &of) != 0 ||
           series_add(p->surfaces, t) != 0;
}

int pictures_add(struct pictures *p, const struct snapshot *s)
{
    if (p->fluid != NULL && add_fluid(p, s) != 0) return 1;
    if (p->particles != NULL && add_particles(p, s) != 0) return 1;
    if (p->surfaces != NULL && add_surfaces(p, s->t) != 0) return 1;
    p->last = s->t;
    return 0;
}

double pictures_last(const struct pictures *p)
{
    return p->last;
}
