/* deferred.h -- the hooks of explicit terms that use the gradients of cells.
 * Chapter "The flow, verified".
 *
 * Where the links of a mesh are not normal to their faces, or miss the middles
 * of these, and in a scheme of convection that uses more than two cells, the
 * equations have terms with gradients. They are computed from the values known
 * so far and added to the explicit side (deferred correction). The folder
 * deferred/ has these terms; in a box, with the other schemes, there are none.
 */
#ifndef FLUID_DEFERRED_H
#define FLUID_DEFERRED_H

struct fluid;

struct deferred {
    /* Adds the terms to the right-hand side of the momentum equation [N]. */
    void (*add_to_momentum)(struct deferred *self, struct fluid *fl);
    /* Adds the terms to the fluxes without the pressure [m^3/s]. */
    void (*add_to_fluxes)(struct deferred *self, struct fluid *fl);
    /* Adds the terms to p_face [Pa] and computes grad_p from it. */
    void (*set_gradient)(struct deferred *self, struct fluid *fl);
    void (*free)(struct deferred *self);
    double *reach; /* [m] from the centre of a cell to where the velocity of its
                      boundary face holds, 3 a boundary face
                      (velocity_gradient.h); NULL: to the middle */
};

/* create returns NULL where the mesh and the schemes of the fluid need none. */
struct deferred_kind {
    const char *name;
    struct deferred *(*create)(const struct fluid *fl);
};
extern const struct deferred_kind *const deferred_kinds[]; /* ended by NULL */

#endif
