/* SPDX-License-Identifier: GPL-3.0-or-later */
/* poly.c -- reads a mesh in OpenFOAM's format: cells of any number of faces,
 * faces of any number of points, in any order.
 *
 * Cells and faces are put in order (poly_order.c). Cyclic patches become inner
 * faces with periodic links.
 */
#include "mesh/poly/poly.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/alloc.h"
#include "base/vector.h"

/* --- the mesh --------------------------------------------------------------
 */

static const struct poly_part *partner(const struct poly_raw *r,
                                       const struct poly_part *part)
{
    if (strcmp(part->type, "cyclic") != 0) return NULL;
    for (int i = 0; i < r->n_parts; i++)
        if (strcmp(r->part[i].name, part->other) == 0 &&
            r->part[i].n == part->n)
            return &r->part[i];
    return NULL;
}

/* P = the vector from the first of two cyclic patches to the second [m]. */
static void shift_of(const struct poly_raw *r, const struct poly_part *part,
                     double P[3])
{
    const int other = partner(r, part)->first;

    P[0] = P[1] = P[2] = 0.0;
    for (int j = 0; j < part->n; j++)
        for (int k = 0; k < 3; k++)
            P[k] += (r->middle[3 * (other + j) + k] -
                     r->middle[3 * (part->first + j) + k]) /
                    part->n;
}

/* The number, from 1, of the period that is P, negative if minus P; a new one
 * if there is none yet, 0 if there are too many. */
static int periodic_index_of(struct mesh *m, const double P[3])
{
    for (int i = 0; i < m->n_periods; i++)
        for (int sign = 1; sign > -2; sign -= 2) {
            double off = 0.0, size = 0.0;
            for (int k = 0; k < 3; k++) {
                off += fabs(P[k] - sign * m->period[i][k]);
                size += fabs(P[k]);
            }
            if (off <= 1e-6 * size) return sign * (i + 1);
        }
    if (m->n_periods == 3) return 0;
    memcpy(m->period[m->n_periods], P, 3 * sizeof *P);
    return ++m->n_periods;
}

/* Each face of a cyclic patch has its partner at one and the same shift, with
 * the same area; all shifts make three periods at most. */
static int find_periods(struct mesh *m, struct poly_raw *r, const char *dir)
{
    for (int i = 0; i < r->n_parts; i++) {
        struct poly_part *const part = &r->part[i];
        const struct poly_part *const other = partner(r, part);
        double P[3], worst = 0.0;
        if (other == NULL || other < part || part->n == 0) continue;
        shift_of(r, part, P);
        for (int j = 0; j < part->n; j++) {
            const int f = part->first + j, far = other->first + j;
            double off = 0.0, area = 0.0;
            for (int k = 0; k < 3; k++) {
                off +=
                    fabs(r->middle[3 * far + k] - r->middle[3 * f + k] - P[k]);
                area += fabs(r->area[3 * far + k] + r->area[3 * f + k]);
            }
            const double size = vector_length(&r->area[3 * f]);
            worst = fmax(worst, fmax(off / sqrt(size), area / size));
        }
        part->periodic_index = worst < 1e-4 ? periodic_index_of(m, P) : 0;
        r->part[other - r->part].periodic_index = -part->periodic_index;
        if (part->periodic_index != 0) continue;
        fprintf(stderr,
                "winnow: %s/boundary:%d: the cyclic patches %s and %s are not "
                "the same faces moved by one shift (off by %.2g of a face); "
                "only that is read, no rotation\n",
                dir, part->line, part->name, other->name, worst);
        return 1;
    }
    return 0;
}

/* Sets one face of the mesh from face f of the files. For an inner face `far`
 * is the same face on the side of the neighbour: f itself, or its partner,
 * which is a period away. */
static void set_inner(struct mesh *m, const struct poly_raw *r, int to, int f,
                      int far, int crossing)
{
    const int a = r->owner[f];
    const int b = far == f ? r->neighbour[f] : r->owner[far];
    const int turned = r->number[a] > r->number[b];
    double d[3], here[3], there[3];

    for (int k = 0; k < 3; k++) {
        here[k] = r->middle[3 * f + k] - r->centre[3 * a + k];
        there[k] = r->centre[3 * b + k] - r->middle[3 * far + k];
        d[k] = here[k] + there[k];
    }
    const double *const S = &r->area[3 * f];
    const double first = fabs(vector_dot(S, here)),
                 second = fabs(vector_dot(S, there));
    const double w = second / (first + second);

    m->owner[to] = r->number[turned ? b : a];
    m->neighbour[to] = r->number[turned ? a : b];
    m->w[to] = turned ? 1.0 - w : w;
    if (m->periodic_index != NULL)
        m->periodic_index[to] = turned ? -crossing : crossing;
    for (int k = 0; k < 3; k++) {
        m->S[3 * to + k] = turned ? -S[k] : S[k];
        m->d[3 * to + k] = turned ? -d[k] : d[k];
        m->face_centre[3 * to + k] = r->middle[3 * (turned ? far : f) + k];
    }
}

