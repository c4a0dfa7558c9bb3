/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/resolved/case_outlines.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/vector.h"
#include "case/case_mesh.h"
#include "case/resolved/case_blocks.h"
#include "case/resolved/case_bodies.h"
#include "dem/population/grain_table.h"
#include "dem/population/insertion.h"
#include "dem/surfaces/stl.h"
#include "resolved/shapes/clump.h"
#include "resolved/shapes/closed_surface.h"

const char case_outlines_clumps[] = "bodies.clumps",
           case_outlines_surfaces[] = "bodies.surfaces";

static void case_outlines_path_of(const struct settings *s, const char *list,
                                  int i, char path[SETTINGS_PATH])
{
    settings_beside(s, settings_item_text(s, list, i, "file"), path,
                    SETTINGS_PATH);
}

/* Released with free(); NULL after a message. */
static struct body_ball *read_balls(const struct settings *s, int i, long *n)
{
    const double scale =
        settings_item_real(s, case_outlines_clumps, i, "scale");
    char path[SETTINGS_PATH];

    case_outlines_path_of(s, case_outlines_clumps, i, path);
    struct insertion_sphere *const list =
        grain_table_parse(settings_input(s, path), n);
    if (list == NULL) return NULL;
    struct body_ball *const ball = alloc_zeroed((size_t)*n, sizeof *ball);
    for (long k = 0; k < *n; k++) {
        for (int e = 0; e < 3; e++)
            ball[k].at[e] = scale * list[k].x[e];
        ball[k].R = 0.5 * scale * list[k].d;
    }
    free(list);
    return ball;
}

static struct body_outline *read_clump(const struct settings *s, int i)
{
    long n;
    struct body_ball *const ball = read_balls(s, i, &n);

    if (ball == NULL) return NULL;
    struct body_outline *const o = clump_create((int)n, ball);
    free(ball);
    return o;
}

void case_outlines_radii(const struct settings *s, int i, double R[2])
{
    struct body_outline *const o =
        case_outlines_read(s, case_outlines_clumps, i);
    const int n = o != NULL ? o->n_balls : 0;

    R[0] = R[1] = n > 0 ? o->ball[0].R : 0.0;
    for (int k = 1; k < n; k++) {
        R[0] = fmin(R[0], o->ball[k].R);
        R[1] = fmax(R[1], o->ball[k].R);
    }
    body_outline_free(o);
}

static struct body_outline *read_surface(const struct settings *s, int i)
{
    const double scale =
        settings_item_real(s, case_outlines_surfaces, i, "scale");
    char path[SETTINGS_PATH];
    const char *trouble;
    struct stl stl;

    case_outlines_path_of(s, case_outlines_surfaces, i, path);
    if (stl_parse(settings_input(s, path), &stl) != 0) return NULL;
    for (int c = 0; c < 9 * stl.n; c++)
        stl.corner[c / 9][c / 3 % 3][c % 3] *= scale;
    struct body_outline *const o =
        closed_surface_create(stl.n, stl.corner, &trouble);
    stl_release(&stl);
    if (o == NULL)
        settings_wrong(s, case_outlines_surfaces,
                       "%s holds no body, its surface is not closed: %s", path,
                       trouble);
    return o;
}

void case_outlines_keep(struct settings *s)
{
    const size_t n = (size_t)settings_length(s, case_outlines_clumps) +
                     (size_t)settings_length(s, case_outlines_surfaces);

    s->outlines = alloc_zeroed(1, sizeof *s->outlines);
    s->outlines->item = alloc_zeroed(n + 1, sizeof *s->outlines->item);
}

void case_outlines_release(struct settings *s)
{
    struct kept_outlines *const all = s->outlines;

    for (int k = 0; all != NULL && k < all->n; k++) {
        all->item[k].outline->kept = 0;
        body_outline_free(all->item[k].outline);
    }
    if (all != NULL) free(all->item);
    free(all);
}

