/* shared_solution.h -- the hooks of a fluid whose mesh is one part of a larger
 * one. Chapter "Past one machine".
 *
 * The cells of the larger mesh are divided; each part is a mesh of its own with
 * some layers of its neighbours' cells around, and steps by itself but for
 * these functions, in which all parts act together. They stand in
 * fluid_options; NULL there: the mesh is the whole one.
 */
#ifndef FLUID_SHARED_SOLUTION_H
#define FLUID_SHARED_SOLUTION_H

#include "linear/report.h"

struct fluid;

struct shared_solution {
    /* Solve the systems of velocity_predict and pressure_correct. relative [-]
     * is the reduction of the residual at which the pressure may stop. */
    struct solve_report (*momentum)(void *parts, struct fluid *fl,
                                    double tolerance /* [-] */);
    struct solve_report (*pressure)(void *parts, struct fluid *fl,
                                    double relative, double absolute);
    /* The velocity was corrected: takes it over to the other parts' layers. */
    void (*corrected)(void *parts, struct fluid *fl);
    /* The largest residual of velocity_residual, of the cells of all parts. */
    double (*residual)(void *parts, const struct fluid *fl);
    /* The step is done: takes all fields over; returns whether the step has
     * failed in any part. */
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
