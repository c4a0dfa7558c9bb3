/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/particles/case_surfaces.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/text.h"
#include "base/vector.h"
#include "case/particles/case_materials.h"
#include "case/case_mesh.h"
#include "case/checks/checks.h"
#include "dem/surfaces/triangles.h"
#include "dem/surfaces/surface.h"
#include "dem/surfaces/surfaces.h"

static const char list[] = "particles.surfaces",
                  prescribed[] = "particles.prescribed";
/* 1 if one of its tables has the key particles.surfaces.NAME. */
static int reads(const struct surface_shape *shape, const char *name)
{
    for (int t = 0; t < KEY_TABLES && shape->keys[t] != NULL; t++)
        for (const struct key *k = shape->keys[t]; k->path != NULL; k++)
            if (strcmp(strrchr(k->path, '.') + 1, name) == 0) return 1;
    return 0;
}

/* The direction that its shape reads, and the key; NULL: none. */
static const double *direction_of(const struct surface_setup *one,
                                  const char **key)
{
    *key = "normal";
    if (reads(one->of.shape, *key)) return one->of.normal;
    *key = "axis";
    return reads(one->of.shape, *key) ? one->axis : NULL;
}

/* What the other members say, in the surface: all but its triangles. */
static void complete_surface(const struct settings *s, int i,
                             struct surface_setup *one)
{
    struct surface *const of = &one->of;
    const char *key;
    const double *const n = direction_of(one, &key);
    const double length = n != NULL ? vector_length(n) : 1.0;
    int own = 0;

    for (int k = 0; k < 3; k++)
        of->normal[k] = n != NULL ? n[k] / length : 0.0;
    if (!one->has_centre)
        memcpy(of->motion.centre, of->point, sizeof of->point);
    of->material = case_materials_of_wall(s, one->material);
    of->inside =
        reads(of->shape, "particles") && strcmp(one->particles, "inside") == 0;
    for (const struct key *k = of->shape->own_keys;
         k != NULL && k->path != NULL; k++)
        of->own[own++] =
            settings_item_real(s, list, i, strrchr(k->path, '.') + 1);
}

static int read_triangles(const struct settings *s, struct surface_setup *one)
{
    const struct input *const in = settings_input(s, one->file);
    struct stl stl;

    if (stl_parse(in, &stl) != 0) return 1;
    if (stl.dropped > 0)
        fprintf(stderr, "winnow: %s: %d triangles have no area; left out\n",
                in->path, stl.dropped);
    for (int t = 0; t < 9 * stl.n; t++) {
        double *const x = &stl.corner[t / 9][t / 3 % 3][t % 3];
        *x = one->of.point[t % 3] + one->scale * *x;
    }
    one->of.triangles = one->triangles = triangles_create(stl.n, stl.corner);
    stl_release(&stl);
    return 0;
}

static int read_course(const struct settings *s, struct motion_course *c,
                       struct motion *m)
{
    char wrong[CSV_WRONG];

    if (c->file == NULL) return 0;
    const struct input *const in = settings_input(s, c->file);
    m->table = c->table = motion_table_create(in, c->repeat, wrong);
    return c->table == NULL ? input_refuse(in, 0, "%s", wrong) : 0;
}

/* How many particles there are at the start [-]. */
static double number_at_start(const struct settings *s)
{
    double sum =
        s->particles.has_bed ? s->particles.bed.count : s->particles.place.n;

    for (int i = 0; i < s->particles.insert.n; i++) {
        const struct insertion_options *const o =
            &s->particles.insert.item[i].of;
        if (insertion_at_once(o) && o->start <= 0.0) sum += (double)o->count;
    }
    return sum;
}

static int check_prescribed_exist(const struct settings *s)
{
    const double there = number_at_start(s);

    for (int k = 0; k < s->particles.prescribed.n; k++) {
        const int id = prescribed_last(&s->particles.prescribed.item[k].of);
        if (there == 0.0)
            return settings_wrong(
                s, prescribed,
                "there is no particle %d: there is none at the start", id);
        if (id >= there)
            return settings_wrong(s, prescribed,
                                  "there is no particle %d: they are 0 to %.0f",
                                  id, there - 1.0);
    }
    return 0;
}

int case_surfaces_read(struct settings *s)
{
    for (int i = 0; i < s->particles.surfaces.n; i++) {
        struct surface_setup *const one = &s->particles.surfaces.item[i];
        if (one->of.shape->nearest == NULL && read_triangles(s, one) != 0)
            return 2;
        if (read_course(s, &one->course, &one->of.motion) != 0) return 2;
    }
    for (int i = 0; i < s->particles.prescribed.n; i++) {
        struct prescribed_setup *const one = &s->particles.prescribed.item[i];
        if (read_course(s, &one->course, &one->of.motion) != 0) return 2;
    }
    return check_prescribed_exist(s);
}

