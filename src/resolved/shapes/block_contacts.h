/* block_contacts.h -- bodies that are not all spheres, near to others.
 * Chapter "Resolving the grains". */
#ifndef RESOLVED_SHAPES_BLOCK_CONTACTS_H
#define RESOLVED_SHAPES_BLOCK_CONTACTS_H

#include "resolved/solid_bodies.h"

/* Where balls come near to bodies that are no spheres, and balls
 * of free bodies to walls.
 *
 * A ball is a sphere, one of those that a clump consists of, or a point of a
 * surface, of radius 0. All that is asked of the other body is its distance
 * from the ball's centre and the normal there. What two spheres do to one
 * another, and spheres at walls, is dem's. */

struct body_gap {
    int i, j;    /* [-] the body with the ball; the other, -1: a wall */
    double z;    /* [m] negative: an overlap */
    double R;    /* [m] radius of the ball */
    double R_j;  /* [m] of what it comes near to, HUGE_VAL where that is flat */
    double n[3]; /* [-] from j to the ball */
    double arm_i[3], arm_j[3]; /* [m] from the centres to the place of contact,
                                  on the surface of j */
    double v[3];               /* [m/s] of i there, less that of j */
    double m;                  /* [kg] that resists an impulse along n there */
};

/* What an overlap is compared with [m]: the diameter of the ball, or where the
 * body of a point is narrowest. */
double body_gaps_width(const struct solid_bodies *b, const struct body_gap *g);

/* How deep a ball is in another body by more than a tenth of its radius, where
 * one of the two can move [m], and these two; 0: nowhere. */
double body_gaps_deepest(const struct solid_bodies *b, int pair[2]);

/* Contacts of bodies that are not all spheres.
 *
 * A ball of the radius R whose centre is at the distance s < R
 * from the surface of another body: with n the gradient of s and the overlap R
 * - s,
 *
 *   F = (k (R - s) - eta v_n) n, not below 0     [LS 4.3, 4.4]
 *
 * and friction mu F against the slip [LS 4.8], without a spring of its own. */

/* Changes the velocities of what touches and can move, by the forces of a time
 * dt [s]. Returns the deepest overlap over the diameter of a ball [-]. */
double block_contacts_act(struct solid_bodies *b, double dt);

/* The same by the films in their gaps. */
void block_contacts_film(struct solid_bodies *b, double dt);

#endif
