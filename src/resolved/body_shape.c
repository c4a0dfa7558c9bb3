/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "resolved/body_shape.h"

#include <gsl/gsl_math.h>

#include "base/vector.h"

struct body_shape body_shape_sphere(double diameter)
{
    return (struct body_shape){.kind = SHAPE_SPHERE, .size = {0.5 * diameter}};
}

double body_shape_distance(const struct body_shape *shape, const double r[3])
{
    return vector_length(r) - shape->size[0];
}

double body_shape_reach(const struct body_shape *shape)
{
    return shape->size[0];
}

double body_shape_volume(const struct body_shape *shape)
{
    const double R = shape->size[0];
    return 4.0 / 3.0 * M_PI * R * R * R;
}
