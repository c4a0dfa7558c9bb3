/* weights.h -- weights of particles in the cells around them.
 * Chapter "Averaging".
 *
 *     field_c = (1 / V_c) sum_i w_ic q_i      [XS11 3.2, 3.5a, 3.7, 3.8, 3.12]
 *     q_i = sum_c w_ic field_c                [XS11 3.9, 3.12]
 *
 * A method provides a rule for the weights of one particle, which add up to one
 * [XS11 3.4]; the loops over particles and cells are common to all methods and
 * are in this module. The result does not depend on the number of threads.
 */
#ifndef AVERAGING_KERNEL_WEIGHTS_H
#define AVERAGING_KERNEL_WEIGHTS_H

#include "averaging/averaging.h"
#include "averaging/cell_of_particle.h"
#include "mesh/mesh.h"

/* --- stencil: for each cell, the cells near it.
 *
 * Near means: some point of the cell is closer than b to the centre of the
 * other cell, or to some point of it. The stencils are found once, by a walk
 * from cell to cell that adds up the link vectors, so graded meshes and
 * periodic directions need no special treatment: across a period the same
 * cells occur again, at another distance. A cell can therefore occur more than
 * once in a stencil, as several periodic images.
 *
 * A stencil is stored as differences of cell numbers and of centres. Cells
 * with equal surroundings (on a uniform mesh all but those near the walls)
 * have a common stencil, which reduces the memory a hundredfold and makes the
 * kernel method fast. */

struct stencil {
    int n_shapes;
    int *shape; /* [-] n_cells; which one a cell has */
    int *start; /* [-] n_shapes + 1; the entries of shape s are start[s] ... */
    int *index_offset; /* [-] cell number of the entry less that of the cell */
    double *dx, *dy, *dz; /* [m] from the cell's centre to the entry's */
    int largest;          /* [-] entries of the largest shape */
};

/* Which part of the other cell must be nearer than b: its centre, or any point.
 */
enum stencil_to { STENCIL_TO_CENTRE, STENCIL_TO_CELL };

/* The first entry of each is the cell itself. The extent of a cell that is not
 * a box is that of its bounding box, which may be too large but never too
 * small. */
struct stencil *stencil_create(const struct mesh *m, double b /* [m] */,
                               enum stencil_to to);
void stencil_free(struct stencil *s);

/* Estimate of the memory of a stencil before it is created [byte]; 0 for a box
 * of equal cells, in which nearly all cells have a common stencil. */
double stencil_bytes(const struct mesh *m, double b, enum stencil_to to);

/* Half extents of every cell from its centre [m], 3 a cell; released with
 * free(). */
double *stencil_extents(const struct mesh *m);

/* --- weights -------------------------------------------------------------- */

/* The cells near a cell c: their numbers are c + index_offset[e], and their
 * centres are at (dx[e], dy[e], dz[e]) from that of c. Entry 0 is c itself. */
struct neighbourhood {
    int cell, n;
    const int *index_offset;
    const double *dx, *dy, *dz; /* [m] */
};

/* Weights w [-] of one particle in n cells, as offsets from its own cell. */
struct weight_list {
    int n;
    const int *index_offset;
    const double *w;
};

/* The rule of a method. weigh writes the weights [-] of particle i, whose
 * offset from the centre of its cell is h->offset[3 * i], for all entries and
 * returns 1; or it returns 0, and the whole particle is assigned to its own
 * cell. */
struct weights_rule {
    int (*weigh)(const void *state, int i, const struct neighbourhood *near,
                 double *w);
    void *state;               /* of the method */
    void (*free)(void *state); /* by weights_free */
    /* The weights of particle h->particle[a], for a method that stores them;
     * NULL: weigh is called at every use. */
    struct weight_list (*list)(const void *state, int a);
};

struct weights;

/* reach [m] and to: which cells are near, as above. The cells are
 * borrowed; at most so many fields in a call. */
struct weights *weights_create(const struct cell_of_particle *h, double reach,
                               enum stencil_to to, int fields,
                               struct weights_rule rule);

/* Finds the cells near each anew, for another reach [m]. */
void weights_set_reach(struct weights *s, double reach);

/* That of the rule. */
void *weights_state(const struct weights *s);

/* The cells near cell c. */
struct neighbourhood weights_around(const struct weights *s, int c);

/* Borrowed. */
const struct stencil *weights_stencil(const struct weights *s);

/* Estimate of the memory for the neighbourhoods of all cells before they are
 * found [byte]; d [m] is the largest diameter. The mesh may be an outline. */
double weights_bytes(const struct averaging_method *method,
                     const struct mesh *mesh, double d,
                     const struct averaging_options *o);

/* Spreading, its adjoint, and the release, for the descriptor of a method whose
 * state is a struct weights. Without a list they count the particles that were
 * assigned to their own cell alone. */
void weights_spread(void *weights, int m, const double *q, double *field,
                    struct averaging_report *r);
void weights_gather(void *weights, int m, const double *field, double *q,
                    struct averaging_report *r);
void weights_free(void *weights);

#endif
