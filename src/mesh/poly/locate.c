/* SPDX-License-Identifier: GPL-3.0-or-later */
/* locate.c -- finds the cell of a point in a mesh that is not a box.
 *
 * A walk goes from cell to cell through the face that the point is farthest
 * beyond. Across a periodic face the point is moved by the period, because for
 * the neighbour this face is at the other end of the mesh.
 *
 * Faces with four corners or more may be warped. Their planes then leave gaps
 * between cells, no wider than a corner is off its plane; a point in a gap
 * belongs to the cell that it is least beyond. The walk begins in a cell that
 * depends on the position alone, so the cell of a point is always the same.
 *
 * If a walk ends at the boundary or in a cycle, the point may still be inside,
 * because the mesh may be concave. Then all cells whose bounding boxes may
 * contain the point are tested.
 */
#include "mesh/poly/poly.h"

#include <math.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "base/number.h"
#include "base/vector.h"

/* The cells that may contain a point: a grid of bins, and for each bin the
 * cells whose bounding boxes overlap it. */
struct bins {
    int n[3];
    double inverse[3];   /* [1/m] of a bin's width */
    int *start, *member; /* [-] the cells of a bin, ascending */
    int *begin;          /* [-] the cell whose centre is nearest to that of the
                            bin; or -1 */
    double *plane;       /* [-], [m] beside cell_face, 4 each: the normal out of
                            the cell, and its product with the face centre
                            relative to this cell */
    double tiny;  /* [m] a point that is less far beyond a face is inside */
    double slack; /* [m] gaps between warped faces are no wider */
};

/* The point of a walk, and the best cell so far. */
struct walk {
    const struct mesh *m;
    double x[3];      /* [m] relative to the present cell */
    int best;         /* [-] cell, or -1 */
    double excess;    /* [m] that the point is beyond the best cell's faces */
    double offset[3]; /* [m] from its centre to the point */
};

/* How far the point is beyond face a of the cell's list [m]. */
static double locate_beyond(const struct walk *w, int a)
{
    const double *const p = &w->m->bins->plane[4 * a];
    return p[0] * w->x[0] + p[1] * w->x[1] + p[2] * w->x[2] - p[3];
}

/* The inner face of cell c that the point is farthest beyond, or -1; *most is
 * how far it is beyond any of its faces. */
static int way_out(const struct walk *w, int c, double *most)
{
    const struct mesh *const m = w->m;
    double any = m->bins->tiny, inner = any;
    int way = -1;

    for (int a = m->cell_start[c]; a < m->cell_start[c + 1]; a++) {
        const double r = locate_beyond(w, a);
        if (r > any) any = r;
        if (r <= inner || m->cell_face[a] >= m->n_internal) continue;
        inner = r;
        way = a;
    }
    *most = any > m->bins->tiny ? any : 0.0;
    return way;
}

/* Moves the point to its nearest image where the cell is its own neighbour,
 * because its periodic faces do not end the walk. */
static void nearest_image(const struct mesh *m, double o[3])
{
    for (int i = 0; i < m->n_periods; i++) {
        const double *const P = m->period[i];
        const double laps = rint(vector_dot(o, P) / vector_dot(P, P));
        for (int k = 0; k < 3 && laps != 0.0; k++)
            o[k] -= laps * P[k];
    }
}

/* Keeps cell c if the point exceeds its faces by less [m] than those so far. */
static void try_cell(struct walk *w, int c, double excess)
{
    if (w->best >= 0 && excess >= w->excess) return;
    w->best = c;
    w->excess = excess;
    for (int k = 0; k < 3; k++)
        w->offset[k] = w->x[k] - w->m->centre[3 * c + k];
    nearest_image(w->m, w->offset);
}

/* Goes through face a of the cell's list; returns the cell behind it. */
static int go_through(struct walk *w, int a)
{
    const struct mesh *const m = w->m;
    const int f = m->cell_face[a],
              crossing = m->periodic_index != NULL ? m->periodic_index[f] : 0;

    for (int k = 0; k < 3 && crossing != 0; k++)
        w->x[k] += m->out[a] * (crossing > 0 ? m->period[crossing - 1][k]
                                             : -m->period[-crossing - 1][k]);
    return m->out[a] > 0 ? m->neighbour[f] : m->owner[f];
}