static void set_outer(struct mesh *m, const struct poly_raw *r, int to, int f)
{
    m->owner[to] = r->number[r->owner[f]];
    for (int k = 0; k < 3; k++) {
        m->S[3 * to + k] = r->area[3 * f + k];
        m->face_centre[3 * to + k] = r->middle[3 * f + k];
        m->d[3 * to + k] =
            r->middle[3 * f + k] - r->centre[3 * r->owner[f] + k];
    }
}

/* An inner face of the mesh: two faces of the files, or one of them twice. */
struct join {
    int f, far, crossing;
};

/* Lists the inner faces of the files and the cyclic pairs; returns their
 * number. With NULL it only counts. A cell that is its own neighbour across a
 * period has no face there: the flux through it would enter the same cell. */
static int list_inner(const struct poly_raw *r, struct join *list)
{
    int n = 0;

    for (; n < r->n_inner; n++)
        if (list != NULL) list[n] = (struct join){n, n, 0};
    for (int i = 0; i < r->n_parts; i++) {
        const struct poly_part *const part = &r->part[i];
        const struct poly_part *const other = partner(r, part);
        if (other == NULL || other < part) continue;
        for (int j = 0; j < part->n; j++) {
            const struct join one = {part->first + j, other->first + j,
                                     part->periodic_index};
            if (r->owner[one.f] == r->owner[one.far]) continue;
            if (list != NULL) list[n] = one;
            n++;
        }
    }
    return n;
}

static void set_inner_faces(struct mesh *m, const struct poly_raw *r)
{
    const int n = m->n_internal;
    struct join *const list = alloc_zeroed((size_t)n, sizeof *list);
    int *const a = alloc_ints(n), *const b = alloc_ints(n), in_rows;

    list_inner(r, list);
    for (int i = 0; i < n; i++) {
        const int f = list[i].f, far = list[i].far;
        a[i] = r->number[r->owner[f]];
        b[i] = r->number[far == f ? r->neighbour[f] : r->owner[far]];
    }
    int *const order = poly_face_order(n, m->n_cells, a, b, &in_rows);
    for (int i = 0; i < n; i++) {
        const struct join *const one = &list[order[i]];
        set_inner(m, r, i, one->f, one->far, one->crossing);
    }
    free(list);
    free(a);
    free(b);
    free(order);
}

static void set_patches(struct mesh *m, const struct poly_raw *r)
{
    int f = m->n_internal, n = 0;
    const int *file = m->shape->boundary;

    for (int i = 0; i < r->n_parts; i++) {
        const struct poly_part *const part = &r->part[i];
        if (partner(r, part) != NULL) continue;
        struct patch *const patch = &m->patches[n++];
        memcpy(patch->name, part->name, sizeof patch->name);
        patch->is_symmetry = strncmp(part->type, "symmetry", 8) == 0 ||
                             strcmp(part->type, "empty") == 0;
        patch->first = f;
        patch->n = part->n;
        for (int j = 0; j < part->n; j++)
            set_outer(m, r, f++, *file++);
    }
}

static void set_cells(struct mesh *m, const struct poly_raw *r)
{
    for (int c = 0; c < r->n_cells; c++) {
        const int to = r->number[c];
        m->V[to] = r->V[c];
        memcpy(&m->centre[3 * to], &r->centre[3 * c], 3 * sizeof *m->centre);
    }
}

static void set_bounds(struct mesh *m, const struct poly_raw *r)
{
    for (int k = 0; k < 3; k++) {
        m->lo[k] = m->hi[k] = r->point[k];
        for (int i = 1; i < r->n_points; i++) {
            m->lo[k] = fmin(m->lo[k], r->point[3 * i + k]);
            m->hi[k] = fmax(m->hi[k], r->point[3 * i + k]);
        }
    }
}

/* Builds the mesh m, whose periods are known. */
static void poly_fill(struct mesh *m, struct poly_raw *r)
{
    int joined = 0;

    for (int i = 0; i < r->n_parts; i++)
        if (partner(r, &r->part[i]) != NULL)
            joined += r->part[i].n;
        else
            m->n_patches++;
    m->n_cells = r->n_cells;
    m->n_internal = list_inner(r, NULL);
    m->n_faces = m->n_internal + r->n_faces - r->n_inner - joined;
    poly_number_cells(r);
    mesh_allocate(m);
    m->face_centre = owner_doubles(m, 3 * m->n_faces);
    if (m->n_periods > 0) m->periodic_index = owner_ints(m, m->n_internal);
    set_cells(m, r);
    set_inner_faces(m, r);
    set_bounds(m, r);
    const double warp = poly_raw_warp(r);
    m->shape = poly_shape_create(m, r);
    set_patches(m, r);
    mesh_collect_faces(m);
    locate_create(m, 2.0 * warp);
}

/* Checks that each cyclic patch has a partner, and each boundary face one
 * patch; 0 if so, else 1 after a message. */