/* From its file. */
static struct body_outline *read_new(const struct settings *s, const char *list,
                                     int i)
{
    if (list == case_outlines_clumps) return read_clump(s, i);
    struct body_outline *const o = read_surface(s, i);
    if (o != NULL) case_blocks_add_points(s, o);
    return o;
}

struct body_outline *case_outlines_read(const struct settings *s,
                                        const char *list, int i)
{
    struct kept_outlines *const all = s->outlines;

    if (list != case_outlines_clumps && list != case_outlines_surfaces)
        return case_blocks_outline(s, list, i);
    struct kept_outline one = {.list = list,
                               .file = settings_item_text(s, list, i, "file"),
                               .scale =
                                   settings_item_real(s, list, i, "scale")};
    for (int k = 0; k < all->n; k++)
        if (all->item[k].list == list && all->item[k].scale == one.scale &&
            strcmp(all->item[k].file, one.file) == 0)
            return all->item[k].outline;
    one.outline = read_new(s, list, i);
    if (one.outline == NULL) return NULL;
    one.outline->kept = 1;
    all->item[all->n++] = one;
    return one.outline;
}

double case_outlines_contact_volume(const struct settings *s, const char *list,
                                    int i)
{
    double R[2], V = HUGE_VAL;

    if (list == case_outlines_clumps) {
        case_outlines_radii(s, i, R);
        return 4.0 / 3.0 * M_PI * R[1] * R[1] * R[1];
    }
    if (list != case_outlines_surfaces && !case_blocks_touch(s)) {
        const struct body_shape shape = case_blocks_shape(s, list, i);
        return body_shape_volume(&shape);
    }
    struct body_outline *const o = case_outlines_read(s, list, i);
    if (o != NULL) V = o->volume / fmax(o->flat, 1);
    body_outline_free(o);
    return V;
}

/* --- checks --------------------------------------------------------------- */

/* The box around the shape as it was given [m]. */
static void case_outlines_ends_of(const struct body_outline *o, double lo[3],
                                  double hi[3])
{
    for (int k = 0; k < 3; k++) {
        lo[k] = HUGE_VAL;
        hi[k] = -HUGE_VAL;
        for (int i = 0; i < o->n_balls && o->n_triangles == 0; i++) {
            lo[k] = fmin(lo[k], o->ball[i].at[k] - o->ball[i].R);
            hi[k] = fmax(hi[k], o->ball[i].at[k] + o->ball[i].R);
        }
        for (int c = 0; c < 3 * o->n_triangles; c++) {
            lo[k] = fmin(lo[k], o->corner[c / 3][c % 3][k]);
            hi[k] = fmax(hi[k], o->corner[c / 3][c % 3][k]);
        }
        lo[k] += o->centre[k];
        hi[k] += o->centre[k];
    }
}

/* The narrowest part that is known of a shape: a ball, its box, or of a block
 * what it knows of itself [m]. */
static double thinnest(const char *list, const struct body_outline *o,
                       const double lo[3], const double hi[3])
{
    double least = fmin(hi[0] - lo[0], fmin(hi[1] - lo[1], hi[2] - lo[2]));

    if (list == case_outlines_surfaces) return least; /* check_thickness */
    if (o->width > 0.0) return fmin(least, o->width);
    for (int i = 0; i < o->n_balls; i++)
        least = fmin(least, 2.0 * o->ball[i].R);
    return least;
}

/* The farthest point from the centroid [m]. */
static double reach_of(const struct body_outline *o)
{
    double most = 0.0;

    for (int i = 0; i < o->n_balls; i++)
        most = fmax(most, vector_length(o->ball[i].at) + o->ball[i].R);
    for (int c = 0; c < 3 * o->n_triangles; c++)
        most = fmax(most, vector_length(o->corner[c / 3][c % 3]));
    return most;
}

