/* hosts.h -- which cell each particle is in, and which particles each cell
 * holds.  Chapter 8.
 *
 * The particles are sorted by their host cell (a counting sort, which keeps
 * their order within a cell), so that a sum of particles into cells is a loop
 * over cells that gather: nothing is written by two threads, and the order of
 * every sum is fixed.
 */
#ifndef HOSTS_H
#define HOSTS_H

#include "mesh/mesh.h"
#include "particles/particles.h"

struct hosts {
    const struct mesh *mesh;    /* borrowed */
    const struct particles *ps; /* borrowed */
    int n;                      /* [-] particles at the last hosts_find */
    int *host;                  /* [-] cell of each particle */
    double *offset; /* [m] from the host's centre to the particle, round the
                       period; 3 a particle */
    int *start;     /* [-] n_cells + 1; the particles in cell c are */
    int *member;    /* [-] member[start[c]] ..., ascending */
};

struct hosts *hosts_create(const struct mesh *mesh, const struct particles *ps);
void hosts_free(struct hosts *h);

/* Where the particles are now. Returns how many are outside the mesh (or
 * nowhere: not finite) and names the first of them on stderr; if there are
 * any, host has -1 for them and the rest of h is as it was. */
int hosts_find(struct hosts *h);

/* The particle-centroid sum [XS11 3.1, SX15 4, 7, 8] of m amounts a particle,
 * field_c = (1 / V_c) sum of the q_i in c; all side by side. */
void hosts_sum(const struct hosts *h, int m, const double *q, double *field);

/* Its adjoint: q_i = the value in the host of i. */
void hosts_value(const struct hosts *h, int m, const double *field, double *q);

#endif