void case_surfaces_release(struct settings *s)
{
    for (int i = 0; i < s->particles.surfaces.n; i++) {
        owner_free(s->particles.surfaces.item[i].triangles);
        free(s->particles.surfaces.item[i].course.table);
    }
    for (int i = 0; i < s->particles.prescribed.n; i++)
        free(s->particles.prescribed.item[i].course.table);
}

/* How many there are, the walls of a mesh counted as one. */
static int surfaces_count(const struct settings *s)
{
    return s->particles.surfaces.n + (case_walls_count(s) > 0);
}

/* A surface under load is carried, from where it is at time 0. */
static void begin_load(struct surface *one)
{
    one->load.carrier = alloc_zeroed(1, sizeof *one->load.carrier);
    one->load.carrier->pose = motion_pose(&one->motion, 0.0);
    one->motion.carrier = one->load.carrier;
}

/* The surfaces of particles.surfaces, and the walls of the mesh. Their names
 * and triangles belong to the settings. */
static struct surface *create_surfaces(const struct settings *s)
{
    const int n = surfaces_count(s), listed = s->particles.surfaces.n;

    if (n == 0) return NULL;
    struct surface *const made = alloc_zeroed((size_t)n, sizeof *made);
    for (int i = 0; i < listed; i++)
        made[i] = s->particles.surfaces.item[i].of;
    for (int i = 0; i < listed; i++)
        if (made[i].load.speed > 0.0) begin_load(&made[i]);
    if (listed < n) made[listed] = case_walls_surface(s);
    return made;
}

/* The list owns the triangles of the walls, which are constant for dem. */
static void free_surfaces(struct surface *made, int n)
{
    struct triangles *own;

    if (n > 0 && made[n - 1].name == case_walls_name) {
        memcpy(&own, &made[n - 1].triangles, sizeof own);
        owner_free(own);
    }
    for (int i = 0; i < n; i++)
        free(made[i].load.carrier);
    free(made);
}

/* Those of particles.prescribed. */
static struct prescribed_particle *create_prescribed(const struct settings *s)
{
    const int n = s->particles.prescribed.n;

    if (n == 0) return NULL;
    struct prescribed_particle *const made =
        alloc_zeroed((size_t)n, sizeof *made);
    for (int i = 0; i < n; i++)
        made[i] = s->particles.prescribed.item[i].of;
    return made;
}

/* --- checks --------------------------------------------------------------- */

static int case_surfaces_check_name(const struct settings *s, int i)
{
    const struct surface_setup *const all = s->particles.surfaces.item;
    const char *const name = all[i].of.name;

    if (name[0] == '\0' || strpbrk(name, ",\"\n") != NULL)
        return settings_wrong(
            s, list, "the name \"%s\" is empty or has a comma or a quote in it",
            name);
    if (case_walls_count(s) > 0 && strcmp(name, case_walls_name) == 0)
        return settings_wrong(s, list, "the name %s is that of the walls",
                              name);
    for (int k = 0; k < i; k++)
        if (strcmp(name, all[k].of.name) == 0)
            return settings_wrong(s, list, "the name %s is given twice", name);
    return case_materials_check_name(s, list, all[i].material);
}

static int check_wear(const struct settings *s, int i)
{
    static const char *const keys[] = {"cutting", "archard"};
    const struct surface *const one = &s->particles.surfaces.item[i].of;

    for (int k = 0; k < 2 && !(one->wear.hardness > 0.0); k++)
        if (settings_item_has(s, list, i, keys[k]))
            return settings_wrong(s, list,
                                  "%s has %s, but no hardness [Pa] to wear by",
                                  one->name, keys[k]);
    return 0;
}

/* Each key belongs to the shapes that read it, and a direction has a length. */
static int case_surfaces_check_shape(const struct settings *s, int i)
{
    const struct surface_setup *const one = &s->particles.surfaces.item[i];
    const struct surface_shape *const shape = one->of.shape;
    const char *direction;

    for (int other = 0; surface_shapes[other] != NULL; other++)
        for (int t = 0; surface_shapes[other]->keys[t] != NULL; t++)
            for (const struct key *k = surface_shapes[other]->keys[t];
                 k->path != NULL; k++) {
                const char *const key = strrchr(k->path, '.') + 1;
                if (settings_item_has(s, list, i, key) && !reads(shape, key))
                    return settings_wrong(s, list, "%s is a %s: it has no %s",
                                          one->of.name, shape->name, key);
            }
    const double *const n = direction_of(one, &direction);
    if (n != NULL && !(vector_length(n) > 0.0))
        return settings_wrong(s, list, "the %s of %s has no direction",
                              direction, one->of.name);
    return 0;
}