static int case_outlines_check_place(const struct settings *s, const char *list,
                                     int i, const struct body_outline *o)
{
    const int fixed = case_bodies_is(s, list, i, "fixed");
    double lo[3], hi[3], from[3], to[3], h[3], x[3];
    int periodic[3];

    case_mesh_ends(s, lo, hi);
    case_mesh_periodic(s, periodic);
    case_bodies_cell_widths(s, h);
    settings_item_vector(s, list, i, "position", x);
    case_outlines_ends_of(o, from, to);
    const double thin = thinnest(list, o, from, to);
    for (int k = 0; k < 3; k++) {
        const double L = hi[k] - lo[k];
        const double wide = fixed ? to[k] - from[k] : 4.0 * reach_of(o);
        if (thin < case_bodies_least_cells * h[k])
            return settings_wrong(s, list,
                                  "number %d has a part of %.3g cells; "
                                  "expected at least %g, better 12",
                                  i, thin / h[k], case_bodies_least_cells);
        if (periodic[k] && wide >= L)
            return settings_wrong(s, list,
                                  "number %d meets itself across the period, "
                                  "%g m",
                                  i, L);
        if (!periodic[k] && !fixed &&
            (x[k] + from[k] < lo[k] || x[k] + to[k] > hi[k]))
            return settings_wrong(s, list,
                                  "number %d, from %g to %g m in direction %d, "
                                  "is not inside the box",
                                  i, x[k] + from[k], x[k] + to[k], k);
    }
    return 0;
}

/* A closed surface may be thinner than its box, but not so thin that it may
 * have no cell inside. */
static int check_thickness(const struct settings *s, int i,
                           const struct body_outline *o)
{
    double h[3];

    case_bodies_cell_widths(s, h);
    const double most = fmax(h[0], fmax(h[1], h[2]));
    return o->width >= most ? 0
                            : settings_wrong(s, case_outlines_surfaces,
                                             "number %d is only %.3g cells "
                                             "thick; expected at least 1, "
                                             "better 12",
                                             i, o->width / most);
}

/* A free one from wall to wall across axis k. */
static int check_upright(const struct settings *s, const char *list, int i,
                         const struct body_outline *o, int k)
{
    double lo[3], hi[3], h[3], v[3], w[3];
    int periodic[3];

    case_mesh_ends(s, lo, hi);
    case_mesh_periodic(s, periodic);
    case_bodies_cell_widths(s, h);
    settings_item_vector(s, list, i, "velocity", v);
    settings_item_vector(s, list, i, "spin", w);
    if (periodic[k] || !body_outline_spans(o, k, hi[k] - lo[k], h[k]) ||
        (v[k] == 0.0 && w[(k + 1) % 3] == 0.0 && w[(k + 2) % 3] == 0.0))
        return 0;
    return settings_wrong(s, list,
                          "number %d reaches from wall to wall along %c: it "
                          "has no velocity there and no spin about another "
                          "axis",
                          i, "xyz"[k]);
}

int case_outlines_check_one(const struct settings *s, const char *list, int i)
{
    if ((case_bodies_is(s, list, i, "free") ||
         case_bodies_is(s, list, i, "spring")) &&
        !settings_item_has(s, list, i, "density"))
        return settings_wrong(s, list,
                              "number %d is moved and asks for its density", i);
    struct body_outline *const o = case_outlines_read(s, list, i);
    int code = o == NULL ? 2 : case_outlines_check_place(s, list, i, o);

    if (code == 0 && list == case_outlines_surfaces)
        code = check_thickness(s, i, o);
    for (int k = 0; k < 3 && code == 0; k++)
        if (case_bodies_is(s, list, i, "free"))
            code = check_upright(s, list, i, o, k);
    body_outline_free(o);
    return code;
}

int case_outlines_check(const struct settings *s)
{
    const char *const lists[2] = {case_outlines_clumps, case_outlines_surfaces};
    int code = 0;

    for (int l = 0; l < 2; l++)
        for (int i = 0; i < settings_length(s, lists[l]) && code == 0; i++)
            code = case_outlines_check_one(s, lists[l], i);
    return code;
}
