/* SPDX-License-Identifier: GPL-3.0-or-later */
/* case_walls.c -- the walls for particles in a mesh that is not a box. */
#include "case/particles/case_surfaces.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/vector.h"
#include "dem/surfaces/surface.h"
#include "case/particles/case_materials.h"
#include "case/case_mesh.h"

const char case_walls_name[] = "mesh";

static const double flat = 1e-9;   /* [-] of the extent: in one plane */
static const double planar = 1e-6; /* [-] of a face: no corner off its plane */

/* The corners of boundary face b (counted from the first of them). */
static int corners_of(const struct mesh *m, int b, const int **corner)
{
    const struct mesh_shape *const s = m->shape;
    const int p = s->boundary[b];

    *corner = &s->corner[s->start[p]];
    return s->start[p + 1] - s->start[p];
}

/* The side of the box that boundary face b lies in, 2 k + upper; or -1. */
static int case_walls_side_of(const struct mesh *m, int b)
{
    const int *corner;
    const int n = corners_of(m, b, &corner);

    for (int side = 0; side < 6; side++) {
        const int k = side / 2;
        const double end = side % 2 ? m->hi[k] : m->lo[k];
        int in = 1;
        for (int i = 0; i < n && in; i++)
            in = fabs(m->shape->point[3 * corner[i] + k] - end) <=
                 flat * (m->hi[k] - m->lo[k]);
        if (in) return side;
    }
    return -1;
}

/* --- triangles ------------------------------------------------------------ */

/* A triangle is split off the polygon at each corner but two; where it has more
 * than four corners, or they are not in a plane, at each edge to the middle. */
static int triangles_of(const struct mesh *m, int b, double (*made)[3][3])
{
    const double *const S = mesh_S(m, m->n_internal + b);
    const double *const x = &m->face_centre[3 * (m->n_internal + b)];
    const double size = sqrt(vector_length(S));
    const int *corner;
    const int n = corners_of(m, b, &corner);
    int whole = n <= 4;

    for (int i = 0; i < n; i++) {
        double d[3];
        vector_between(&m->shape->point[3 * corner[i]], x, d);
        whole &= fabs(vector_dot(d, S)) <= planar * size * vector_length(S);
    }
    const int count = whole ? n - 2 : n;
    for (int i = 0; i < count && made != NULL; i++) {
        const int next = corner[(i + 1 + whole) % n];
        const double *const third = whole ? &m->shape->point[3 * corner[0]] : x;
        memcpy(made[i][0], third, 3 * sizeof(double));
        memcpy(made[i][1], &m->shape->point[3 * corner[i + whole]],
               3 * sizeof(double));
        memcpy(made[i][2], &m->shape->point[3 * next], 3 * sizeof(double));
    }
    return count;
}

/* All of them, or with NULL only how many. */
static int all_triangles(const struct mesh *m, double (*made)[3][3])
{
    int n = 0;

    for (int b = 0; b < m->n_faces - m->n_internal; b++)
        if (case_walls_side_of(m, b) < 0)
            n += triangles_of(m, b, made != NULL ? &made[n] : NULL);
    return n;
}

int case_walls_count(const struct settings *s)
{
    const struct mesh *const m = s->poly;
    return m != NULL ? all_triangles(m, NULL) : 0;
}

struct surface case_walls_surface(const struct settings *s)
{
    const struct mesh *const m = s->poly;
    const int n = all_triangles(m, NULL);
    double(*const corner)[3][3] = alloc_zeroed((size_t)n, sizeof *corner);
    struct surface made = {.name = case_walls_name, .shape = &surface_stl};

    all_triangles(m, corner);
    made.triangles = triangles_create(n, corner);
    made.material = case_materials_of_wall(s, s->particles.walls);
    free(corner);
    return made;
}

/* --- the box -------------------------------------------------------------- */

void case_walls_ends(const struct settings *s, double lo[3], double hi[3])
{
    const struct mesh *const m = s->poly;
    int has[6] = {0}, periodic[3];

    case_mesh_ends(s, lo, hi);
    case_mesh_periodic(s, periodic);
    if (m == NULL) return;
    for (int b = 0; b < m->n_faces - m->n_internal; b++)
        if (case_walls_side_of(m, b) >= 0) has[case_walls_side_of(m, b)] = 1;
    for (int k = 0; k < 3; k++) {
        /* farther than any sphere that the mesh holds can reach */
        const double away = 0.5 * (hi[k] - lo[k]);
        if (periodic[k]) continue;
        if (!has[2 * k]) lo[k] -= away;
        if (!has[2 * k + 1]) hi[k] += away;
    }
}

/* For particles periodic directions are those of the axes. */
static int check_periods(const struct settings *s)
{
    const struct mesh *const m = s->poly;

    for (int i = 0; i < m->n_periods; i++) {
        const double *const P = m->period[i];
        int along = 0;
        for (int k = 0; k < 3; k++)
            along |= fabs(P[k]) >= (1.0 - 1e-9) * vector_length(P);
        if (along) continue;
        return settings_wrong(s, "particles",
                              "for particles a period must be along x, y or z; "
                              "this mesh has one along [%g, %g, %g] m",
                              P[0], P[1], P[2]);
    }
    return 0;
}

int case_walls_check(const struct settings *s)
{
    const char *const pull = case_materials_attraction_of_box(s);

    if (s->poly == NULL) return 0;
    if (pull == NULL || case_walls_count(s) == 0) return check_periods(s);
    return settings_wrong(s, pull,
                          "it acts between particles and the walls of a box, "
                          "not on the walls of this mesh");
}

/* --- room ----------------------------------------------------------------- */

struct case_walls {
    struct mesh *mesh;
    const struct surface *walls;
    double lo[3], hi[3]; /* [m] of the mesh */
    int periodic[3];
};

struct case_walls *case_walls_create(const struct settings *s,
                                     const struct surface *walls)
{
    if (s->poly == NULL) return NULL;
    struct case_walls *const w = alloc_zeroed(1, sizeof *w);

    w->mesh = case_mesh_create(s);
    w->walls = walls;
    case_mesh_ends(s, w->lo, w->hi);
    case_mesh_periodic(s, w->periodic);
    return w;
}

void case_walls_free(struct case_walls *w)
{
    if (w == NULL) return;
    mesh_free(w->mesh);
    free(w);
}

int case_walls_has_room(const struct case_walls *w, const double x[3], double R)
{
    double offset[3];

    for (int k = 0; k < 3; k++)
        if (!w->periodic[k] && (x[k] < w->lo[k] + R || x[k] > w->hi[k] - R))
            return 0;
    if (mesh_cell_and_offset(w->mesh, x, offset) < 0) return 0;
    return w->walls == NULL || surface_distance(w->walls, 0.0, x, R) >= R;
}
