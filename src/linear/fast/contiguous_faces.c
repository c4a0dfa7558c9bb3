/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "linear/fast/contiguous_faces.h"

#include "base/alloc.h"

#include <stdlib.h>

/* What two faces must share to lie in the same group. */
struct kind {
    int boundary, distance;
};

static struct kind kind_of(int f, int n_inner, const int *owner,
                           const int *neighbour)
{
    const int boundary = f >= n_inner;

    return (struct kind){boundary, boundary ? 0 : neighbour[f] - owner[f]};
}

/* Begins a group with the next run; 0 if there are too many. */
static int begin_group(struct contiguous_faces *r, struct kind k, int next)
{
    if (r->n_groups == CONTIGUOUS_FACES_GROUPS) return 0;
    r->group[r->n_groups].first = next;
    r->group[r->n_groups].distance = k.distance;
    r->group[r->n_groups].boundary = k.boundary;
    r->n_groups++;
    return 1;
}

/* Adds face f after those before it: one more of the last run, or the first of
 * a new one, perhaps of a new group. Returns 0 if there are too many groups. */
static int contiguous_faces_add_face(struct contiguous_faces *r, int *n_runs,
                                     int f, int owner, struct kind k)
{
    struct contiguous_range *const last =
        *n_runs > 0 ? &r->range[*n_runs - 1] : NULL;
    const int g = r->n_groups - 1;
    const int same = g >= 0 && r->group[g].distance == k.distance &&
                     r->group[g].boundary == k.boundary;

    if (same && owner == last->owner + last->n) {
        last->n++;
        return 1;
    }
    if (!(same && owner > last->owner + last->n) && !begin_group(r, k, *n_runs))
        return 0;
    r->range[(*n_runs)++] = (struct contiguous_range){f, owner, 1};
    r->group[r->n_groups - 1].end = *n_runs;
    return 1;
}

/* `pieces` is the first member of the ranges. */
static const struct contiguous_faces *contiguous(const struct face_pieces *p)
{
    return (const struct contiguous_faces *)p;
}

/* The first range of [begin, end) that reaches beyond an owner or a face. */
static int first_beyond(const struct contiguous_range *run, int begin, int end,
                        int at, int by_face)
{
    while (begin < end) {
        const int middle = begin + (end - begin) / 2;
        const struct contiguous_range *const m = &run[middle];

        if ((by_face ? m->face : m->owner) + m->n > at)
            end = middle;
        else
            begin = middle + 1;
    }
    return begin;
}

/* The part of the range whose faces (by_face) or owners lie within [first,
 * last).
 */
static void contiguous_faces_cut(const struct contiguous_range *run, int first,
                                 int last, int by_face, struct face_piece *p)
{
    const int begin = by_face ? run->face : run->owner;
    const int skip = first > begin ? first - begin : 0;
    const int end = begin + run->n < last ? begin + run->n : last;

    p->face = run->face + skip;
    p->cell = run->owner + skip;
    p->n = end - begin - skip;
}

/* p->group counts the sides of the groups: 2 g from the owner, 2 g + 1 from the
 * neighbour; p->range is the range of the next piece, 0 until it is known. */
static int next_of_cells(const struct face_pieces *pieces, int first, int last,
                         struct face_piece *p)
{
    const struct contiguous_faces *const r = contiguous(pieces);

    for (; p->group < 2 * r->n_groups; p->group++, p->range = 0) {
        const int g = p->group / 2, inward = p->group % 2;
        const int d = r->group[g].distance, shift = inward ? d : 0;

        if (inward && r->group[g].boundary) continue;
        if (p->range == 0)
            p->range = first_beyond(r->range, r->group[g].first,
                                    r->group[g].end, first - shift, 0);
        if (p->range == r->group[g].end ||
            r->range[p->range].owner >= last - shift)
            continue;
        contiguous_faces_cut(&r->range[p->range++], first - shift, last - shift,
                             0, p);
        p->cell += shift;
        p->other = inward ? p->cell - d : p->cell + d;
        p->out = inward ? -1.0 : 1.0;
        return 1;
    }
    return 0;
}

static int next_of_faces(const struct face_pieces *pieces, int first, int last,
                         struct face_piece *p)
{
    const struct contiguous_faces *const r = contiguous(pieces);

    for (; p->group < r->n_groups; p->group++, p->range = 0) {
        const int g = p->group;

        if (p->range == 0)
            p->range = first_beyond(r->range, r->group[g].first,
                                    r->group[g].end, first, 1);
        if (p->range == r->group[g].end || r->range[p->range].face >= last)
            continue;
        contiguous_faces_cut(&r->range[p->range++], first, last, 1, p);
        p->other = p->cell + r->group[g].distance;
        p->out = 1.0;
        return 1;
    }
    return 0;
}

static void free_ranges(struct face_pieces *p)
{
    struct contiguous_faces *const r = (struct contiguous_faces *)p;

    free(r->range);
    free(r);
}

struct face_pieces *contiguous_faces_find(int n_inner, int n, const int *owner,
                                          const int *neighbour)
{
    struct contiguous_faces *const r = alloc_zeroed(1, sizeof *r);
    int n_runs = 0, fits = 1;

    r->pieces = (struct face_pieces){next_of_faces, next_of_cells, free_ranges};
    r->range = alloc_zeroed((size_t)n, sizeof *r->range);
    for (int f = 0; f < n && fits; f++)
        fits = contiguous_faces_add_face(r, &n_runs, f, owner[f],
                                         kind_of(f, n_inner, owner, neighbour));
    if (fits && (long)n_runs * CONTIGUOUS_FACES_MIN_LENGTH <= n)
        return &r->pieces;
    free_ranges(&r->pieces);
    return NULL;
}
