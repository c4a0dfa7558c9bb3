/* SPDX-License-Identifier: GPL-3.0-or-later */
/* surfaces.c -- what is written of surfaces and walls.
 *
 * DIR/surfaces.csv has a row with each row of history.csv: of each surface the
 * force and the torque, as means since the row before, and the work that it has
 * done so far; after them the volume that each one that wears has lost, and the
 * way of each one under load.
 * DIR/surfaces.pvd shows them as polygons, those that wear with the depth and
 * the stresses of each face as means since the picture before; DIR/walls.pvd
 * the faces at the boundary with what the fluid does to them.
 */
#include "record/recorder_part.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/file.h"
#include "base/vector.h"
#include "dem/surfaces/surfaces.h"
#include "fluid/systems.h"
#include "mesh/measures.h"
#include "output/pictures/picture.h"
#include "output/series.h"

/* --- forces and torques on them ------------------------------------------- */

enum { EACH = 7 }; /* columns a surface */

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
    struct table_head head = {0};

    table_head_add(&head, "time [s]");
    for (int c = 0; c < EACH * sim->n_surfaces; c++)
        table_head_add(&head, "%s_%s", sim->surface_names[c / EACH],
                       what[c % EACH]);
    for (int s = 0; s < sim->n_surfaces; s++)
        if (dem_surface_wear(sim->dem, s) != NULL)
            table_head_add(&head, "%s_worn [m^3]", sim->surface_names[s]);
    for (int s = 0; s < sim->n_surfaces; s++)
        if (sim->surfaces[s].load.speed > 0.0)
            table_head_add(&head, "%s_way [m]", sim->surface_names[s]);
    return folder_table(folder, "surfaces.csv", &head);
}

static void surface_table_release(void *part)
{
    struct surface_table *const t = part;

    table_free(t->table);
    owner_free(t);
}

static void *surface_table_create(const struct recorder_view *v, int *failed)
{
    if (v->sim->n_surfaces == 0) return NULL;
    struct surface_table *const t = owner_create(sizeof *t);

    t->sim = v->sim;
    t->t = -1.0;
    t->before = owner_zeroed(t, (size_t)v->sim->n_surfaces, sizeof *t->before);
    t->row = owner_doubles(t, 1 + (EACH + 2) * v->sim->n_surfaces);
    t->table = surface_table_create_table(v->sim, v->folder);
    *failed = t->table == NULL;
    return t;
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

static double total_worn(const struct simulation *sim, int s)
{
    const struct wear_face *const face = dem_surface_wear(sim->dem, s);
    double sum = 0.0;

    for (int f = 0; f < wear_faces(&sim->surfaces[s]); f++)
        sum += face[f].worn;
    return sum;
}

/* How far it has moved along its load. */
static double way_of(const struct surface *s, const struct pose *p)
{
    double way[3];

    vector_between(p->centre, p->start, way);
    return vector_dot(way, s->load.force) / vector_length(s->load.force);
}

static int surface_table_add_row(void *part)
{
    struct surface_table *const t = part;
    double *more = &t->row[1 + EACH * t->sim->n_surfaces];
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
        if (dem_surface_wear(t->sim->dem, s) != NULL)
            *more++ = total_worn(t->sim, s);
    }
    for (int s = 0; s < t->sim->n_surfaces; s++)
        if (t->sim->surfaces[s].load.speed > 0.0)
            *more++ = way_of(&t->sim->surfaces[s], &t->before[s].pose);
    return table_add(t->table, t->row);
}

const struct recorder_part recorder_surface_table = {
    .create = surface_table_create,
    .free = surface_table_release,
    .row = surface_table_add_row,
    .last_row = surface_table_add_row,
    .state = surface_table_visit};

/* --- as polygons ---------------------------------------------------------- */

struct surface_fields {
    const struct simulation *sim;
    const struct snapshot *last; /* borrowed; its time is that of the picture */
    struct folder *folder;       /* borrowed */
    struct series *series;
    struct outline outline;
    int wears;                      /* [-] 1: one of them does */
    int n_faces;                    /* [-] of all */
    struct wear_face *before;       /* of each face, at the picture before */
    double t;                       /* [s] of that; negative: there is none */
    int room;                       /* [-] polygons that these have room for: */
    double *depth, *normal, *shear; /* [m], [Pa], [Pa] */
};