/* 1 if a cell was found. */
static int locate_walk_from(struct walk *w, int c)
{
    const int longest =
        32 + 8 * number_clamped(cbrt(w->m->n_cells), 1, 1 << 11);

    for (int steps = 0; steps < longest; steps++) {
        double excess;
        const int way = way_out(w, c, &excess);
        try_cell(w, c, excess);
        if (excess == 0.0) return 1;
        if (way < 0) break;
        c = go_through(w, way);
    }
    return 0;
}

/* The bin of a point, or -1. */
static int bin_of(const struct mesh *m, const double x[3])
{
    const struct bins *const b = m->bins;
    int at[3];

    for (int k = 0; k < 3; k++) {
        if (!(x[k] >= m->lo[k] - b->slack && x[k] <= m->hi[k] + b->slack))
            return -1;
        at[k] =
            number_clamped((x[k] - m->lo[k]) * b->inverse[k], 0, b->n[k] - 1);
    }
    return at[0] + b->n[0] * (at[1] + b->n[1] * at[2]);
}

/* Tests all cells of the bins of the point and of its images. */
static int search_bin(struct walk *w, const double x[3])
{
    const struct mesh *const m = w->m;
    const struct bins *const b = m->bins;
    int images = 1;

    for (int i = 0; i < m->n_periods; i++)
        images *= 3;
    for (int image = 0; image < images; image++) {
        for (int k = 0; k < 3; k++)
            w->x[k] = x[k];
        for (int i = 0, rest = image; i < m->n_periods; i++, rest /= 3)
            for (int k = 0; k < 3; k++)
                w->x[k] += (rest % 3 == 2 ? -1 : rest % 3) * m->period[i][k];
        const int bin = bin_of(m, w->x);
        if (bin < 0) continue;
        for (int a = b->start[bin]; a < b->start[bin + 1]; a++) {
            double excess;
            way_out(w, b->member[a], &excess);
            try_cell(w, b->member[a], excess);
        }
    }
    return w->best >= 0 && w->excess <= b->slack;
}

int locate_from(const struct mesh *m, int begin, const double x[3],
                double offset[3])
{
    struct walk w = {.m = m, .best = -1};

    if (!(isfinite(x[0]) && isfinite(x[1]) && isfinite(x[2]))) return -1;
    for (int k = 0; k < 3; k++)
        w.x[k] = x[k];
    if (!(begin >= 0 && locate_walk_from(&w, begin)) && !search_bin(&w, x))
        return -1;
    for (int k = 0; k < 3; k++)
        offset[k] = w.offset[k];
    return w.best;
}

/* Moves the point by whole periods into or next to the mesh. */
static void fold(const struct mesh *m, const double x[3], double y[3])
{
    double o[3];

    for (int k = 0; k < 3; k++)
        o[k] = x[k] - 0.5 * (m->lo[k] + m->hi[k]);
    nearest_image(m, o);
    for (int k = 0; k < 3; k++)
        y[k] = m->n_periods > 0 ? o[k] + 0.5 * (m->lo[k] + m->hi[k]) : x[k];
}

/* The point is moved by whole periods first, and the walk begins in the cell
 * that belongs to its bin. */
int locate_cell(const struct mesh *m, const double x[3], double offset[3])
{
    double y[3];

    fold(m, x, y);
    const int bin = bin_of(m, y);
    return locate_from(m, bin < 0 ? -1 : m->bins->begin[bin], y, offset);
}

/* --- bins ----------------------------------------------------------------- */

/* Sets the numbers and widths of the bins: about as many as cells, nearly
 * cubes. */
static void size_bins(const struct mesh *m, struct bins *b)
{
    double volume = 1.0;

    for (int k = 0; k < 3; k++)
        volume *= m->hi[k] - m->lo[k];
    const double width = cbrt(volume / m->n_cells);
    for (int k = 0; k < 3; k++) {
        const double L = m->hi[k] - m->lo[k];
        b->n[k] = number_clamped(L / width, 1, 1024);
        b->inverse[k] = b->n[k] / L;
    }
}

/* The bins that the bounding box of cell c overlaps, first and last in each
 * direction. */
