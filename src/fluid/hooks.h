/* hooks.h -- where another room takes part in a step of the fluid.
 *
 * A fluid whose mesh is one part of a larger one (chapter "Past one machine").
 *
 * The cells of the larger mesh are divided into parts. Each part is a mesh of
 * its own with some layers of the cells of other parts around it, and is
 * stepped by itself, except in these functions, which all parts call together.
 * They are in fluid_options; where they are NULL there, the mesh is the whole
 * one.
 */
#ifndef FLUID_HOOKS_H
#define FLUID_HOOKS_H

#include "linear/solvers.h"

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

/* The smallest x of all processes. */
static inline double shared_smallest(const struct shared_solution *s, double x)
{
    return -shared_largest(s, -x);
}

/* The hooks of bodies in the flow.
 *
 * Bodies in the flow add a friction per volume, hold (U - u) [N/m^3], to some
 * cells, and a part of their velocity U to the fluxes between these. They are
 * defined in a higher room (resolved/). The solver calls the functions below
 * where fluid->immersed is not NULL. */

struct fluid;

struct immersed {
    /* The old-time terms are set: adds the explicit part, once a step. */
    void (*begin)(struct immersed *self, struct fluid *fl);
    /* The matrix of momentum is filled: adds the friction to its diagonal. */
    void (*add_friction)(struct immersed *self, struct fluid *fl);
    /* The mobilities of the faces are set: changes those of held cells. */
    void (*change_faces)(struct immersed *self, struct fluid *fl);
    /* The smooth forces of the cells (face_jump.c) were found from the
     * diagonal: takes the friction out of them. */
    void (*smooth_forces)(struct immersed *self, struct fluid *fl);
    /* The velocity has been corrected with the new pressure. */
    void (*corrected)(struct immersed *self, struct fluid *fl);
    /* The largest diagonal without the friction times the velocity [N], which
     * the residual of the splitting is compared with; NULL: with friction. */
    double (*largest_term)(const struct immersed *self, const struct fluid *fl);
    /* The velocity of the step is final, unless this changes it. */
    void (*end)(struct immersed *self, struct fluid *fl);
    double impulse[3]; /* [N s] on the fluid in the last step */
    double gross;      /* [N s] the sum of its sizes over the cells */
};

#endif