/* The faces of those that do not wear have none of it. */
static void begin_wear(struct surface_fields *p)
{
    const struct simulation *const sim = p->sim;

    p->t = -1.0;
    for (int s = 0; s < sim->n_surfaces; s++) {
        p->n_faces += wear_faces(&sim->surfaces[s]);
        p->wears |= dem_surface_wear(sim->dem, s) != NULL;
    }
    if (p->wears)
        p->before = owner_zeroed(p, (size_t)p->n_faces, sizeof *p->before);
}

static void free_values(struct surface_fields *p)
{
    free(p->depth);
    free(p->normal);
    free(p->shear);
}

static void surface_fields_release(void *part)
{
    struct surface_fields *const p = part;

    series_free(p->series);
    outline_release(&p->outline);
    free_values(p);
    owner_free(p);
}

static void *surface_fields_create(const struct recorder_view *v, int *failed)
{
    if (v->sim->n_surfaces == 0) return NULL;
    struct surface_fields *const p = owner_create(sizeof *p);

    p->sim = v->sim;
    p->last = v->whole;
    p->folder = v->folder;
    p->series = recorder_series(v, "surfaces");
    begin_wear(p);
    *failed = p->series == NULL;
    return p;
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

    double up[3];
    history_up(p->sim, up);
    const struct picture_view see = picture_view(up);
    const int deep = see.axis[2];
    fprintf(file_stream(f), "# %c [m]  %c [m], two points a segment\n",
            'x' + see.axis[0], 'x' + see.axis[1]);
    outline_section(file_stream(f), &p->outline, see.axis,
                    0.5 * (m->lo[deep] + m->hi[deep]));
    fprintf(file_stream(f), "nan nan\n");
    return file_commit(f);
}

static void make_room(struct surface_fields *p, int n)
{
    free_values(p);
    p->depth = alloc_doubles(n);
    p->normal = alloc_doubles(n);
    p->shear = alloc_doubles(n);
    p->room = n;
}

static double area_of(const struct outline *o, int polygon)
{
    const int first = polygon > 0 ? o->end[polygon - 1] : 0;
    double a[3], b[3], cross[3], sum[3] = {0.0, 0.0, 0.0};

    for (int i = first + 1; i + 1 < o->end[polygon]; i++) {
        vector_between(&o->x[3L * i], &o->x[3L * first], a);
        vector_between(&o->x[3L * (i + 1)], &o->x[3L * first], b);
        vector_cross(a, b, cross);
        vector_along(sum, 0.5, cross, sum);
    }
    return vector_length(sum);
}

/* Of one face, which is drawn as the polygons from `from` to `to`. */
static void take_face(struct surface_fields *p, const struct wear_face *now,
                      struct wear_face *before, double per_time, int from,
                      int to)
{
    double area = 0.0;

    for (int i = from; i < to; i++)
        area += area_of(&p->outline, i);
    for (int i = from; i < to; i++) {
        p->depth[i] = now->worn / area;
        p->normal[i] = per_time / area * (now->normal - before->normal);
        p->shear[i] = per_time / area * (now->shear - before->shear);
    }
    *before = *now;
}

/* The arrays of all polygons as they are drawn, at time t [s]. */
static void take_wear(struct surface_fields *p, double t)
{
    static const struct wear_face none = {0};
    const struct outline *const o = &p->outline;
    const double per_time = p->t >= 0.0 && t > p->t ? 1.0 / (t - p->t) : 0.0;
    struct wear_face *before = p->before;
    int polygon = 0;

    if (o->n_polygons > p->room) make_room(p, o->n_polygons);
    for (int s = 0; s < p->sim->n_surfaces; s++) {
        const struct surface *const one = &p->sim->surfaces[s];
        const struct wear_face *const face = dem_surface_wear(p->sim->dem, s);
        for (int f = 0; f < wear_faces(one); f++) {
            int end = polygon + (one->triangles != NULL);
            while (end < o->n_polygons && o->of[end] == s &&
                   one->triangles == NULL)
                end++;
            take_face(p, face != NULL ? &face[f] : &none, before++, per_time,
                      polygon, end);
            polygon = end;
        }
    }
    p->t = t;
}

