/* immersed.h -- the hooks of bodies in the flow.
 * Chapter "Resolving the grains".
 *
 * Bodies in the flow add a friction per volume, hold (U - u) [N/m^3], to some
 * cells, and a part of their velocity U to the fluxes between these. They are
 * defined in a higher room (resolved/). The solver calls the functions below
 * where fluid->immersed is not NULL.
 */
#ifndef FLUID_IMMERSED_H
#define FLUID_IMMERSED_H

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
