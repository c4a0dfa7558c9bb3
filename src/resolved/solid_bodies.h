/* solid_bodies.h -- bodies of many cells, with the flow around them resolved.
 * Chapter "Resolving the grains".
 *
 * The fluid fills the whole box. Where a body is, a friction holds it to the
 * velocity of the body [EW18 1-4]:
 *
 *   rho (du/dt + u . grad u) = -grad p + mu lap u + hold (U + omega x r - u)
 *
 * and what this takes from the fluid moves the body [EW18 2, 3, 15].
 */
#ifndef RESOLVED_SOLID_BODIES_H
#define RESOLVED_SOLID_BODIES_H

#include "base/state.h"
#include "coupling/effect.h"
#include "dem/dem.h"
#include "fluid/fluid.h"
#include "resolved/bodies_setup.h"
#include "resolved/body_seal.h"
#include "resolved/body_shape.h"

/* What a body does to a cell. */

/* A cell that a body holds, or, outside of it, one beside a held one. */
struct hold_link {
    int cell;
    double hold; /* [kg/(m^3 s)]; by_fraction: solid fraction [-] */
    double u[3]; /* [m/s] velocity of the body there */
    double r[3]; /* [m] the cell's centre, from that of the body */
};

struct solid_bodies {
    struct immersed hooks; /* first, because the fluid gives it back */
    struct solid_bodies_options options;
    double rho, mu; /* [kg/m^3], [Pa s] of the fluid */
    struct dem_options contacts;
    struct squeeze_film lubrication;
    struct particles *ps;       /* centres, velocities, masses */
    int springs, blocks, moves; /* [-] on springs; no spheres in dem; any */
    int met; /* [-] 1: two overlap that have no contacts (mark.c) */
    struct body_seal seal; /* of the cells as they are marked */
    double deepest;        /* [-] overlap so far, over a diameter or width */
    int touching;          /* [-] contacts of blocks, a ball or point each */
    double *turn;    /* [-] quaternions, 4 a body; NULL: none has an outline */
    struct dem *dem; /* their contacts and motion; NULL: none is free */
    struct dem_report dem_report;
    struct body_shape *shape;
    enum body_motion *motion;
    double *volume; /* [m^3] of the part of it within the box */
    double *mass;   /* [kg]; ps->m: infinite to contacts unless it is free */
    double *C_v, *C_spin;    /* [-] of each, of its rotation (body_motion.h) */
    double *spring, *anchor; /* [N/m], 0: held along this axis; [m]; 3 a body */
    double *u_old, *w_old;   /* [m/s], [rad/s] a step before, 3 a body; w_old
                                has turned with it since */
    double *u_by_fluid, *w_by_fluid; /* their changes, but by contacts */
    double *impulse, *angular; /* [N s], [N m s] of friction in this step, 3 */
    double *force, *torque;    /* [N], [N m] of the fluid in the last step, 3 */
    double *inertia; /* [kg m^2] of the fluid held in it, 3 a body (mark.c) */
    int by_fraction; /* 1: links have solid fractions (fraction_methods.h) */
    struct hold_link *link; /* those of body i: link[start[i]] ... end[i] - 1 */
    int *start, *end, capacity;
    struct body_exit *exit;     /* NULL: none can leave (body_motion.h) */
    struct among_grains *among; /* NULL: there are no other particles */
    double dt_marked; /* [s] step that the links were made for; 0: none */
    int cells, *cell, n_cells; /* [-] all; those with a link, each once */
    int held;            /* [-] how many those were, after a restart too */
    unsigned char *amid; /* [-] 1: a cell that touches no end of the box */
    int *body_of, *near; /* [-] work space of mark.c and of body_gaps.c */
    double *hold;        /* [kg/(m^3 s)] sum of the links of a cell */
    double *hold_u;      /* [N/m^3] sum of hold times velocity, 3 a cell */
};

extern const double solid_bodies_immovable; /* [kg] mass of what is held */
/* n bodies at most; cells of the mesh; density of the fluid [kg/m^3]. */
struct solid_bodies *solid_bodies_create(int n, int cells, double rho,
                                         const struct solid_bodies_options *o);
void solid_bodies_free(void *bodies);
/* One more at rest at x [m], of this density [kg/m^3]. Returns its number. */
int solid_bodies_add(struct solid_bodies *b, const struct body_shape *shape,
                     const double x[3], double density,
                     enum body_motion motion);
/* Springs [N/m] hold body i where it is now, where they are 0 without a way. */
void solid_bodies_set_spring(struct solid_bodies *b, int i, const double k[3]);
/* 1: a sphere on a spring, whose contacts are those of blocks. */
int solid_bodies_hung(const struct solid_bodies *b, int i);
/* All are there and hold the borrowed fluid, which rests. Non-zero if not. */
int solid_bodies_begin(struct solid_bodies *b, struct fluid *fl);

/* --- bodies effect -------------------------------------------------------- */

/* The bodies' place in the coupled loop. */

/* Its memory is a struct solid_bodies, which it frees. The bodies move after
 * fluid and grains. */
extern const struct effect bodies_effect;

/* The same where there are particles with which they move. */
extern const struct effect among_effect;

#endif