/* Writes them once, if none of them moves or wears. */
static int surface_fields_add(void *part, double t)
{
    struct surface_fields *const p = part;
    const struct outline *const o = &p->outline;

    if (series_count(p->series) > 0 && !p->wears &&
        !surface_fields_any_moves(p->sim))
        return 0;
    surface_fields_draw(p, t);
    if (p->wears) take_wear(p, t);
    const struct vtk_polygons shape = {o->n_points, o->n_polygons, o->x,
                                       o->corner,   o->end,        0};
    const struct vtk_array of[] = {
        {.name = "surface", .components = 1, .ints = o->of},
        {.name = "worn_depth", .components = 1, .values = p->depth},
        {.name = "normal_stress", .components = 1, .values = p->normal},
        {.name = "shear_stress", .components = 1, .values = p->shear}};
    return series_add_polygons(p->series, &shape, t, p->wears ? 4 : 1, of);
}

static void surface_fields_visit(void *part, struct state *s)
{
    struct surface_fields *const p = part;
    series_state(p->series, s);
    if (!p->wears) return;
    state_real(s, "t", "s", &p->t);
    wear_state(p->before, p->n_faces, s);
}

const struct recorder_part recorder_surfaces = {.create = surface_fields_create,
                                                .free = surface_fields_release,
                                                .fields = surface_fields_add,
                                                .finish = put_section,
                                                .state = surface_fields_visit};

/* --- the walls ------------------------------------------------------------ */

/* On faces that the fluid flows through the stress is zero. */
struct walls {
    const struct simulation *sim;
    struct series *series;
    struct vtk_polygons shape;
    double *x;          /* [m] 3 a point */
    int *corner, *end;  /* of the polygons */
    int *patch;         /* [-] number of each face's patch */
    double *p, *shear;  /* [Pa], 3 [Pa] */
    double *y_plus, *u; /* [-], 3 [m/s] */
};

static void set_shape(struct walls *w)
{
    const struct mesh *const m = w->sim->mesh;
    const int n = m->n_faces - m->n_internal;
    int points = 0;

    for (int f = m->n_internal; f < m->n_faces; f++)
        points += mesh_face_corners(m, f, 0, NULL);
    w->x = owner_doubles(w, 3 * points);
    w->corner = owner_ints(w, points);
    w->end = owner_ints(w, n);
    points = 0;
    for (int i = 0; i < n; i++) {
        const int f = m->n_internal + i,
                  count = mesh_face_corners(m, f, 0, NULL);
        mesh_face_corners(m, f, count, (double(*)[3])(w->x + 3L * points));
        for (int k = 0; k < count; k++, points++)
            w->corner[points] = points;
        w->end[i] = points;
    }
    w->shape = (struct vtk_polygons){points, n, w->x, w->corner, w->end, 0};
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
            w->p[b] = fluid_boundary_pressure(fl, m->n_internal + b);
            w->y_plus[b] = s.y_plus;
            memcpy(&w->shear[3 * b], s.shear, sizeof s.shear);
        }
}

static int walls_add_fields(void *memory, double t)
{
    struct walls *const w = memory;
    const struct vtk_array arrays[] = {
        {.name = "patch", .components = 1, .ints = w->patch},
        vtk_single("pressure", 1, w->p),
        vtk_single("wall_shear_stress", 3, w->shear),
        vtk_single("y_plus", 1, w->y_plus),
        vtk_single("velocity", 3, w->u)};

    walls_take(w);
    return series_add_polygons(w->series, &w->shape, t, 5, arrays);
}

static void walls_release(void *memory)
{
    struct walls *const w = memory;

    series_free(w->series);
    owner_free(w);
}

static void *walls_create(const struct recorder_view *v, int *failed)
{
    if (v->sim->fluid == NULL || !v->of->output->walls) return NULL;
    const int n = v->sim->mesh->n_faces - v->sim->mesh->n_internal;
    struct walls *const w = owner_create(sizeof *w);

    w->sim = v->sim;
    set_shape(w);
    w->patch = owner_ints(w, n);
    w->p = owner_doubles(w, n);
    w->y_plus = owner_doubles(w, n);
    w->shear = owner_doubles(w, 3 * n);
    w->u = owner_doubles(w, 3 * n);
    w->series = recorder_series(v, "walls");
    *failed = w->series == NULL;
    return w;
}

static void walls_visit(void *part, struct state *s)
{
    series_state(((struct walls *)part)->series, s);
}

const struct recorder_part recorder_walls = {
    .create = walls_create,
    .fields = walls_add_fields,
    .free = walls_release,
    .state = walls_visit,
};
