/* hats.h -- particles on a box of cells, linear between the cells' centres.
 * Chapter "Fewer or other particles".
 *
 * A particle belongs to the eight cells whose centres are around it, more to
 * the nearer ones; in the outer half of a cell at a wall to that cell alone. A
 * cell's share falls linearly to zero at the centres of its neighbours, like a
 * hat. So no field jumps where a particle crosses a face, and an average
 * reaches no farther than the flux through the faces of a cell. Spreading and
 * gathering are adjoint, as in averaging.h.
 */
#ifndef AVERAGING_HATS_H
#define AVERAGING_HATS_H

#include "dem/particles.h"
#include "mesh/mesh.h"

struct hats {
    const struct mesh *mesh; /* borrowed; a box */
    int n;                   /* [-] particles */
    int *cell;               /* [-] 3 a particle: its cell along x, y, z */
    int *next; /* [-] 3: the cell on the side of it, or the same at a wall */
    double *share; /* [-] 3: of the next one */
    double *place; /* [-] 3: in its cell, from 0 to 1 */
    double *sums;  /* of the parts of many particles, 6 a cell and part */
};

struct hats *hats_create(const struct mesh *mesh, int capacity);

/* Finds the particles; all are inside the mesh. */
void hats_find(struct hats *h, const struct particles *ps);

/* As averaging_spread and averaging_gather: m numbers side by side. */
void hats_spread(const struct hats *h, int m, const double *q, double *field);
void hats_gather(const struct hats *h, int m, const double *field, double *q);

/* The same for the halves of the cells, lower and upper along x, y, z: along
 * this direction a particle belongs to the half that it is in, across it to
 * cells as above. Two halves that meet at a face are where the share of one
 * cell falls and that of the other rises. Sums of one number q a particle, and
 * to 3 numbers q a particle what it has of its halves. */
void hats_spread_halves(const struct hats *h, const double *q, double *half);
void hats_add_halves(const struct hats *h, const double *half, double *q);

/* The moments of the particles' velocities, 6 a cell: eps_s, eps_s u, eps_s
 * u.u, and eps_s over the diameter of the grains; q: 6 a particle. And of one
 * cell the mean square of the deviation from u, of one direction [m^2/s^2]. */
enum { HATS_MOMENTS = 6 };
void hats_moments(const struct hats *h, const struct particles *ps, double *q,
                  double *moments);
double hats_temperature(const double *moments);

#endif