/* A particle that crosses a periodic end would come back behind the surface. */
static int check_plane(const struct settings *s, const struct surface *one)
{
    static const char axes[] = "xyz";
    int periodic[3];

    if (one->shape != &surface_plane) return 0;
    case_mesh_periodic(s, periodic);
    for (int k = 0; k < 3; k++)
        if (periodic[k] && fabs(one->normal[k]) > 1e-9)
            return settings_wrong(
                s, list,
                "the plane %s is not parallel to %c, which is periodic: "
                "particles would come back behind it; make %c not periodic",
                one->name, axes[k], axes[k]);
    return 0;
}

static int check_motion(const struct settings *s, const char *of, int i,
                        const struct motion *m, const struct motion_course *c)
{
    if (c->repeat && c->file == NULL)
        return settings_wrong(
            s, of, "number %d: repeat is of a course, and there is none", i);
    if (m->until > 0.0 && m->until <= m->from)
        return settings_wrong(
            s, of, "number %d moves until %g s, which is not after from = %g s",
            i, m->until, m->from);
    if ((m->frequency > 0.0) != (vector_length(m->amplitude) > 0.0))
        return settings_wrong(
            s, of, "number %d: amplitude and frequency go together", i);
    return 0;
}

static int check_load(const struct settings *s, int i)
{
    const struct surface_setup *const one = &s->particles.surfaces.item[i];
    const struct motion *const m = &one->of.motion;
    const struct motion_load *const load = &one->of.load;

    if (one->has_load != (load->speed > 0.0))
        return settings_wrong(s, list, "%s: load and load_speed go together",
                              one->of.name);
    if (!one->has_load) return 0;
    if (!(vector_length(load->force) > 0.0))
        return settings_wrong(s, list,
                              "the load of %s has no direction: expected a "
                              "force [x, y, z] [N]",
                              one->of.name);
    if (motion_is_any(m) || one->course.file != NULL)
        return settings_wrong(s, list,
                              "%s has a load, which moves it alone: leave its "
                              "velocity, amplitude, spin or course out",
                              one->of.name);
    return 0;
}

static int check_driven(const struct settings *s, int i)
{
    const struct prescribed_setup *const all = s->particles.prescribed.item;
    const int id = all[i].of.id, last = prescribed_last(&all[i].of);

    if (all[i].has_last && all[i].of.last < id)
        return settings_wrong(s, prescribed,
                              "number %d: last = %d is before id = %d", i,
                              all[i].of.last, id);
    for (int k = 0; k < i; k++)
        if (id <= prescribed_last(&all[k].of) && all[k].of.id <= last)
            return settings_wrong(s, prescribed, "particle %d is given twice",
                                  id > all[k].of.id ? id : all[k].of.id);
    if (vector_length(all[i].of.motion.spin) > 0.0 && !all[i].has_centre)
        return settings_wrong(s, prescribed,
                              "particle %d has a spin: it needs a centre", id);
    return check_motion(s, prescribed, i, &all[i].of.motion, &all[i].course);
}

/* Attractions act between particles and the walls of the box only. */
static int check_others(const struct settings *s)
{
    const char *const pull = case_materials_attraction_of_box(s);

    if (s->particles.surfaces.n == 0 || pull == NULL) return 0;
    return settings_wrong(s, list,
                          "%s acts between particles and the box, not on "
                          "surfaces: leave one of them out",
                          pull);
}

int case_surfaces_check(struct settings *s)
{
    int code = check_others(s);

    for (int i = 0; i < s->particles.surfaces.n && code == 0; i++) {
        struct surface_setup *const one = &s->particles.surfaces.item[i];
        code = case_surfaces_check_name(s, i);
        if (code == 0) code = case_surfaces_check_shape(s, i);
        if (code == 0) code = check_wear(s, i);
        if (code != 0) return code;
        complete_surface(s, i, one);
        code = check_plane(s, &one->of);
        if (code == 0)
            code = check_motion(s, list, i, &one->of.motion, &one->course);
        if (code == 0) code = check_load(s, i);
    }
    for (int i = 0; i < s->particles.prescribed.n && code == 0; i++)
        code = check_driven(s, i);
    return code != 0 ? code : case_walls_check(s);
}

