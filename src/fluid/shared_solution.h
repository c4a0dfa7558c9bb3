/* shared_solution.h -- the hooks of a fluid whose mesh is one part of a larger
 * one. Chapter "Past one machine".
 *
 * The cells of the larger mesh are divided into parts. Each part is a mesh of
 * its own with some layers of the cells of other parts around it, and is
 * stepped by itself, except in these functions, which all parts call together.
 * They are in fluid_options; where they are NULL there, the mesh is the whole
 * one.
 */
#ifndef FLUID_SHARED_SOLUTION_H
#define FLUID_SHARED_SOLUTION_H

#include "linear/cg.h"

struct fluid;

struct shared_solution {
    /* Solve the systems of velocity_predict and pressure_correct. relative [-]
     * is the reduction of the residual at which the pressure may stop. */
    struct solve_report (*momentum)(void *parts, struct fluid *fl,
                                    double tolerance /* [-] */);
    struct solve_report (*pressure)(void *parts, struct fluid *fl,
                                    double relative, double absolute);
    /* Copies the corrected velocity to the layers around the other parts. */
    void (*corrected)(void *parts, struct fluid *fl);
    /* The largest residual of velocity_residual, of the cells of all parts. */
    double (*residual)(void *parts, const struct fluid *fl);
    /* Copies all fields at the end of a step; returns 1 if the step has failed
     * in any part. */
    int (*finished)(void *parts, struct fluid *fl, int failed);
    /* The largest x of all parts. */
    double (*largest)(void *parts, double x);
    void *parts;
};

/* The largest and the smallest x of all parts. */
static inline double shared_largest(const struct shared_solution *s, double x)
{
    return s == 0 ? x : s->largest(s->parts, x);
}

static inline double shared_smallest(const struct shared_solution *s, double x)
{
    return -shared_largest(s, -x);
}

#endif
