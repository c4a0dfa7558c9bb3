/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "linear/faces.h"

#include "linear/fast/contiguous_faces.h"
#include "linear/reduce.h"

#include <stddef.h>

void faces_divide(struct faces *f)
{
    f->pieces = contiguous_faces_find(f->n_inner, f->n, f->owner, f->neighbour);
}

int faces_next(const struct faces *f, int first, int last, struct face_piece *p)
{
    if (f->pieces != NULL)
        return f->pieces->next_of_faces(f->pieces, first, last, p);
    if (p->n > 0 || first >= last) return 0;
    *p = (struct face_piece){.face = first,
                             .n = last - first,
                             .owner = f->owner + first,
                             .neighbour = f->neighbour + first};
    return 1;
}

void faces_release(struct faces *f)
{
    if (f->pieces != NULL) f->pieces->free(f->pieces);
    f->pieces = NULL;
}

static void sum_by_lists(const struct faces *fs, int first, int last, int n,
                         const double *a, double sign, const double *b,
                         const double *S, double *sum)
{
    for (int c = first; c < last; c++) {
        double x = 0.0, y = 0.0, z = 0.0;

        for (int i = fs->cell_start[c]; i < fs->cell_start[c + 1]; i++) {
            const int f = fs->cell_face[i];
            if (f >= n) continue;
            const double part = fs->out[i] > 0.0 ? a[f] : sign * b[f];
            x += part * S[3 * f];
            y += part * S[3 * f + 1];
            z += part * S[3 * f + 2];
        }
        sum[3 * c] = x;
        sum[3 * c + 1] = y;
        sum[3 * c + 2] = z;
    }
}

static void sum_by_pieces(const struct face_pieces *r, int first, int last,
                          int n, const double *a, double sign, const double *b,
                          const double *S, double *sum)
{
    struct face_piece p = {0};

    for (int i = 3 * first; i < 3 * last; i++)
        sum[i] = 0.0;
    while (r->next_of_cells(r, first, last, &p) && p.face < n) {
        const int leaves = p.out > 0.0;

        vec3_add(p.n, leaves ? 1.0 : sign, (leaves ? a : b) + p.face,
                 S + 3L * p.face, sum + 3L * p.cell);
    }
}

void faces_sum_vectors(const struct faces *f, int first, int last, int n,
                       const double *a, double sign, const double *b,
                       const double *S, double *sum)
{
    if (f->pieces == NULL)
        sum_by_lists(f, first, last, n, a, sign, b, S, sum);
    else
        sum_by_pieces(f->pieces, first, last, n, a, sign, b, S, sum);
}
