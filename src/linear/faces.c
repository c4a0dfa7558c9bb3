/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "linear/faces.h"

#include <stddef.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "linear/reduce.h"

int faces_next(const struct faces *f, int first, int last, struct face_piece *p)
{
    if (f->pieces != NULL)
        return faces_next_of_owners(f->pieces, first, last, p) &&
               p->face < f->n_inner;
    if (p->n > 0 || first >= last) return 0;
    *p = (struct face_piece){.face = first,
                             .n = last - first,
                             .owner = f->owner + first,
                             .neighbour = f->neighbour + first};
    return 1;
}

static const double *faces_S(const struct faces *fs, int f)
{
    return fs->S + 3L * (fs->S_at != NULL ? fs->S_at[f] : f);
}

static void sum_by_lists(const struct faces *fs, int first, int last, int n,
                         const double *a, double sign, const double *b,
                         double *sum)
{
    for (int c = first; c < last; c++) {
        double x = 0.0, y = 0.0, z = 0.0;

        for (int i = fs->cell_start[c]; i < fs->cell_start[c + 1]; i++) {
            const int f = fs->cell_face[i];
            if (f >= n) continue;
            const double part = fs->out[i] > 0 ? a[f] : sign * b[f];
            const double *const S = faces_S(fs, f);
            x += part * S[0];
            y += part * S[1];
            z += part * S[2];
        }
        sum[3 * c] = x;
        sum[3 * c + 1] = y;
        sum[3 * c + 2] = z;
    }
}

static void sum_by_pieces(const struct faces *fs, int first, int last, int n,
                          const double *a, double sign, const double *b,
                          double *sum)
{
    struct face_piece p = {0};

    for (int i = 3 * first; i < 3 * last; i++)
        sum[i] = 0.0;
    while (faces_next_of_cells(fs->pieces, first, last, &p) && p.face < n) {
        const int leaves = p.out > 0.0;

        const double factor = leaves ? 1.0 : sign;
        const double *const at = (leaves ? a : b) + p.face;
        double *const to = sum + 3L * p.cell;

        if (fs->S_at == NULL)
            vec3_add(p.n, factor, at, fs->S + 3L * p.face, to);
        for (int i = 0; i < 3 * p.n && fs->S_at != NULL; i++)
            to[i] += factor * at[i / 3] * faces_S(fs, p.face + i / 3)[i % 3];
    }
}

/* The same sums of at most PARALLEL_RANGES_BLOCK cells, each component in a row
 * of its own. */
static void sum_aligned(const struct faces *fs, int first, int last, int n,
                        const double *a, double sign, const double *b,
                        double *sum)
{
    double part[3][PARALLEL_RANGES_BLOCK] = {{0.0}};
    struct face_piece p = {0};

    while (faces_next_of_cells(fs->pieces, first, last, &p) && p.face < n) {
        const int leaves = p.out > 0.0;
        const double *restrict at = (leaves ? a : b) + p.face;
        const double *restrict area = fs->area + p.face;
        const double factor = leaves ? 1.0 : sign;
        double *restrict to = part[p.axis] + (p.cell - first);

        for (int j = 0; j < p.n; j++)
            to[j] += factor * at[j] * area[j];
    }
    for (int c = first; c < last; c++)
        for (int k = 0; k < 3; k++)
            sum[3L * c + k] = part[k][c - first];
}

void faces_sum_vectors(const struct faces *f, int first, int last, int n,
                       const double *a, double sign, const double *b,
                       double *sum)
{
    if (f->pieces == NULL)
        sum_by_lists(f, first, last, n, a, sign, b, sum);
    else if (!faces_aligned(f))
        sum_by_pieces(f, first, last, n, a, sign, b, sum);
    else
        for (int end; first < last; first = end) {
            end = last - first < PARALLEL_RANGES_BLOCK
                      ? last
                      : first + PARALLEL_RANGES_BLOCK;
            sum_aligned(f, first, end, n, a, sign, b, sum);
        }
}

/* --- contiguous ranges of faces between contiguous ranges of cells
 *
 * Between a row of cells and the next row of a box, face f + 1 joins the cells
 * after those that face f joins. A loop over such a range needs no list of
 * owners and neighbours: it reads and writes contiguous memory, eight numbers
 * at a time (measured: three to five times faster). Where most ranges have one
 * face, as in a mesh with shuffled numbers, loops use the lists.
 */

enum {
    GROUPS = 16,   /* at most */
    MIN_LENGTH = 8 /* faces in a range, on average */
};

struct contiguous_range {
    int face, owner, n; /* the first face, its owner, how many */
    int axis;           /* [-] of their area vectors, or 0 */
};

struct face_pieces {
    int n_groups;
    struct {
        int first,
            end; /* its contiguous ranges, with ascending faces and owners */
        int distance; /* from owner to neighbour */
        int boundary; /* 1: no neighbours */
    } group[GROUPS];
    struct contiguous_range *range;
};

/* What two faces must share to lie in the same group, and in the same range the
 * axis too. */
struct kind {
    int boundary, distance, axis;
};

/* The axis of the area vector of face f, or -1. */
static int axis_of(const struct faces *fs, int f)
{
    const double *const S = faces_S(fs, f);

    for (int k = 0; k < 3; k++)
        if (S[(k + 1) % 3] == 0.0 && S[(k + 2) % 3] == 0.0) return k;
    return -1;
}

static struct kind kind_of(const struct faces *fs, int f, int aligned)
{
    const int boundary = f >= fs->n_inner;

    return (struct kind){boundary,
                         boundary ? 0 : fs->neighbour[f] - fs->owner[f],
                         aligned ? axis_of(fs, f) : 0};
}

