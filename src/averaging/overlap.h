/* overlap.h -- how much of a sphere is in a box.  Chapter 8.
 *
 * Exact, in closed form. What is common to a ball and a box is a sum over the
 * corners of the box, with alternating signs, of what is common to the ball
 * and an octant that begins at the corner.
 */
#ifndef OVERLAP_H
#define OVERLAP_H

/* Volume [-] of the part x > a, y > b, z > c of the unit ball. */
double overlap_octant(double a, double b, double c);

/* Volume [m^3] of the part of the box lo .. hi [m] that is nearer than R [m]
 * to the origin. The ends of a box may be infinite. */
double overlap_sphere(double R, const double lo[3], const double hi[3]);

/* The same with the cube of edge 2 R around the origin in the place of the
 * sphere [EW18 section 2.4]. */
double overlap_cube(double R, const double lo[3], const double hi[3]);

#endif
