/* cell_of_particle.h -- the cell of each particle, and the particles of each
 * cell.
 * Chapter "Averaging".
 *
 * The particles are sorted by their cell (a counting sort, which keeps their
 * order within a cell), so that a sum of particles into cells is a loop over
 * cells that reads particles: no two threads write to the same cell, and the
 * order of every sum is fixed.
 */
#ifndef AVERAGING_CELL_OF_PARTICLE_H
#define AVERAGING_CELL_OF_PARTICLE_H

#include "mesh/mesh.h"
#include "dem/particles.h"

struct cell_of_particle {
    const struct mesh *mesh;    /* borrowed */
    const struct particles *ps; /* borrowed */
    int n;          /* [-] particles at the last cell_of_particle_find */
    int *cell;      /* [-] cell of each particle */
    double *offset; /* [m] from the cell's centre to the particle, round the
                       period; 3 a particle */
    int *start;     /* [-] n_cells + 1; the particles in cell c are */
    int *particle;  /* [-] particle[start[c]] ..., ascending */
};

struct cell_of_particle *cell_of_particle_create(const struct mesh *mesh,
                                                 const struct particles *ps);

/* Locates the particles. Returns the number of particles outside the mesh (or
 * with a position that is not finite) and reports the first of them on stderr;
 * for these the cell is -1, and the rest of h is unchanged. */
int cell_of_particle_find(struct cell_of_particle *h);

/* The particle-centroid sum [XS11 3.1, SX15 4, 7, 8] of m amounts a particle,
 * field_c = (1 / V_c) sum of the q_i in c; all side by side. */
void cell_of_particle_sum(const struct cell_of_particle *h, int m,
                          const double *q, double *field);

/* Its adjoint: q_i = the value in the cell of i. */
void cell_of_particle_value(const struct cell_of_particle *h, int m,
                            const double *field, double *q);

#endif