/* Begins a group with the next run; 0 if there are too many. */
static int begin_group(struct face_pieces *r, struct kind k, int next)
{
    if (r->n_groups == GROUPS) return 0;
    r->group[r->n_groups].first = next;
    r->group[r->n_groups].distance = k.distance;
    r->group[r->n_groups].boundary = k.boundary;
    r->n_groups++;
    return 1;
}

/* Adds face f after those before it: one more of the last run, or the first of
 * a new one, perhaps of a new group. Returns 0 if there are too many groups. */
static int faces_add_face(struct face_pieces *r, int *n_runs, int f, int owner,
                          struct kind k)
{
    struct contiguous_range *const last =
        *n_runs > 0 ? &r->range[*n_runs - 1] : NULL;
    const int g = r->n_groups - 1;
    const int same = g >= 0 && r->group[g].distance == k.distance &&
                     r->group[g].boundary == k.boundary;

    if (same && owner == last->owner + last->n && k.axis == last->axis) {
        last->n++;
        return 1;
    }
    if (!(same && owner >= last->owner + last->n) &&
        !begin_group(r, k, *n_runs))
        return 0;
    r->range[(*n_runs)++] = (struct contiguous_range){f, owner, 1, k.axis};
    r->group[r->n_groups - 1].end = *n_runs;
    return 1;
}

/* The first range of [begin, end) that reaches beyond a cell. It is where equal
 * ranges have it, or it is searched. */
static int first_beyond(const struct contiguous_range *run, int begin, int end,
                        int at)
{
    const int o = run[begin].owner, span = run[end - 1].owner - o;
    const int way = at < o ? 0 : at - o < span ? at - o : span;
    const int guess =
        begin + (int)((long)way * (end - 1 - begin) / (span > 0 ? span : 1));

    if (run[guess].owner <= at) begin = guess;
    if (run[begin].owner + run[begin].n > at) end = begin;
    while (begin < end) {
        const int middle = begin + (end - begin) / 2;

        if (run[middle].owner + run[middle].n > at)
            end = middle;
        else
            begin = middle + 1;
    }
    return begin;
}

/* The part of the range whose owners lie within [first, last). */
static void faces_cut(const struct contiguous_range *run, int first, int last,
                      struct face_piece *p)
{
    const int skip = first > run->owner ? first - run->owner : 0;
    const int end = run->owner + run->n < last ? run->owner + run->n : last;

    p->face = run->face + skip;
    p->cell = run->owner + skip;
    p->n = end - p->cell;
    p->axis = run->axis;
}

/* The next piece of group g whose owners lie within [first, last); 0 if there
 * is none. p->range is the range of the next piece, 0 until it is known. */
static int next_of_group(const struct face_pieces *r, int g, int first,
                         int last, struct face_piece *p)
{
    if (p->range == 0)
        p->range =
            first_beyond(r->range, r->group[g].first, r->group[g].end, first);
    if (p->range == r->group[g].end || r->range[p->range].owner >= last)
        return 0;
    faces_cut(&r->range[p->range++], first, last, p);
    return 1;
}

/* p->group counts the sides of the groups: 2 g from the owner, 2 g + 1 from the
 * neighbour. */
int faces_next_of_cells(const struct face_pieces *r, int first, int last,
                        struct face_piece *p)
{
    for (; p->group < 2 * r->n_groups; p->group++, p->range = 0) {
        const int g = p->group / 2, inward = p->group % 2;
        const int d = r->group[g].distance, shift = inward ? d : 0;

        if (inward && r->group[g].boundary) continue;
        if (!next_of_group(r, g, first - shift, last - shift, p)) continue;
        p->cell += shift;
        p->other = inward ? p->cell - d : p->cell + d;
        p->out = inward ? -1.0 : 1.0;
        return 1;
    }
    return 0;
}

int faces_next_of_owners(const struct face_pieces *r, int first, int last,
                         struct face_piece *p)
{
    for (; p->group < r->n_groups; p->group++, p->range = 0) {
        if (!next_of_group(r, p->group, first, last, p)) continue;
        p->other = p->cell + r->group[p->group].distance;
        p->out = 1.0;
        return 1;
    }
    return 0;
}

/* aligned: 1 if each face is normal to an axis, and each range has one. */
static struct face_pieces *find_pieces(const struct faces *fs, int aligned)
{
    struct face_pieces *const r = owner_create(sizeof *r);
    int n_runs = 0, fits = 1;

    r->range = alloc_zeroed((size_t)fs->n, sizeof *r->range);
    for (int f = 0; f < fs->n && fits; f++)
        fits = faces_add_face(r, &n_runs, f, fs->owner[f],
                              kind_of(fs, f, aligned));
    r->range = alloc_grown(r->range, n_runs, n_runs, sizeof *r->range);
    owner_take(r, r->range);
    if (fits && (long)n_runs * MIN_LENGTH <= fs->n) return r;
    owner_free(r);
    return NULL;
}

struct face_pieces *faces_find_pieces(int n_inner, int n, const int *owner,
                                      const int *neighbour)
{
    const struct faces fs = {
        .n_inner = n_inner, .n = n, .owner = owner, .neighbour = neighbour};

    return find_pieces(&fs, 0);
}

void faces_divide(struct faces *f)
{
    int aligned = f->S != NULL;

    for (int i = 0; i < f->n && aligned; i++)
        aligned = axis_of(f, i) >= 0;
    f->pieces = find_pieces(f, aligned);
    if (f->pieces == NULL || !aligned) return;
    f->area = owner_doubles(f->pieces, f->n);
    for (int i = 0; i < f->n; i++)
        f->area[i] = faces_S(f, i)[axis_of(f, i)];
}