static int poly_check_parts(const struct poly_raw *r, const char *dir)
{
    int next = r->n_inner;

    for (int i = 0; i < r->n_parts; i++) {
        const struct poly_part *const part = &r->part[i];
        const struct poly_part *const other = partner(r, part);
        if (part->first != next) {
            fprintf(stderr,
                    "winnow: %s/boundary:%d: patch %s begins with face %d, "
                    "expected %d, where the patch before it ends\n",
                    dir, part->line, part->name, part->first, next);
            return 1;
        }
        next = part->first + part->n;
        if (strcmp(part->type, "cyclic") != 0 ||
            (other != NULL && partner(r, other) == part))
            continue;
        fprintf(stderr,
                "winnow: %s/boundary:%d: patch %s is cyclic, and its "
                "neighbourPatch %s does not exist, is not its partner or has "
                "other faces\n",
                dir, part->line, part->name, part->other);
        return 1;
    }
    if (next == r->n_faces) return 0;
    fprintf(stderr,
            "winnow: %s/boundary: the patches cover %d of %d boundary faces\n",
            dir, next - r->n_inner, r->n_faces - r->n_inner);
    return 1;
}

struct mesh *poly_build(struct poly_raw *r, const char *dir)
{
    struct mesh *m = owner_create(sizeof *m);

    if (!poly_check_parts(r, dir) && !poly_raw_measure(r, dir) &&
        !find_periods(m, r, dir)) {
        poly_fill(m, r);
        return m;
    }
    mesh_free(m);
    return NULL;
}

struct mesh *poly_read(const char *dir, struct inputs **files)
{
    struct poly_raw r = {.files = files};
    char folder[POLY_FOLDER];
    struct mesh *m = NULL;

    poly_folder(dir, folder);
    if (!poly_raw_read(&r, folder)) m = poly_build(&r, folder);
    poly_raw_release(&r);
    return m;
}

/* Where the files of a mesh are, and what its patches are called. */

int poly_folder(const char *dir, char folder[POLY_FOLDER])
{
    static const char *const within[] = {"", "/polyMesh", "/constant/polyMesh"};

    for (int i = 0; i < 6; i++) {
        char file[POLY_FOLDER + 16];
        snprintf(folder, POLY_FOLDER, "%s%s", dir, within[i / 2]);
        snprintf(file, sizeof file, "%s/boundary%s", folder,
                 i % 2 ? ".gz" : "");
        if (access(file, R_OK) == 0) return 1;
    }
    snprintf(folder, POLY_FOLDER, "%s", dir);
    return 0;
}

int poly_is(const char *dir)
{
    char folder[POLY_FOLDER];
    return poly_folder(dir, folder);
}

int poly_patches(const char *dir, struct inputs **files,
                 struct mesh_patch_name **list)
{
    struct poly_raw r = {.files = files};
    char folder[POLY_FOLDER];
    int n = -1;

    *list = NULL;
    poly_folder(dir, folder);
    if (!poly_raw_read_parts(&r, folder)) {
        n = 0;
        *list = alloc_zeroed((size_t)r.n_parts + 1, sizeof **list);
        for (int i = 0; i < r.n_parts; i++)
            if (strcmp(r.part[i].type, "cyclic") != 0)
                memcpy((*list)[n++].name, r.part[i].name, sizeof(*list)->name);
    }
    poly_raw_release(&r);
    return n;
}

/* The corners of a mesh, kept for files, pictures and walls. */

/* Lists the polygons of each cell, in the order of the files. */
static void list_polygons(struct mesh *m, const struct poly_raw *r,
                          struct mesh_shape *s)
{
    int *const used = alloc_ints(r->n_cells);

    s->cell_start = owner_ints(m, r->n_cells + 1);
    s->polygon = owner_ints(m, r->n_faces + r->n_inner);
    s->turned = owner_ints(m, r->n_faces + r->n_inner);
    for (int f = 0; f < r->n_faces; f++) {
        s->cell_start[r->number[r->owner[f]] + 1]++;
        if (f < r->n_inner) s->cell_start[r->number[r->neighbour[f]] + 1]++;
    }
    for (int c = 0; c < r->n_cells; c++)
        s->cell_start[c + 1] += s->cell_start[c];
    for (int f = 0; f < r->n_faces; f++)
        for (int side = 0; side < 1 + (f < r->n_inner); side++) {
            const int c = r->number[side == 0 ? r->owner[f] : r->neighbour[f]];
            const int at = s->cell_start[c] + used[c]++;
            s->turned[at] = side == 0 ? 1 : -1;
            s->polygon[at] = f;
        }
    free(used);
}

struct mesh_shape *poly_shape_create(struct mesh *m, struct poly_raw *r)
{
    struct mesh_shape *const s = owner_zeroed(m, 1, sizeof *s);

    s->n_points = r->n_points;
    s->n_polygons = r->n_faces;
    list_polygons(m, r, s);
    s->boundary = owner_take(m, poly_boundary_order(r));
    s->point = owner_take(m, r->point);
    s->start = owner_take(m, r->start);
    s->corner = owner_take(m, r->corner);
    r->point = NULL;
    r->start = r->corner = NULL;
    return s;
}
