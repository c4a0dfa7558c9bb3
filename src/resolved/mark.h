/* mark.h -- which cells a body holds, and with which friction.
 * Chapter "Resolving the grains".
 *
 * With s the distance of a cell's centre from the surface, > 0 outside,
 *
 *   hold = C max(rho/dt, mu/h^2)                              s <= 0
 *   hold = sum over faces of mu |S| max(0, -s_nb) / (|d| V s)     s > 0
 *
 * A velocity u - u_b in proportion to s is linear, and its Laplacian vanishes.
 * The neighbour inside has 0 instead of the negative value that continues it,
 * and hold s is what is missing: the wall is at s = 0 and not at the centre of
 * a cell. The error is of second order, and hold does not contain dt.
 *
 * Where a moving body is nearer than a cell to a wall or to another body, the
 * cells between have two velocities to follow, and the fluid has no way out.
 * So a cell beside a wall, or beside a cell of another body, to which the body
 * can come nearer, is left to the fluid; lubrication (body_motion.h) adds what
 * such a gap of a cell lacks.
 */
#ifndef RESOLVED_MARK_H
#define RESOLVED_MARK_H

#include "mesh/mesh.h"
#include "resolved/solid_bodies.h"

/* C [-]: inside, the fluid moves with the body up to 1/C. */
extern const double mark_friction_inside;

/* Makes the links of all bodies where they are now, for steps of
 * fl->options.dt. Nothing is done if neither the bodies nor the step have
 * changed. */
void mark_bodies(struct solid_bodies *b, const struct fluid *fl);

/* The fluid, which rests, has from the beginning what a body that it moves
 * holds of it: of the velocity of the body and with the momentum rho V U.
 * Otherwise the body would lose this in the first step. */
void mark_start(struct solid_bodies *b, struct fluid *fl);

/* 1 if the gap between body i and body j, or if that is negative a wall with
 * the area S, may change. */
int mark_gap_changes(const struct solid_bodies *b, int i, int j,
                     const double S[3]);

/* Solid fraction of cell c [-], whose centre is at the distance s [m], as of a
 * plane surface. */
double mark_fraction(const struct mesh *m, int c, double s);

#endif
