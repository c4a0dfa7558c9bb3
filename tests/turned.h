/* turned.h -- the same case in other axes, for tests.
 *
 * The equations do not distinguish x from y or left from right. In a frame,
 * direction k shows what the original has along axis[k], mirrored about the
 * middle of the box if sign[k] is -1. A term that is missing, or has a wrong
 * sign or index in one direction, on one side or in one of the two cells of a
 * face, differs between two frames.
 */
#ifndef TURNED_H
#define TURNED_H

#include "mesh/mesh.h"

#include <string.h>

struct frame {
    int axis[3];
    double sign[3];
};

/* The original, turned by a third and by two, and mirrored in all directions,
 * in one and in two. */
static const struct frame turned_frames[] = {
    {{0, 1, 2}, {1, 1, 1}},  {{1, 2, 0}, {1, 1, 1}},
    {{2, 0, 1}, {1, 1, 1}},  {{0, 1, 2}, {-1, -1, -1}},
    {{2, 0, 1}, {1, -1, 1}}, {{1, 2, 0}, {-1, 1, -1}}};
enum { TURNED = 6 };

/* The same case in other units; the members are a metre, a second and a
 * kilogram in these units. Powers of two round to the same digits; a product
 * where a quotient should be, or a number that should have had a unit, shows at
 * once. L, M, L / T and M L^3 / T^2 are squares of such: contacts take roots of
 * L^2 twice and of M, drag laws of speeds, and
 * charges are roots of forces times areas. */
struct units {
    double L, T, M;
};
static const struct units turned_si = {1.0, 1.0, 1.0};
static const struct units turned_units = {16.0, 0.25, 64.0};

static inline void turned_scale(double factor, double v[3])
{
    for (int k = 0; k < 3; k++)
        v[k] *= factor;
}

static inline void turned_vector(const struct frame *t, const double *v,
                                 double *to)
{
    const double of[3] = {v[0], v[1], v[2]};
    for (int k = 0; k < 3; k++)
        to[k] = t->sign[k] * of[t->axis[k]];
}

/* A spin turns round in a mirror. */
static inline void turned_spin(const struct frame *t, const double *w,
                               double *to)
{
    const double side = t->sign[0] * t->sign[1] * t->sign[2];
    turned_vector(t, w, to);
    for (int k = 0; k < 3; k++)
        to[k] *= side;
}

/* A place in a box from 0 to size (of the original). */
static inline void turned_place(const struct frame *t, const double size[3],
                                const double *x, double *to)
{
    const double of[3] = {x[0], x[1], x[2]};
    for (int k = 0; k < 3; k++)
        to[k] = t->sign[k] > 0.0 ? of[t->axis[k]]
                                 : size[t->axis[k]] - of[t->axis[k]];
}

static inline struct box_spec turned_box(const struct frame *t,
                                         const struct box_spec *s)
{
    struct box_spec to;
    for (int k = 0; k < 3; k++) {
        const int a = t->axis[k];
        to.size[k] = s->size[a];
        to.cells[k] = s->cells[a];
        to.grading[k] = t->sign[k] > 0.0 ? s->grading[a] : 1.0 / s->grading[a];
        to.periodic[k] = s->periodic[a];
    }
    return to;
}

/* Which of the sides left right bottom top back front of the original is side
 * `side` of the frame. */
static inline int turned_side(const struct frame *t, int side)
{
    const int k = side / 2, upper = side % 2;
    return 2 * t->axis[k] + (t->sign[k] > 0.0 ? upper : 1 - upper);
}

/* Where cell c of the original is in m, the box of the frame. */
static inline int turned_cell(const struct frame *t, const struct mesh *from,
                              const struct mesh *m, int c)
{
    const double size[3] = {from->hi[0], from->hi[1], from->hi[2]};
    double x[3];
    turned_place(t, size, &from->centre[3 * c], x);
    return mesh_cell_at(m, x[0], x[1], x[2]);
}

#endif
