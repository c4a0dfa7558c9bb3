/* solid_bodies.h -- bodies larger than the cells, with the flow around them
 * resolved. Chapter "Resolving the grains".
 *
 * The fluid fills the whole box. Where a body is, a friction holds it to the
 * velocity of the body [EW18 1-4]:
 *
 *   rho (du/dt + u . grad u) = -grad p + mu lap u + hold (U + omega x r - u)
 *
 * and what the friction takes from the fluid moves the body [EW18 2, 3, 15].
 * The bodies are a second family of particles, with contacts of their own; the
 * fluid fraction is 1 everywhere.
 */
#ifndef RESOLVED_SOLID_BODIES_H
#define RESOLVED_SOLID_BODIES_H

#include "base/state.h"
#include "dem/dem.h"
#include "fluid/fluid.h"
#include "resolved/body_options.h"
#include "resolved/body_shape.h"

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
    double rho; /* [kg/m^3] of the fluid */
    struct dem_options contacts;
    struct squeeze_film lubrication;
    struct particles *ps; /* the bodies: centres, velocities, masses */
    int springs, blocks;  /* [-] of them on springs, and not spheres */
    int moves;            /* [-] 1: one of them is not fixed */
    struct dem *dem;      /* their contacts and motion; NULL: none is free */
    struct dem_report dem_report; /* of the last step */
    struct body_shape *shape;
    enum body_motion *motion;
    double *volume; /* [m^3] of the part of it within the box */
    double *mass;   /* [kg] as its density says; ps->m of others than free ones
                       is infinite to contacts */
    double *spring; /* [N/m] along each axis, 3 a body; 0: held there */
    double *anchor; /* [m] where the springs are at rest, 3 */
    double *u_old, *w_old;     /* [m/s], [rad/s] a step before, 3 a body */
    double *impulse, *angular; /* [N s], [N m s] of the friction on the body in
                                  this step, 3 each */
    double *force, *torque;    /* [N], [N m] of the fluid in the last step, 3 */
    int by_fraction; /* 1: links have solid fractions (fraction_methods.h) */
    /* The held cells: the links of body i are link[start[i]] ... */
    struct hold_link *link;
    int *start, n_links, capacity;
    struct among_grains *among; /* NULL: there are no other particles */
    int cells;                  /* [-] of the mesh */
    double dt_marked;   /* [s] step that the links were made for; 0: none */
    int *cell, n_cells; /* [-] the cells with a link, each once */
    int *body_of;       /* [-] while links are made: 1 + the body around a
                           cell's centre; else 0 */
    double *hold;       /* [kg/(m^3 s)] sum of the links of a cell */
    double *hold_u;     /* [N/m^3] sum of hold times velocity, 3 a cell */
};

/* n bodies at most, in a mesh of so many cells and a fluid of the density rho
 * [kg/m^3]. */
struct solid_bodies *
solid_bodies_create(int n, int cells, double rho,
                    const struct solid_bodies_options *options);
void solid_bodies_free(struct solid_bodies *b);

/* One more body at rest at x [m]; the density [kg/m^3] is that of a free one.
 * Returns its number. */
int solid_bodies_add(struct solid_bodies *b, const struct body_shape *shape,
                     const double x[3], double density,
                     enum body_motion motion);

/* Body i is held by springs [N/m] where it is now; 0: it cannot move along that
 * axis. */
void solid_bodies_set_spring(struct solid_bodies *b, int i,
                             const double spring[3]);

/* All bodies are there, and hold the fluid from now on, which is borrowed.
 * Non-zero after a message if they cannot touch. */
int solid_bodies_begin(struct solid_bodies *b, struct fluid *fl);

/* Visits what the next step depends on; the links follow from it. */
void solid_bodies_state(struct solid_bodies *b, struct state *s);

#endif
