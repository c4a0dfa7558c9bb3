/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "report/page.h"

#include "base/alloc.h"
#include "base/number.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The cells of a box between edges [m]; or those of a mesh. */
struct cells {
    double *edge[3];
    int across[3], n;
    struct vtk_shapes mesh; /* x is NULL: a box */
};

static void cells_release(struct cells *c)
{
    for (int k = 0; k < 3; k++)
        free(c->edge[k]);
    vtk_read_shapes_free(&c->mesh);
}

static int cells_read(struct cells *c, const struct vtk_read *f)
{
    static const char *const axis[3] = {"x", "y", "z"};
    double n = 1.0;

    *c = (struct cells){0};
    for (int k = 0; k < 3; k++) {
        size_t edges;
        c->edge[k] = vtk_read_array(f, axis[k], 1, &edges);
        c->across[k] = number_clamped((double)edges - 1.0, 0, 1 << 30);
        n *= c->across[k];
    }
    if (n < 1.0)
        n = vtk_read_shapes(&c->mesh, f) == 0 ? (double)c->mesh.n : 0.0;
    return n < 1.0 || number_int(n, &c->n) != 0;
}

/* The box around a cell; non-zero if it has none. */
static int plane_box(const struct cells *c, int i, double low[3],
                     double high[3])
{
    const double *x;
    size_t q = 0;

    for (int k = 0, at = i; k < 3 && c->mesh.x == NULL; at /= c->across[k++]) {
        low[k] = c->edge[k][at % c->across[k]];
        high[k] = c->edge[k][at % c->across[k] + 1];
    }
    if (c->mesh.x == NULL) return 0;
    for (; (x = vtk_read_corner(&c->mesh, (size_t)i, q)) != NULL; q++)
        for (int k = 0; k < 3; k++) {
            low[k] = q == 0 ? x[k] : fmin(low[k], x[k]);
            high[k] = q == 0 ? x[k] : fmax(high[k], x[k]);
        }
    return q == 0;
}

/* The box around all cells, and how many of them lie along each side. */
static int around(const struct cells *c, double low[3], double high[3],
                  int across[3])
{
    double width[3] = {0.0};
    int n = 0;

    for (int i = 0; i < c->n; i++) {
        double a[3], b[3];
        if (plane_box(c, i, a, b) != 0) continue;
        for (int k = 0; k < 3; k++) {
            low[k] = n == 0 ? a[k] : fmin(low[k], a[k]);
            high[k] = n == 0 ? b[k] : fmax(high[k], b[k]);
            width[k] += b[k] - a[k];
        }
        n++;
    }
    for (int k = 0; k < 3 && n > 0; k++)
        across[k] =
            c->mesh.x == NULL
                ? c->across[k]
                : number_clamped(2.0 * (high[k] - low[k]) * n / width[k] + 0.5,
                                 1, PLANE_MOST);
    return n == 0;
}

/* The raster across `axis`: not where the other two sides are one cell. */
static void plane_begin(struct plane *p, int axis, const int across[3])
{
    const int a = (axis + 1) % 3, b = (axis + 2) % 3;
    const double size[2] = {p->high[a] - p->low[a], p->high[b] - p->low[b]};
    const double longer = fmax(size[0], size[1]);

    p->n[0] = p->n[1] = 0;
    if (!(size[0] > 0.0 && size[1] > 0.0 && isfinite(longer))) return;
    if (across[a] == 1 && across[b] == 1) return;
    for (int k = 0; k < 2; k++)
        p->n[k] = number_clamped(ceil(PLANE_MOST * size[k] / longer), 1,
                                 across[k == 0 ? a : b]);
    p->cell = alloc_ints(p->n[0] * p->n[1]);
    for (int q = 0; q < p->n[0] * p->n[1]; q++)
        p->cell[q] = -1;
}

/* The points of a side that lie from x to y. */
static void plane_span(const struct plane *p, int axis, int k,
                       const double range[2], int *from, int *to)
{
    const int side = (axis + 1 + k) % 3;
    const double step = (p->high[side] - p->low[side]) / p->n[k];

    *from = number_clamped(ceil((range[0] - p->low[side]) / step - 0.5), 0,
                           p->n[k]);
    *to = number_clamped(ceil((range[1] - p->low[side]) / step - 0.5), 0,
                         p->n[k]);
}

static void plane_add_cell(struct plane *p, int axis, int i,
                           const double low[3], const double high[3],
                           double *nearest)
{
    const int a = (axis + 1) % 3, b = (axis + 2) % 3;
    int from[2], to[2];

    if (!(low[axis] <= p->at && p->at < high[axis])) return;
    plane_span(p, axis, 0, (double[]){low[a], high[a]}, &from[0], &to[0]);
    plane_span(p, axis, 1, (double[]){low[b], high[b]}, &from[1], &to[1]);
    for (int v = from[1]; v < to[1]; v++)
        for (int u = from[0]; u < to[0]; u++) {
            const double x =
                p->low[a] + (u + 0.5) * (p->high[a] - p->low[a]) / p->n[0];
            const double y =
                p->low[b] + (v + 0.5) * (p->high[b] - p->low[b]) / p->n[1];
            const double far = pow(x - 0.5 * (low[a] + high[a]), 2) +
                               pow(y - 0.5 * (low[b] + high[b]), 2) +
                               pow(p->at - 0.5 * (low[axis] + high[axis]), 2);
            const int q = u + p->n[0] * v;
            if (p->cell[q] >= 0 && far >= nearest[q]) continue;
            p->cell[q] = i;
            nearest[q] = far;
        }
}

int plane_make(struct plane plane[PLANES], const struct vtk_read *f,
               size_t cells)
{
    static const double part[PLANES / 3] = {0.5, 0.25, 0.75};
    struct cells c;
    double low[3], high[3];
    int across[3];
    const int none = cells_read(&c, f) != 0 || (size_t)c.n != cells ||
                     around(&c, low, high, across);

    for (int q = 0; q < PLANES; q++)
        plane[q] = (struct plane){0};
    for (int q = 0; q < PLANES && !none; q++) {
        struct plane *const p = &plane[q];
        const int axis = q % 3;
        if (q >= 3 && across[axis] < 4) continue;
        memcpy(p->low, low, sizeof low);
        memcpy(p->high, high, sizeof high);
        p->at = low[axis] + part[q / 3] * (high[axis] - low[axis]);
        p->cells = c.n;
        plane_begin(p, axis, across);
        if (p->n[0] == 0) continue;
        double *const nearest = alloc_doubles(p->n[0] * p->n[1]);
        for (int i = 0; i < c.n; i++)
            if (plane_box(&c, i, low, high) == 0)
                plane_add_cell(p, axis, i, low, high, nearest);
        memcpy(low, p->low, sizeof low);
        memcpy(high, p->high, sizeof high);
        free(nearest);
    }
    cells_release(&c);
    return none;
}

void plane_free(struct plane plane[PLANES])
{
    for (int q = 0; q < PLANES; q++) {
        free(plane[q].cell);
        plane[q] = (struct plane){0};
    }
}