static const char unseen[] = "no walls for the fluid, which bodies and the "
                             "patches of a mesh from files are";

/* 1 if there are surfaces in a fluid, which it does not see. */
static int are_unseen(const struct settings *s)
{
    return s->has.fluid && s->particles.surfaces.n > 0;
}

void case_surfaces_dem_options(const struct settings *s, struct dem_options *o)
{
    case_walls_ends(s, o->lo, o->hi);
    o->n_surfaces = surfaces_count(s);
    o->n_prescribed = s->particles.prescribed.n;
}

/* --- what `winnow check` says of it --------------------------------------- */

/* In a step a wall should move by a small part of a diameter, as particles do.
 */
static void print_speed(double speed, const struct case_scales *k)
{
    text_line("highest speed", speed, "m/s", "of any point of them in the box");
    if (k->particles > 0 && speed > 0.0)
        text_line("its path in a particle step / d", speed * k->dem_dt / k->d,
                  "-", "of the smallest particle");
}

void case_surfaces_print(const struct settings *s, const struct case_scales *k)
{
    const int n = surfaces_count(s);
    double lo[3], hi[3], speed = 0.0;
    int triangles = 0;

    if (!s->has.particles) return; /* nothing meets them */
    struct surface *const made = create_surfaces(s);
    if (made == NULL) return;
    case_mesh_ends(s, lo, hi);
    for (int i = 0; i < n; i++) {
        const double reach = surface_reach(&made[i], lo, hi);
        if (made[i].triangles != NULL) triangles += made[i].triangles->n;
        speed = fmax(speed, motion_speed(&made[i].motion, reach));
    }
    puts("Walls besides the box");
    text_line("surfaces", n, "-", are_unseen(s) ? unseen : "");
    text_line("triangles", triangles, "-", "");
    print_speed(speed, k);
    free_surfaces(made, n);
}

/* --- in a simulation ------------------------------------------------------ */

static int case_surfaces_has_room(const void *state, const double x[3],
                                  double R)
{
    const struct simulation *const sim = state;
    return case_walls_has_room(sim->walls, x, R);
}

int case_surfaces_are_apart(const void *state, const double x[3], double R)
{
    const struct simulation *const sim = state;

    for (int k = 0; k < sim->n_surfaces; k++)
        if (surface_distance(&sim->surfaces[k], sim->t, x, R) < R) return 0;
    return sim->region.has_room == NULL ||
           sim->region.has_room(sim->region.state, x, R);
}

static int start_wrong(const void *state, const struct particles *ps)
{
    const struct simulation *const sim = state;
    return surface_start_wrong(ps, sim->surfaces, sim->n_surfaces, "");
}

static void take_surface_names(struct simulation *sim)
{
    sim->surface_names =
        alloc_zeroed((size_t)sim->n_surfaces, sizeof *sim->surface_names);
    for (int i = 0; i < sim->n_surfaces; i++)
        sim->surface_names[i] = sim->surfaces[i].name;
}

void case_surfaces_complete(const struct settings *s, struct simulation *sim,
                            struct dem_options *o)
{
    o->prescribed = sim->prescribed = create_prescribed(s);
    o->surfaces = sim->surfaces = create_surfaces(s);
    sim->n_surfaces = o->n_surfaces;
    take_surface_names(sim);
    sim->walls = case_walls_create(
        s, case_walls_count(s) > 0 ? &sim->surfaces[o->n_surfaces - 1] : NULL);
    o->surfaces_checksum = surfaces_checksum(o);
    sim->region = (struct placement_region){
        .has_room = sim->walls != NULL ? case_surfaces_has_room : NULL,
        .start_wrong = start_wrong,
        .state = sim};
}

void case_surfaces_free(struct simulation *sim)
{
    free_surfaces(sim->surfaces, sim->n_surfaces);
    free(sim->surface_names);
    free(sim->prescribed);
    case_walls_free(sim->walls);
}

/* Placed spheres may overlap a surface only where the case allows it. */
int case_surfaces_place(const struct settings *s, struct particles *ps,
                        const struct dem_options *o)
{
    char where[SETTINGS_PATH];

    if (strcmp(s->particles.overlaps, "allow") == 0) return 0;
    settings_where(s, list, where, sizeof where);
    return surface_start_wrong(ps, o->surfaces, o->n_surfaces, where) != 0 ? 2
                                                                           : 0;
}

void case_surfaces_tell_unseen(const struct settings *s)
{
    if (are_unseen(s) && !s->quiet) fprintf(stderr, "%s: %s\n", list, unseen);
}
