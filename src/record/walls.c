/* SPDX-License-Identifier: GPL-3.0-or-later */
/* walls.c -- the boundary faces with what the fluid does to them, for ParaView:
 * DIR/walls.pvd. On faces that it flows through the stress is zero. */
#include "record/recorder_part.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "record/field_output.h"
#include "case/forces/forces.h"
#include "fluid/forces/wall_stress.h"
#include "mesh/measures.h"
#include "output/series.h"
#include "output/polygons/vtk_polygons.h"

struct walls {
    const struct simulation *sim;
    struct folder *folder;
    struct series *series;
    struct vtk_file *writer;
    struct vtk_polygons shape;
    double *x;          /* [m] 3 a point */
    int *corner, *end;  /* of the polygons */
    int *patch;         /* [-] number of each face's patch */
    double *p, *shear;  /* [Pa], 3 [Pa] */
    double *y_plus, *u; /* [-], 3 [m/s] */
};

int forces_is_open(const struct settings *s, const char *patch)
{
    const struct boundary_options *const o = settings_side(s, patch);

    return o != NULL && (o->condition->kind == BOUNDARY_INLET ||
                         o->condition->kind == BOUNDARY_OUTLET);
}

static void set_shape(struct walls *w)
{
    const struct mesh *const m = w->sim->mesh;
    const int n = m->n_faces - m->n_internal;
    int points = 0;

    for (int f = m->n_internal; f < m->n_faces; f++)
        points += mesh_face_corners(m, f, 0, NULL);
    w->x = alloc_doubles(3 * points);
    w->corner = alloc_ints(points);
    w->end = alloc_ints(n);
    points = 0;
    for (int i = 0; i < n; i++) {
        const int f = m->n_internal + i,
                  count = mesh_face_corners(m, f, 0, NULL);
        mesh_face_corners(m, f, count, (double(*)[3])(w->x + 3L * points));
        for (int k = 0; k < count; k++, points++)
            w->corner[points] = points;
        w->end[i] = points;
    }
    w->shape = (struct vtk_polygons){points, n, w->x, w->corner, w->end};
}

static void walls_take(struct walls *w)
{
    const struct fluid *const fl = w->sim->fluid;
    const struct mesh *const m = fl->mesh;

    fluid_boundary_velocity(fl, w->u);
    for (int i = 0; i < m->n_patches; i++)
        for (int j = 0; j < m->patches[i].n; j++) {
            const int b = m->patches[i].first + j - m->n_internal;
            const struct wall_stress s =
                wall_stress_is_wall(fl, i) ? wall_stress(fl, i, j)
                                           : (struct wall_stress){.area = 0.0};
            w->patch[b] = i;
            w->p[b] = fl->p_face[m->n_internal + b];
            w->y_plus[b] = s.y_plus;
            memcpy(&w->shear[3 * b], s.shear, sizeof s.shear);
        }
}

static int walls_add_fields(void *memory, double t)
{
    struct walls *const w = memory;
    const struct vtk_array arrays[] = {
        {.name = "patch", .components = 1, .ints = w->patch},
        {.name = "pressure", .components = 1, .values = w->p, .single = 1},
        {.name = "wall_shear_stress",
         .components = 3,
         .values = w->shear,
         .single = 1},
        {.name = "y_plus", .components = 1, .values = w->y_plus, .single = 1},
        {.name = "velocity", .components = 3, .values = w->u, .single = 1}};
    const char *const path = series_next(w->series);

    walls_take(w);
    return folder_list(w->folder, path) != 0 ||
           vtk_write_polygons(w->writer, path, &w->shape, t, 5, arrays) != 0 ||
           series_add(w->series, t) != 0;
}

static void walls_release(void *memory)
{
    struct walls *const w = memory;

    if (w == NULL) return;
    series_free(w->series);
    vtk_file_free(w->writer);
    free(w->x);
    free(w->corner);
    free(w->end);
    free(w->patch);
    free(w->p);
    free(w->shear);
    free(w->y_plus);
    free(w->u);
    free(w);
}

static void *walls_create(const struct recorder_view *v, int *failed)
{
    if (v->sim->fluid == NULL || !v->settings->output.walls) return NULL;
    const int n = v->sim->mesh->n_faces - v->sim->mesh->n_internal;
    struct walls *const w = alloc_zeroed(1, sizeof *w);

    w->sim = v->sim;
    w->folder = v->folder;
    w->writer = vtk_file_create();
    set_shape(w);
    w->patch = alloc_ints(n);
    w->p = alloc_doubles(n);
    w->y_plus = alloc_doubles(n);
    w->shear = alloc_doubles(3 * n);
    w->u = alloc_doubles(3 * n);
    w->series = field_output_series(v->folder, "walls", "vtp");
    if (w->series != NULL) return w;
    *failed = 1;
    walls_release(w);
    return NULL;
}

static const struct key keys[] = {
    {"output.walls", KEY_BOOL, "", "", "false",
     "walls.pvd: the boundary faces with pressure, wall shear stress, y+ and "
     "velocity, at the times of the pictures",
     "", "fluid", .at = KEY_AT(output_options, walls)},
    KEY_END};

static void walls_visit(void *part, struct state *s)
{
    series_state(((struct walls *)part)->series, s);
}

const struct recorder_part walls_part = {
    .keys = keys,
    .create = walls_create,
    .fields = walls_add_fields,
    .free = walls_release,
    .state = walls_visit,
};
