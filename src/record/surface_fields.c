/* SPDX-License-Identifier: GPL-3.0-or-later */
/* surface_fields.c -- the surfaces as polygons: DIR/surfaces.pvd. */
#include "record/recorder_part.h"

#include <stdio.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "base/file.h"
#include "record/field_output.h"
#include "dem/surfaces/surface.h"
#include "output/pictures/picture.h"
#include "output/series.h"
#include "output/surfaces/outline.h"
#include "output/surfaces/section.h"
#include "output/polygons/vtk_polygons.h"

struct surface_fields {
    const struct simulation *sim;
    const struct snapshot *last; /* borrowed; its time is that of the picture */
    struct folder *folder;       /* borrowed */
    struct series *series;
    struct outline outline;
    struct vtk_file *writer;
};

static void surface_fields_release(void *part)
{
    struct surface_fields *const p = part;

    series_free(p->series);
    outline_release(&p->outline);
    vtk_file_free(p->writer);
    free(p);
}

static void *surface_fields_create(const struct recorder_view *v, int *failed)
{
    if (v->sim->n_surfaces == 0) return NULL;
    struct surface_fields *const p = alloc_zeroed(1, sizeof *p);

    p->sim = v->sim;
    p->last = v->whole;
    p->folder = v->folder;
    p->writer = vtk_file_create();
    p->series = field_output_series(v->folder, "surfaces", "vtp");
    if (p->series != NULL) return p;
    *failed = 1;
    surface_fields_release(p);
    return NULL;
}

static int surface_fields_any_moves(const struct simulation *sim)
{
    int moves = 0;

    for (int k = 0; k < sim->n_surfaces; k++)
        moves |= motion_is_any(&sim->surfaces[k].motion);
    return moves;
}

static void surface_fields_draw(struct surface_fields *p, double t)
{
    const struct simulation *const sim = p->sim;
    const struct mesh *const m = sim->mesh;

    outline_draw(&p->outline, sim->surfaces, sim->n_surfaces, m->lo, m->hi, t);
}

/* Where they cut the middle of the depth, for the picture of the end. gnuplot
 * draws no file without a point, so one that is nowhere ends it. */
static int put_section(void *part)
{
    struct surface_fields *const p = part;
    const struct mesh *const m = p->sim->mesh;

    surface_fields_draw(p, p->last->t);
    if (folder_make(p->folder, "picture") != 0) return 1;
    struct file *const f = picture_open(p->folder, "picture/walls.txt");
    if (f == NULL) return 1;

    fprintf(file_stream(f), "# x [m]  y [m], two points a segment\n");
    section_write(file_stream(f), &p->outline, 0.5 * (m->lo[2] + m->hi[2]));
    fprintf(file_stream(f), "nan nan\n");
    return file_commit(f);
}

/* Writes them once, if none of them moves. */
static int surface_fields_add(void *part, double t)
{
    struct surface_fields *const p = part;
    const struct outline *const o = &p->outline;

    if (series_count(p->series) > 0 && !surface_fields_any_moves(p->sim))
        return 0;
    surface_fields_draw(p, t);
    const struct vtk_polygons shape = {o->n_points, o->n_polygons, o->x,
                                       o->corner, o->end};
    const struct vtk_array of = {
        .name = "surface", .components = 1, .ints = o->of};
    const char *const path = series_next(p->series);
    return folder_list(p->folder, path) != 0 ||
           vtk_write_polygons(p->writer, path, &shape, t, 1, &of) != 0 ||
           series_add(p->series, t) != 0;
}

static void surface_fields_visit(void *part, struct state *s)
{
    struct surface_fields *const p = part;
    series_state(p->series, s);
}

const struct recorder_part surface_fields_part = {
    .create = surface_fields_create,
    .free = surface_fields_release,
    .fields = surface_fields_add,
    .finish = put_section,
    .state = surface_fields_visit};
