/* SPDX-License-Identifier: GPL-3.0-or-later */
/* poly.c -- reads a mesh in OpenFOAM's format: cells of any number of faces,
 * faces of any number of points, in any order.
 *
 * What the files number is numbered anew, so that cells that touch have numbers
 * that are close: memory then comes in the order in which it is used. Ends of
 * type cyclic become inner faces whose links go round.
 */
#include "mesh/poly.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "mesh/poly_raw.h"

/* --- order ---------------------------------------------------------------- */

/* The cells beside each, one row a cell. */
static void neighbours_of(const struct poly_raw *r, int *start, int *beside)
{
    int *const used = alloc_ints(r->n_cells);

    for (int f = 0; f < r->n_inner; f++) {
        start[r->owner[f] + 1]++;
        start[r->neighbour[f] + 1]++;
    }
    for (int c = 0; c < r->n_cells; c++)
        start[c + 1] += start[c];
    for (int f = 0; f < r->n_inner; f++) {
        const int o = r->owner[f], n = r->neighbour[f];
        beside[start[o] + used[o]++] = n;
        beside[start[n] + used[n]++] = o;
    }
    free(used);
}

/* Cuthill and McKee: from one cell in waves over its neighbours; where cells
 * remain, from the first of these. */
static void number_cells(struct poly_raw *r)
{
    int *const start = alloc_ints(r->n_cells + 1);
    int *const beside = alloc_ints(2 * r->n_inner);
    int *const queue = alloc_ints(r->n_cells);
    int n = 0, done = 0;

    neighbours_of(r, start, beside);
    r->number = alloc_ints(r->n_cells);
    for (int c = 0; c < r->n_cells; c++)
        r->number[c] = -1;
    for (int first = 0; first < r->n_cells; first++) {
        if (r->number[first] >= 0) continue;
        queue[n] = first;
        r->number[first] = n++;
        for (; done < n; done++)
            for (int e = start[queue[done]]; e < start[queue[done] + 1]; e++) {
                const int c = beside[e];
                if (r->number[c] >= 0) continue;
                queue[n] = c;
                r->number[c] = n++;
            }
    }
    free(start);
    free(beside);
    free(queue);
}

/* --- the mesh --------------------------------------------------------------
 */

static double dot(const double *a, const double *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* One face of the mesh from face f of the files; for the inner ones `far` is
 * the face through which the neighbour sees it: itself, or its partner. */
static void set_inner(struct mesh *m, const struct poly_raw *r, int to, int f,
                      int far)
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
    const double first = fabs(dot(S, here)), second = fabs(dot(S, there));
    const double w = second / (first + second);

    m->owner[to] = r->number[turned ? b : a];
    m->neighbour[to] = r->number[turned ? a : b];
    m->w[to] = turned ? 1.0 - w : w;
    for (int k = 0; k < 3; k++) {
        m->S[3 * to + k] = turned ? -S[k] : S[k];
        m->d[3 * to + k] = turned ? -d[k] : d[k];
        m->middle[3 * to + k] = r->middle[3 * (turned ? far : f) + k];
    }
}

static void set_outer(struct mesh *m, const struct poly_raw *r, int to, int f)
{
    m->owner[to] = r->number[r->owner[f]];
    for (int k = 0; k < 3; k++) {
        m->S[3 * to + k] = r->area[3 * f + k];
        m->middle[3 * to + k] = r->middle[3 * f + k];
        m->d[3 * to + k] =
            r->middle[3 * f + k] - r->centre[3 * r->owner[f] + k];
    }
}

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

/* The inner faces of the files and the cyclic pairs, in the order of their
 * owners' new numbers, by counting. */
static void set_inner_faces(struct mesh *m, const struct poly_raw *r)
{
    int *const f = alloc_ints(m->n_internal), *const far =
                                                  alloc_ints(m->n_internal);
    int *const next = alloc_ints(m->n_cells + 1);
    int n = 0;

    for (; n < r->n_inner; n++)
        f[n] = far[n] = n;
    for (int i = 0; i < r->n_parts; i++) {
        const struct poly_part *const other = partner(r, &r->part[i]);
        if (other == NULL || other < &r->part[i]) continue;
        for (int j = 0; j < r->part[i].n; j++, n++) {
            f[n] = r->part[i].first + j;
            far[n] = other->first + j;
        }
    }
    for (int pass = 0; pass < 2; pass++)
        for (int i = 0; i < n; i++) {
            const int a = r->number[r->owner[f[i]]];
            const int b = r->number[far[i] == f[i] ? r->neighbour[f[i]]
                                                   : r->owner[far[i]]];
            const int o = a < b ? a : b;
            if (pass == 0)
                next[o + 1]++;
            else
                set_inner(m, r, next[o]++, f[i], far[i]);
            if (pass == 0 && i == n - 1)
                for (int c = 0; c < m->n_cells; c++)
                    next[c + 1] += next[c];
        }
    free(f);
    free(far);
    free(next);
}

static void set_patches(struct mesh *m, const struct poly_raw *r)
{
    int f = m->n_internal, n = 0;

    for (int i = 0; i < r->n_parts; i++) {
        const struct poly_part *const part = &r->part[i];
        if (partner(r, part) != NULL) continue;
        struct patch *const patch = &m->patches[n++];
        memcpy(patch->name, part->name, sizeof patch->name);
        patch->first = f;
        patch->n = part->n;
        for (int j = 0; j < part->n; j++)
            set_outer(m, r, f++, part->first + j);
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

static struct mesh *build(const struct poly_raw *r)
{
    struct mesh *const m = alloc_zeroed(1, sizeof *m);
    int joined = 0;

    for (int i = 0; i < r->n_parts; i++)
        if (partner(r, &r->part[i]) != NULL)
            joined += r->part[i].n;
        else
            m->n_patches++;
    m->n_cells = r->n_cells;
    m->n_internal = r->n_inner + joined / 2;
    m->n_faces = r->n_faces - joined / 2;
    mesh_allocate(m);
    m->middle = alloc_doubles(3 * m->n_faces);
    set_cells(m, r);
    set_inner_faces(m, r);
    set_patches(m, r);
    mesh_collect_faces(m);
    return m;
}

/* Cyclic patches must have a partner, and every face a patch. */
static int check_parts(const struct poly_raw *r, const char *dir)
{
    int covered = r->n_inner;

    for (int i = 0; i < r->n_parts; i++) {
        const struct poly_part *const part = &r->part[i];
        covered += part->n;
        if (strcmp(part->type, "cyclic") != 0 || partner(r, part) != NULL)
            continue;
        fprintf(stderr,
                "winnow: %s/boundary: patch %s is cyclic, and its "
                "neighbourPatch %s does not exist or has other faces\n",
                dir, part->name, part->other);
        return 1;
    }
    if (covered == r->n_faces) return 0;
    fprintf(stderr,
            "winnow: %s/boundary: the patches cover %d of %d boundary faces\n",
            dir, covered - r->n_inner, r->n_faces - r->n_inner);
    return 1;
}

struct mesh *poly_read(const char *dir)
{
    struct poly_raw r = {0};
    struct mesh *m = NULL;

    if (!poly_raw_read(&r, dir) && !check_parts(&r, dir) &&
        !poly_raw_measure(&r, dir)) {
        number_cells(&r);
        m = build(&r);
    }
    poly_raw_release(&r);
    return m;
}
