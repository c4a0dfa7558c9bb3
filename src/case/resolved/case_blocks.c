/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/resolved/case_blocks.h"

#include <math.h>
#include <string.h>

#include "base/vector.h"
#include "case/case_mesh.h"
#include "case/resolved/case_bodies.h"
#include "case/resolved/case_outlines.h"
#include "resolved/shapes/block_outline.h"
#include "resolved/shapes/contact_points.h"

const char case_blocks_boxes[] = "bodies.boxes",
           case_blocks_cylinders[] = "bodies.cylinders";

static int any_is_free(const struct settings *s)
{
    const char *const lists[] = {case_blocks_boxes, case_blocks_cylinders,
                                 case_outlines_surfaces};

    for (int l = 0; l < 3; l++)
        for (int i = 0; i < settings_length(s, lists[l]); i++)
            if (case_bodies_is(s, lists[l], i, "free")) return 1;
    return 0;
}

int case_blocks_touch(const struct settings *s)
{
    struct kept_outlines *const all = s->outlines;

    if (all->touch == 0) all->touch = 1 + any_is_free(s);
    return all->touch - 1;
}

struct body_shape case_blocks_shape(const struct settings *s, const char *list,
                                    int i)
{
    double v[3];

    if (list == case_blocks_boxes) {
        settings_item_vector(s, list, i, "size", v);
        return body_shape_box(v);
    }
    settings_item_vector(s, list, i, "axis", v);
    return body_shape_cylinder(settings_item_real(s, list, i, "diameter"),
                               settings_item_real(s, list, i, "length"), v);
}

/* A cylinder is turned by its axis alone. */
static void rotation_of(const struct settings *s, const char *list, int i,
                        double rotation[3])
{
    rotation[0] = rotation[1] = rotation[2] = 0.0;
    if (list == case_blocks_boxes)
        settings_item_vector(s, list, i, "rotation", rotation);
}

static int turns(const struct settings *s, const char *list, int i)
{
    double rotation[3], spin[3];

    rotation_of(s, list, i, rotation);
    settings_item_vector(s, list, i, "spin", spin);
    return case_blocks_touch(s) || vector_length(rotation) > 0.0 ||
           vector_length(spin) > 0.0;
}

void case_blocks_add_points(const struct settings *s, struct body_outline *o)
{
    double lo[3], hi[3], h[3];
    int periodic[3];

    if (!case_blocks_touch(s)) return;
    case_mesh_ends(s, lo, hi);
    case_mesh_periodic(s, periodic);
    case_bodies_cell_widths(s, h);
    contact_points_add(o);
    for (int k = 0; k < 3; k++)
        if (!periodic[k] && body_outline_spans(o, k, hi[k] - lo[k], h[k]))
            contact_points_between(o, k);
}

struct body_outline *case_blocks_outline(const struct settings *s,
                                         const char *list, int i)
{
    const struct body_shape shape = case_blocks_shape(s, list, i);
    double rotation[3];

    if (!turns(s, list, i)) return NULL;
    rotation_of(s, list, i, rotation);
    struct body_outline *const o = block_outline_create(&shape, rotation);
    case_blocks_add_points(s, o);
    return o;
}

/* --- checks --------------------------------------------------------------- */

/* Of one that is so wide [m] in each direction, and reaches that far from its
 * centre. What reaches through the box has no ends there. One that is narrower
 * than a cell may hold none. */
static int case_blocks_check_place(const struct settings *s, const char *list,
                                   int i, const double width[3],
                                   const double extent[3])
{
    const int fixed = case_bodies_is(s, list, i, "fixed");
    double lo[3], hi[3], h[3], x[3];

    case_mesh_ends(s, lo, hi);
    case_bodies_cell_widths(s, h);
    settings_item_vector(s, list, i, "position", x);
    for (int k = 0; k < 3; k++) {
        const double reach = fixed ? extent[k] : 0.0;
        if (x[k] + reach < lo[k] || x[k] - reach > hi[k])
            return settings_wrong(s, list,
                                  "number %d at [%g, %g, %g] m is not inside "
                                  "the box",
                                  i, x[0], x[1], x[2]);
        if (2.0 * extent[k] < hi[k] - lo[k] && width[k] < h[k])
            return settings_wrong(s, list,
                                  "number %d is %.3g cells wide; expected at "
                                  "least 1, better 12",
                                  i, width[k] / h[k]);
    }
    return 0;
}

/* One along an axis of the box has its length there. */
static void case_blocks_width_of(const struct body_shape *shape,
                                 double width[3])
{
    const double d = 2.0 * shape->half[0], length = 2.0 * shape->half[1];

    for (int k = 0; k < 3; k++)
        width[k] = shape->kind == BODY_BOX      ? 2.0 * shape->half[k]
                   : body_shape_along(shape, k) ? length
                   : shape->axis[k] == 0.0      ? d
                                                : fmin(d, length);
}

static int case_blocks_check_one(const struct settings *s, const char *list,
                                 int i)
{
    double extent[3], width[3], axis[3];

    if (list == case_blocks_cylinders) {
        settings_item_vector(s, list, i, "axis", axis);
        if (vector_length(axis) == 0.0)
            return settings_wrong(
                s, list, "the axis of cylinder %d has no direction", i);
    }
    if (case_bodies_is(s, list, i, "free"))
        return case_outlines_check_one(s, list, i);
    const struct body_shape shape = case_blocks_shape(s, list, i);
    body_shape_extent(&shape, extent);
    case_blocks_width_of(&shape, width);
    return case_blocks_check_place(s, list, i, width, extent);
}

int case_blocks_check(const struct settings *s)
{
    const char *const lists[2] = {case_blocks_boxes, case_blocks_cylinders};
    int code = 0;

    for (int l = 0; l < 2; l++)
        for (int i = 0; i < settings_length(s, lists[l]) && code == 0; i++)
            code = case_blocks_check_one(s, lists[l], i);
    return code;
}
