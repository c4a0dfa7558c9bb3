/* overlap.h -- the volume of a sphere in a box.
 * Chapter "Further averaging methods".
 *
 * Exact, in closed form. What is common to a ball and a box is a sum over the
 * corners of the box, with alternating signs, of what is common to the ball
 * and an octant that begins at the corner.
 */
#ifndef AVERAGING_MORE_OVERLAP_H
#define AVERAGING_MORE_OVERLAP_H

/* Volume [-] of the part x > a, y > b, z > c of the unit ball. */
double overlap_octant(double a, double b, double c);

/* Volume [m^3] of the part of the box lo .. hi [m] that is nearer than R [m]
 * to the origin. The ends of a box may be infinite. */
double overlap_sphere(double R, const double lo[3], const double hi[3]);

/* The cells of one mesh of boxes have their corners in common. The volume of
 * the ball in an octant that begins at a corner is computed once here, not for
 * each of the eight cells around it. */
enum { OVERLAP_PLANES = 16 };
struct overlap_grid {
    double R;                            /* [m] */
    int n[3];                            /* [-] planes that cut the ball */
    double plane[3][OVERLAP_PLANES + 1]; /* [-] of R; from 1 on, ascending */
    double octant[OVERLAP_PLANES + 2][OVERLAP_PLANES + 2]
                 [OVERLAP_PLANES + 2]; /* [-] */
};

/* The caller first adds each cell that the ball may overlap, then calls
 * overlap_grid_prepare, and then gets the volume of each cell [m^3].
 * overlap_grid_add returns 0 if there are too many planes. */
void overlap_grid_start(struct overlap_grid *g, double R);
int overlap_grid_add(struct overlap_grid *g, const double lo[3],
                     const double hi[3]);
void overlap_grid_prepare(struct overlap_grid *g);
double overlap_grid_cell(const struct overlap_grid *g, const double lo[3],
                         const double hi[3]);

/* The same with the cube of edge 2 R around the origin in the place of the
 * sphere [EW18 section 2.4]. */
double overlap_cube(double R, const double lo[3], const double hi[3]);

#endif