static void bins_of_cell(const struct mesh *m, int c, int first[3], int last[3])
{
    const struct mesh_shape *const s = m->shape;
    const struct bins *const b = m->bins;

    for (int k = 0; k < 3; k++) {
        double lo = INFINITY, hi = -INFINITY;
        for (int i = s->cell_start[c]; i < s->cell_start[c + 1]; i++)
            for (int a = s->start[s->polygon[i]];
                 a < s->start[s->polygon[i] + 1]; a++) {
                lo = fmin(lo, s->point[3 * s->corner[a] + k]);
                hi = fmax(hi, s->point[3 * s->corner[a] + k]);
            }
        const double margin = b->slack + 1e-9 * (hi - lo);
        const double low = floor((lo - margin - m->lo[k]) * b->inverse[k]);
        const double high = floor((hi + margin - m->lo[k]) * b->inverse[k]);
        first[k] = number_clamped(low, 0, b->n[k] - 1);
        last[k] = number_clamped(high, 0, b->n[k] - 1);
    }
}

/* Counts the cells of each bin, or lists them. */
static void fill_bins(const struct mesh *m, int *used)
{
    const struct bins *const b = m->bins;

    for (int c = 0; c < m->n_cells; c++) {
        int first[3], last[3];
        bins_of_cell(m, c, first, last);
        for (int k = first[2]; k <= last[2]; k++)
            for (int j = first[1]; j <= last[1]; j++)
                for (int i = first[0]; i <= last[0]; i++) {
                    const int bin = i + b->n[0] * (j + b->n[1] * k);
                    if (b->member != NULL)
                        b->member[b->start[bin] + used[bin]] = c;
                    used[bin]++;
                }
    }
}

/* The rounding error of the product of a position and a normal, or a little
 * more where cells are large compared with it [m]. */
static double rounding(const struct mesh *m)
{
    double least = INFINITY, farthest = 0.0;

    for (int c = 0; c < m->n_cells; c++)
        least = fmin(least, m->V[c]);
    for (int k = 0; k < 3; k++)
        farthest = fmax(farthest, fmax(fabs(m->lo[k]), fabs(m->hi[k])));
    return fmax(1e-12 * cbrt(least), 4e-15 * farthest);
}

/* Sets the plane of face a of the list of a cell; for the neighbour across a
 * period it is moved by the period. */
static void set_plane(const struct mesh *m, int a)
{
    const int f = m->cell_face[a];
    const int crossing =
        m->periodic_index != NULL && f < m->n_internal && m->out[a] < 0
            ? m->periodic_index[f]
            : 0;
    const double *const S = mesh_S(m, f), area = vector_length(S);
    double *const p = &m->bins->plane[4 * a];

    for (int k = 0; k < 3; k++) {
        double x = m->face_centre[3 * f + k];
        if (crossing != 0)
            x += crossing > 0 ? m->period[crossing - 1][k]
                              : -m->period[-crossing - 1][k];
        p[k] = m->out[a] * S[k] / area;
        p[3] += p[k] * x;
    }
}

/* Sets the cell with which a walk to each bin begins: the one whose centre is
 * nearest to that of the bin. */
static void choose_begins(const struct mesh *m)
{
    struct bins *const b = m->bins;

    for (int bin = 0; bin < b->n[0] * b->n[1] * b->n[2]; bin++) {
        const int at[3] = {bin % b->n[0], bin / b->n[0] % b->n[1],
                           bin / b->n[0] / b->n[1]};
        double nearest = INFINITY;
        b->begin[bin] = -1;
        for (int i = b->start[bin]; i < b->start[bin + 1]; i++) {
            double r2 = 0.0;
            for (int k = 0; k < 3; k++) {
                const double d = m->centre[3 * b->member[i] + k] - m->lo[k] -
                                 (at[k] + 0.5) / b->inverse[k];
                r2 += d * d;
            }
            if (r2 >= nearest) continue;
            nearest = r2;
            b->begin[bin] = b->member[i];
        }
    }
}

void locate_create(struct mesh *m, double slack)
{
    struct bins *const b = m->bins = owner_zeroed(m, 1, sizeof *b);

    b->slack = slack;
    size_bins(m, b);
    const int bins = b->n[0] * b->n[1] * b->n[2];
    int *const used = alloc_ints(bins);
    b->start = owner_ints(m, bins + 1);
    fill_bins(m, used);
    for (int i = 0; i < bins; i++) {
        b->start[i + 1] = b->start[i] + used[i];
        used[i] = 0;
    }
    b->member = owner_ints(m, b->start[bins]);
    fill_bins(m, used);
    free(used);
    b->begin = owner_ints(m, bins);
    choose_begins(m);
    b->plane = owner_doubles(m, 4 * m->cell_start[m->n_cells]);
    for (int a = 0; a < m->cell_start[m->n_cells]; a++)
        set_plane(m, a);
    b->tiny = rounding(m);
}
